#pragma once

#include "linkwork/math/instruction_set.hpp"

namespace linkwork {

/// What the watches of all lanes look at in every step; layout, instruction sets and bits as of LaneKernels.
/// y = (q, v, work), 13 n + 1 numbers.
struct LaneSpeeds {
  /// The numbers of Speeds, 6 of them. `in_loops`: one a body, not zero where it is in a loop. `rotors`: their axes.
  void (*speeds)(int bodies, const double* in_loops, const double* rotors, const double* y, double* out);
  /// As System::kinetic_energy, without inerters. `mass`: 10 numbers a body.
  void (*kinetic_energy)(int bodies, const double* mass, const double* y, double* out);
  /// As StepSampling: of (y_new - y)/h of velocities, of each `every` body, the numbers of Rates; by how much it is
  /// another one than `rates` (6 a body), which it becomes, and the largest.
  void (*rates)(int bodies, int every, double h, const double* squared_length, const double* y, const double* y_new,
                double* rates, double* out);
};

const LaneSpeeds& lane_speeds(const InstructionSet& instructions);

}  // namespace linkwork
