#include "linkwork/assembly/leaf_pruning.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

PrunedLeaves prune(const System& system, std::vector<char> absent = {}) {
  absent.resize(system.joint_count(), 0);
  return prune_leaves(system, absent, [](const ConstraintBlock&) { return true; });
}

}  // namespace

TEST_CASE("a tree is pruned to nothing, each body with the joint on its side of the ground") {
  Random random(3);
  const Model model = random_tree(random, 12);
  const System system(model);
  const PrunedLeaves pruned = prune(system);
  for (int body = 0; body < system.body_count(); ++body) {
    REQUIRE(pruned.bodies[body]);
    REQUIRE(pruned.inboard_block[body] >= 0);
    const ConstraintBlock& block = system.blocks()[pruned.inboard_block[body]];
    CHECK(block.body == body);
    CHECK(block.joint == body);  // random_tree adds joint k with body k
    CHECK(pruned.joints[block.joint]);
  }
}

TEST_CASE("pruning leaves the 2-core: a closed loop stays, what hangs on it goes") {
  const System system(four_bar_with_tail());
  const PrunedLeaves pruned = prune(system);
  CHECK(pruned.bodies == std::vector<char>{0, 0, 0, 1, 1});
  CHECK(pruned.joints == std::vector<char>{0, 0, 0, 0, 1, 1});
  CHECK(system.blocks()[pruned.inboard_block[3]].joint == 4);
  CHECK(system.blocks()[pruned.inboard_block[4]].joint == 5);
  CHECK(pruned.inboard_block[1] == -1);
}

TEST_CASE("a loop with an absent joint is open") {
  const System system(four_bar());
  const PrunedLeaves pruned = prune(system, {0, 0, 1, 0});
  CHECK(pruned.bodies == std::vector<char>{1, 1, 1});
  CHECK(system.blocks()[pruned.inboard_block[1]].joint == 1);  // the coupler hangs on the crank
  CHECK(system.blocks()[pruned.inboard_block[2]].joint == 3);
}

TEST_CASE("a joint that must stay keeps the branch that leads to it") {
  const System system(four_bar_with_tail());
  const auto pruned =
      prune_leaves(system, std::vector<char>(6, 0), [](const ConstraintBlock& block) { return block.joint != 4; });
  CHECK(pruned.bodies == std::vector<char>{0, 0, 0, 0, 1});
  CHECK(pruned.joints == std::vector<char>{0, 0, 0, 0, 0, 1});
}
