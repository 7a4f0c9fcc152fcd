#pragma once

#include "linkwork/math/instruction_set.hpp"
#include "linkwork/model/batch.hpp"

namespace linkwork {

/// D^T lambda of joints of one kind, of so many rows, on their second body: force and torque about the joint's point on
/// that body in inertial axes, 3 numbers at the place of each joint's number. Of kinds that hold a point, whose rows
/// have the form that joint_kind.hpp says, D is read only where it is of rotation.
using JointReactions = void (*)(const JointArrays&, int rows, bool holds_point, const double* D, const double* q,
                                const double* lambda, double* force, double* torque);
JointReactions joint_reactions(const InstructionSet& instructions);

}  // namespace linkwork
