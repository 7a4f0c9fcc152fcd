#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// A state of a run and its accelerations.
struct MovingState {
  double t = 0.0;     ///< [s]
  VectorXd y, v_dot;  ///< y = (q, v, work), and what v changes by
};

/// Velocities between two states, h apart, on the way that is cubic in positions and rotations and has the velocities of
/// both ends. Euler parameters may have either sign.
class CubicVelocities {
 public:
  CubicVelocities(const System& system, const ConstVector& begin, const ConstVector& end, double h);
  /// At this share of the way (6n,).
  VectorXd at(double share) const { return first_ + share * (change_ + (1.0 - share) * bend_); }

 private:
  VectorXd first_, change_, bend_;
};

/// Between two states at this share of the way: of the fifth degree in positions and Euler parameters, as velocities and
/// accelerations at both ends have it. Euler parameters are to have the same sign at both.
VectorXd quintic_between(const System& system, const MovingState& begin, const MovingState& end, double share);

}  // namespace linkwork
