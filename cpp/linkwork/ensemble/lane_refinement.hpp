#pragma once

#include <vector>

#include "linkwork/constraints/refinement.hpp"
#include "linkwork/ensemble/lane_guard.hpp"
#include "linkwork/ensemble/lane_solver.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/aligned.hpp"

namespace linkwork {

class LaneStructure;

/// Refinement of the solutions of several mechanisms at once, each with as many corrections as by itself. Those that
/// would go on with conjugate gradients, or do not converge, leave.
class LaneRefinement {
 public:
  LaneRefinement(const LaneStructure& structure, const LaneKernels& kernels, const std::vector<Dynamics*>& mechanisms);

  /// Another mechanism in a lane.
  void replace(int l, Dynamics& mechanism);
  /// Whether any lane needs it.
  bool needed() const { return needed_; }

  /// M at the time of each lane, see LaneEquations.
  struct Inertia {
    const double *t, *mass, *inertance;
  };
  /// Of x and lambda where nothing else than a, b, M and D decides; `nearby` has factors of nearby equations.
  void refine(const Inertia& inertia, const LaneSolver::Problem& problem, LaneSolver& nearby, LaneGuard& guard);

 private:
  void load(std::size_t l);
  double largest_correction(std::size_t l) const;
  void judge(const double* t, std::vector<Corrections>& corrections, LaneGuard& guard);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  std::vector<Dynamics*> mechanisms_;
  bool needed_ = false;
  std::vector<char> refined_;
  AlignedDoubles lengths_, r_1_, r_2_, dx_, dlambda_, going_on_;
  AlignedDoubles free_motion_, size_, correction_, scratch_;  ///< of each connected component
  AlignedDoubles other_;                                      ///< not zero where the nearby solver has other inertias
};

}  // namespace linkwork
