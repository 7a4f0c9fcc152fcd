#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/linear/block/work_plan.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork::block {

/// The symbolic phase: which body and joint is eliminated when, and where every number stands.
///
/// Open branches go leaf to root, each body with the joint that holds it: no fill, and no cancellation, because
/// inertias only add up on the way. What is left are closed loops, the 2-core of the graph: its bodies first, then its
/// joints in a fill-reducing order of the graph "joints that share a body", gathered into supernodes (multifrontal
/// method, Duff and Reid 1983). Bodies with many joints, hubs, are eliminated among the joints where that takes fewer
/// operations. Others on a hinge or a slider on the ground, grounded ones, are eliminated
/// with it. Joints with compliance go with another one between the same bodies, see EliminatedRows.
struct SymbolicFactorization {
  /// A joint that must not be eliminated before a hub, because it depends on the others while the hub is held. Of
  /// several that are eliminated together the last one counts.
  struct DelayedPivot {
    int joint, hub;  ///< the hub is a body
    void keep(Archive& archive) { archive(joint, hub); }
  };
  /// Without the `dropped` rows of joints in loops; rows from `compliant_from` on have compliance; `for_threads`: in
  /// tasks for several ones; `grounded`: bodies in loops may be eliminated with a hinge or slider on the ground.
  explicit SymbolicFactorization(const System& system, const std::vector<int>& dropped = {},
                                 int compliant_from = std::numeric_limits<int>::max(),
                                 const std::vector<DelayedPivot>& delayed = {}, bool for_threads = false,
                                 bool grounded = true);

  /// The relative pivot from which no elimination should go on: with hubs, there is a better order.
  double breakdown() const;
  /// Whether a body is eliminated with the joint on the ground of a constraint row, which is its first.
  bool grounded_by(int row) const;
  bool grounded() const;  ///< some body
  /// The hub to which the joint of a constraint row can be delayed: the next one to be eliminated that it affects, or
  /// -1.
  int next_hub(int row) const;

  std::vector<TreeStep> steps;
  std::vector<StepRow> step_rows;
  std::vector<Front> fronts;
  WorkPlan step_plan, front_plan;  ///< steps before fronts, on the way back after them
  std::vector<RelativeIndices> relative_indices, runs;
  std::vector<CoreBody> bodies;
  std::vector<RowVector> vectors;
  std::vector<BodyRow> rows;
  std::vector<MixedFront> mixed;
  std::vector<Hub> hubs;
  std::vector<Coupling> couplings;
  std::vector<int> unknowns;
  std::ptrdiff_t factor_size = 0;  ///< doubles of tree factors
  std::ptrdiff_t articulated_inertia_count = 0;
  std::ptrdiff_t panel_size = 0, contribution_size = 0;
  int highest_front = 0, widest_front = 0;  ///< stride and width
  int mass_factor_count = 0;
  double flops = 0.0;         ///< of one factorization
  std::int64_t nonzeros = 0;  ///< of the factors
};

}  // namespace linkwork::block
