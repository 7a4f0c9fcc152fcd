#pragma once

#include "linkwork/linear/block/number_lists.hpp"

namespace linkwork::block {

/// An order of the nodes of a graph (neighbors of each, ascending, without itself; rows of each) in which eliminating
/// them adds few couplings: of minimum degree or by nested dissection, whichever predicts the fewest operations.
/// Postordered: what is eliminated together stands together.
std::vector<int> fill_reducing_order(const NumberLists& graph, const std::vector<int>& weight);

}  // namespace linkwork::block
