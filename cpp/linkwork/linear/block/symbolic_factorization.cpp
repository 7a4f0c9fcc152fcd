#include "linkwork/linear/block/symbolic_factorization.hpp"

#include <algorithm>

#include "linkwork/linear/block/core_elimination.hpp"
#include "linkwork/linear/block/tree_elimination.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

constexpr double singular_pivot = 1e-15;
constexpr double small_pivot = 1e-8;  // beyond it the pivot of a joint is delayed to a hub

/// Joints without rows count as absent, and so do those that go with another one. A joint of more than two bodies is
/// part of loops, as if it closed one: no open branch ends on it.
PrunedLeaves prune_branches(const System& system, const EliminatedRows& rows) {
  std::vector<char> absent;
  for (int joint = 0; joint < system.joint_count(); ++joint) absent.push_back(rows.count(joint) == 0);
  const auto joins_two = [&](const ConstraintBlock& block) {
    const BlockRange blocks = system.joint_blocks(block.joint);
    return blocks.end() - blocks.begin() <= 2;
  };
  return prune_leaves(system, std::move(absent), joins_two);
}

}  // namespace

SymbolicFactorization::SymbolicFactorization(const System& system, const std::vector<int>& dropped, int compliant_from,
                                             const std::vector<DelayedPivot>& delayed, bool for_threads,
                                             bool grounded) {
  look_for_interruption();
  const EliminatedRows eliminated(system, dropped, compliant_from);
  const PrunedLeaves pruned = prune_branches(system, eliminated);
  const std::vector<int> slots = eliminate_trees(system, pruned, eliminated, for_threads, *this);
  eliminate_core(system, pruned, slots, eliminated, delayed, {.for_threads = for_threads, .grounded = grounded}, *this);
}

double SymbolicFactorization::breakdown() const { return hubs.empty() ? singular_pivot : small_pivot; }

bool SymbolicFactorization::grounded_by(int row) const {
  return row >= 0 &&
         std::any_of(bodies.begin(), bodies.end(), [&](const CoreBody& it) { return it.ground_row == row; });
}

bool SymbolicFactorization::grounded() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const CoreBody& it) { return it.grounded(); });
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
