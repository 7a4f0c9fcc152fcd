#pragma once

#include <vector>

#include "linkwork/linear/block/joint_order.hpp"

namespace linkwork::block {

/// Where most of the work lies on one way from a leaf to a root, as in a row of loops: an order of the same fill whose
/// root is in the middle of the way, so that two threads meet there. Empty where the tree is no such one, or where there
/// is too little work to be shared.
std::vector<int> order_from_both_ends(const Elimination& elimination);

}  // namespace linkwork::block
