#pragma once

#include <vector>

#include "linkwork/linear/block/joint_order.hpp"

namespace linkwork::block {

// Where most of the work lies on one way from a leaf to a root, as in a row of loops, the root may stand elsewhere on it
// without further fill. These orders are empty where the tree is no such one.

/// With the root where the leaf is.
std::vector<int> order_from_other_end(const Elimination& elimination);

/// With the root in the middle, so that two threads meet there. Empty, too, where there is too little work to be shared.
std::vector<int> order_from_both_ends(const Elimination& elimination);

}  // namespace linkwork::block
