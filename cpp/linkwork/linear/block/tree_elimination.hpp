#pragma once

#include <vector>

#include "linkwork/assembly/leaf_pruning.hpp"
#include "linkwork/linear/block/eliminated_rows.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork::block {

/// Fills the steps of the open branches, leaf to root; returns the slot of the articulated inertia of each body that
/// has one at their end (bodies of the core), else -1.
std::vector<int> eliminate_trees(const System& system, const PrunedLeaves& pruned, const EliminatedRows& rows,
                                 bool for_threads, SymbolicFactorization& out);

}  // namespace linkwork::block
