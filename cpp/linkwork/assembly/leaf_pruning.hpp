#pragma once

#include <algorithm>
#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// What pruning took off the graph of bodies and joints.
struct PrunedLeaves {
  std::vector<char> bodies, joints;  ///< whether each is pruned, or was absent
  std::vector<int> inboard_block;    ///< per body: the block of D of the joint it was pruned with, or -1
};

/// Prunes leaves, bodies on which at most one joint is left, with that joint, until none can go: open branches outside
/// in. What remains are closed loops, the 2-core of the graph. `absent`: joints that do not count, one flag for each;
/// `prunable(block)`: whether the joint of a block of D can go with the body of that block.
template <class Prunable>
PrunedLeaves prune_leaves(const System& system, std::vector<char> absent, Prunable prunable) {
  PrunedLeaves out{.bodies = std::vector<char>(system.body_count(), 0),
                   .joints = std::move(absent),
                   .inboard_block = std::vector<int>(system.body_count(), -1)};
  const auto gone = [&](int index) { return out.joints[system.blocks()[index].joint] != 0; };
  const auto stays = [&](int index) { return !gone(index) && !prunable(system.blocks()[index]); };
  std::vector<int> joints_left(system.body_count(), 0), leaves;
  for (int body = 0; body < system.body_count(); ++body) {
    for (const int index : system.body_blocks(body)) joints_left[body] += !gone(index);
    if (joints_left[body] <= 1) leaves.push_back(body);
  }
  while (!leaves.empty()) {
    const int body = leaves.back();
    leaves.pop_back();
    const BlockRange own = system.body_blocks(body);
    if (out.bodies[body] || std::any_of(own.begin(), own.end(), stays)) continue;
    out.bodies[body] = 1;
    for (const int index : own) {
      if (gone(index)) continue;
      const int joint = system.blocks()[index].joint;
      out.joints[joint] = 1;
      out.inboard_block[body] = index;
      for (const int other : system.joint_blocks(joint)) {
        const int neighbor = system.blocks()[other].body;
        if (neighbor != body && --joints_left[neighbor] <= 1) leaves.push_back(neighbor);
      }
    }
  }
  return out;
}

}  // namespace linkwork
