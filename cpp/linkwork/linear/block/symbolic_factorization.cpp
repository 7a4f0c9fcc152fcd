#include "linkwork/linear/block/symbolic_factorization.hpp"

#include <algorithm>

#include "linkwork/linear/block/core_elimination.hpp"
#include "linkwork/linear/block/tree_elimination.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

CountedRows count_rows(const System& system, const std::vector<int>& dropped) {
  CountedRows out;
  out.dropped.assign(system.row_count(), 0);
  for (const int row : dropped) out.dropped[row] = 1;
  const std::vector<int>& first = system.model().joint_rows();
  const auto begin = out.dropped.begin();
  for (int joint = 0; joint < system.joint_count(); ++joint)
    out.rows_of_joint.push_back(static_cast<int>(std::count(begin + first[joint], begin + first[joint + 1], 0)));
  return out;
}

/// Joints without rows count as absent. A joint of more than two bodies is part of loops, as if it closed one: no open
/// branch ends on it.
PrunedLeaves prune_branches(const System& system, const CountedRows& rows) {
  std::vector<char> absent;
  for (const int count : rows.rows_of_joint) absent.push_back(count == 0);
  const auto joins_two = [&](const ConstraintBlock& block) {
    const BlockRange blocks = system.joint_blocks(block.joint);
    return blocks.end() - blocks.begin() <= 2;
  };
  return prune_leaves(system, std::move(absent), joins_two);
}

}  // namespace

SymbolicFactorization::SymbolicFactorization(const System& system, const std::vector<int>& dropped,
                                             const std::vector<DelayedPivot>& delayed, bool for_threads) {
  look_for_interruption();
  const CountedRows counted = count_rows(system, dropped);
  const PrunedLeaves pruned = prune_branches(system, counted);
  const std::vector<int> slots = eliminate_trees(system, pruned, for_threads, *this);
  eliminate_core(system, pruned, slots, counted, delayed, for_threads, *this);
}

int SymbolicFactorization::next_hub(int row) const {
  const auto eliminates = [&](const Front& front) {
    const auto own = unknowns.begin() + front.unknown;
    return std::find(own, own + front.width, row) != own + front.width;
  };
  const auto found = std::find_if(fronts.begin(), fronts.end(), eliminates);
  if (found == fronts.end()) return -1;
  for (int f = static_cast<int>(found - fronts.begin()); f >= 0; f = fronts[f].parent) {
    const Front& front = fronts[f];
    if (front.mixed < 0) continue;
    const auto first = unknowns.begin() + front.unknown;
    const auto joint = std::find(first, first + front.width, row);
    const MixedFront& it = mixed[front.mixed];
    for (int h = it.first_hub; h < it.first_hub + it.hubs; ++h)
      if (joint == first + front.width || hubs[h].position > joint - first) return hubs[h].body;
  }
  return -1;
}

}  // namespace linkwork::block
