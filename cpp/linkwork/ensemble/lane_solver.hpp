#pragma once

#include <vector>

#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/aligned.hpp"

namespace linkwork {

/// Solves M x - D^T lambda = a, D x = b of the mechanisms in lanes, each as the block solver does: with other inertias
/// nearby where some are none or nearly so, with corrections of its own where masses are far apart. Without joints and
/// inerters x is M^-1 a.
class LaneSolver {
 public:
  LaneSolver(const LaneStructure& structure, const InstructionSet& instructions);

  /// Whether there is anything to factorize, and a pivot.
  bool factorizes() const { return structure_.connected(); }
  /// A mechanism in a lane; of lanes that are not used, any.
  void load(int l, const Dynamics& mechanism);

  /// All numbers of all lanes; the b of redundant rows and of inerters is zero.
  struct Problem {
    const double *D, *a, *b;
    double *x, *lambda;
  };
  void factorize_and_solve(const Problem& problem);
  /// With the factors of the last factorization, of the same D.
  void solve(const Problem& problem);
  const AlignedDoubles& smallest_pivots() const { return smallest_; }  ///< one of each lane

 private:
  void size(AlignedDoubles& numbers, std::ptrdiff_t count) const;
  void load_inverse_mass(int l, const System& system);
  void leave_out(double* lambda) const;
  LaneData data(const double* D);
  void refine(const Problem& problem);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  const LaneElimination& elimination_;
  AlignedDoubles inverse_mass_;  ///< where bodies are not connected
  AlignedDoubles mass_, mass_factors_, ballast_, compliance_, smallest_;
  AlignedDoubles factors_, articulated_inertias_, panels_, contributions_, scratch_;
  std::vector<char> far_apart_;
  AlignedDoubles going_on_, largest_, correction_, r_1_, r_2_, dx_, dlambda_;
};

}  // namespace linkwork
