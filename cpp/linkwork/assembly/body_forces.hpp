#pragma once

#include "linkwork/math/instruction_set.hpp"

namespace linkwork {

/// Mass matrix of a body, or its inverse: m, then J row by row.
struct MassBlock {
  double m, J[9];
};

/// g = (m gravity, -omega x J omega) of all bodies, 6 each; returns the potential -sum m gravity . r [J].
using BodyForces = double (*)(int count, const MassBlock* mass, const double* gravity, const double* q, const double* v,
                              double* g);
BodyForces body_forces(const InstructionSet& instructions);

}  // namespace linkwork
