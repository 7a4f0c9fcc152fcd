#pragma once

#include "linkwork/model/joint_kind.hpp"

namespace linkwork {

/// Coordinates between two bodies that force elements lie along: the distance of two points, the angle of x_j against x_i
/// about z_i, the shift of the point of j along z_i.
enum class CoordinateKind { length, angle, displacement };

/// Such coordinates as equations of one row, evaluated many at a time as those of joints are: Phi is the coordinate, an
/// angle in (-pi, pi]. Where it is not `valued`, Phi of an angle means nothing.
JointKind coordinate_rows(CoordinateKind kind, bool valued);

}  // namespace linkwork
