#pragma once

#include <vector>

#include "linkwork/assembly/leaf_pruning.hpp"
#include "linkwork/linear/block/eliminated_rows.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork::block {

struct CoreOptions {
  bool for_threads;  ///< in tasks for several ones
  bool grounded;     ///< bodies may be eliminated with a hinge or slider that holds them on the ground
};

/// Fills the core: fronts of its bodies and of supernodes of joints and hubs. `slot`: see eliminate_trees.
void eliminate_core(const System& system, const PrunedLeaves& pruned, const std::vector<int>& slot,
                    const EliminatedRows& rows, const std::vector<SymbolicFactorization::DelayedPivot>& delayed,
                    const CoreOptions& options, SymbolicFactorization& out);

}  // namespace linkwork::block
