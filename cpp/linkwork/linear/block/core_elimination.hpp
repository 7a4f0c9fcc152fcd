#pragma once

#include <vector>

#include "linkwork/assembly/leaf_pruning.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork::block {

/// Rows that the factorization leaves out, and how many of each joint are left.
struct CountedRows {
  std::vector<char> dropped;       ///< per constraint row
  std::vector<int> rows_of_joint;  ///< without the dropped ones
};

/// Fills the core: fronts of its bodies and of supernodes of joints and hubs. `slot`: see eliminate_trees.
void eliminate_core(const System& system, const PrunedLeaves& pruned, const std::vector<int>& slot,
                    const CountedRows& rows, const std::vector<SymbolicFactorization::DelayedPivot>& delayed,
                    bool for_threads, SymbolicFactorization& out);

}  // namespace linkwork::block
