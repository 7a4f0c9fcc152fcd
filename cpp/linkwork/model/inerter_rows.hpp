#pragma once

#include "linkwork/model/joint_kind.hpp"

/// The coordinates of inerters as equations of one row, evaluated many at a time as those of joints are; Phi means
/// nothing.
namespace linkwork {

JointKind length_row_joint();
JointKind angle_row_joint();
JointKind displacement_row_joint();

}  // namespace linkwork
