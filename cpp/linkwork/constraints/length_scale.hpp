#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// A length for each body [m], the same for bodies that joints connect: the longest way from one of their centers of
/// mass to a joint. Where all joints are at the centers, the longest way between the two points of a joint, or between
/// bodies; then a radius of gyration; 1 where there is nothing that has a length. Kept with the system.
const VectorXd& characteristic_lengths(const System& system);

/// Keeps those of a system with another one of the same bodies and joints.
void keep_lengths(const System& from, const System& with);

/// Velocities of natural size, 6 per body: the body's length for a translation against 1 for a rotation. Masses do not
/// count: rank is a fact of geometry.
VectorXd velocity_scale(const System& system);

/// Length of each row of D in velocities of natural size. What divides a residual of Phi [m or 1] by it is the way that
/// satisfies the row, relative to the size of the mechanism; of Phi_dot, likewise, [1/s]. A row of rotations, of
/// natural size 1, that has (almost) no length in this pose counts with a part of that.
VectorXd row_lengths(const System& system, const Evaluation& at);

/// True for rows that have no translations at an evaluation and are none of a special joint, which has factors of its
/// own: they have natural size 1 and may vanish in a pose.
std::vector<char> rows_of_rotations(const System& system, const Evaluation& at);

/// Largest distance of a body from the origin, relative to its length.
double farthest_position(const System& system, const ConstVector& q);

/// What the roundoff of positions far from the origin does to residuals, relative to the size of the mechanism.
double roundoff_of_positions(const System& system, const ConstVector& q);
/// The same of each connected part.
VectorXd roundoff_of_parts(const System& system, const ConstVector& q);

/// A rate of each connected part [1/s]: of its velocities and drivers at a whole evaluation, and what its forces and
/// torques would give it on a way of its own length. What moves beside it, however fast, says nothing of it.
VectorXd characteristic_rates(const System& system, const Evaluation& at, const ConstVector& v);

}  // namespace linkwork
