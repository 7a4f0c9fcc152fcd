#pragma once

#include <vector>

#include "linkwork/assembly/leaf_pruning.hpp"
#include "linkwork/linear/block/eliminated_rows.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork::block {

/// Fills the core: fronts of its bodies and of supernodes of joints and hubs. `slot`: see eliminate_trees.
void eliminate_core(const System& system, const PrunedLeaves& pruned, const std::vector<int>& slot,
                    const EliminatedRows& rows, const std::vector<SymbolicFactorization::DelayedPivot>& delayed,
                    bool for_threads, SymbolicFactorization& out);

}  // namespace linkwork::block
