#include "linkwork/linear/block/work_plan.hpp"

#include <map>
#include <set>
#include <utility>

#include "support.hpp"

using namespace support;
using linkwork::block::EliminationTree;
using linkwork::block::Handing;
using linkwork::block::plan_work;
using linkwork::block::Task;
using linkwork::block::WorkPlan;

namespace {

constexpr double step = 1000.0;  // flops

/// A tree in postorder: every node below `parent_of` a later one.
EliminationTree random_tree_of(Random& random, int count, int most_children, bool keeps) {
  EliminationTree out{.parent = std::vector<int>(count, -1), .work = std::vector<double>(count, step), .keeps = keeps};
  std::vector<int> roots;
  for (int k = 0; k < count; ++k) {
    for (int take = random.integer(0, most_children); take > 0 && !roots.empty(); --take) {
      out.parent[roots.back()] = k;
      roots.pop_back();
    }
    out.work[k] = random.number(0.5, 1.5) * step;
    roots.push_back(k);
  }
  return out;
}

/// As a plan does them: what each node has got when it is done, and when (stage, task) each is done and handed over.
struct Done {
  std::map<int, std::pair<std::size_t, std::size_t>> at, handed;
  std::map<int, std::vector<int>> got;  ///< children that a parent got, in order
  bool once = true, complete = true;
};

Done carry_out(const EliminationTree& tree, const WorkPlan& plan) {
  std::vector<std::vector<int>> children(tree.parent.size());
  for (std::size_t k = 0; k < tree.parent.size(); ++k)
    if (tree.parent[k] >= 0) children[tree.parent[k]].push_back(static_cast<int>(k));
  Done out;
  for (std::size_t s = 0; s < plan.stages.size(); ++s)
    for (std::size_t t = 0; t < plan.stages[s].size(); ++t)
      for (const block::NodeRange& range : plan.stages[s][t].ranges)
        for (int k = range.first; k < range.last; ++k) {
          if (range.handing != Handing::only) {
            out.once = out.once && out.at.emplace(k, std::pair{s, t}).second;
            out.complete = out.complete && out.got[k] == children[k];
          }
          if (range.handing == Handing::later || tree.parent[k] < 0) continue;
          out.once = out.once && out.handed.emplace(k, std::pair{s, t}).second;
          out.got[tree.parent[k]].push_back(k);
        }
  return out;
}

}  // namespace

TEST_CASE("every node is done once, after its children, which its parent gets in their order from one task") {
  Random random(11);
  for (const bool keeps : {false, true})
    for (const int most_children : {1, 2, 3, 8})
      for (int repeat = 0; repeat < 5; ++repeat) {
        CAPTURE(keeps);
        CAPTURE(most_children);
        const EliminationTree tree = random_tree_of(random, 20000, most_children, keeps);
        const WorkPlan plan = plan_work(tree, true);
        CHECK(plan.shared);
        const Done done = carry_out(tree, plan);
        CHECK(done.once);
        CHECK(done.complete);
        CHECK(done.at.size() == tree.parent.size());
        for (const auto& [k, place] : done.handed) {
          const auto of_parent = done.at.at(tree.parent[k]);
          // what is written in one stage by two tasks is of two parents
          CHECK(place.first <= of_parent.first);
          for (const int other : done.got.at(tree.parent[k]))
            if (done.handed.at(other).first == place.first) CHECK(done.handed.at(other) == place);
          if (done.at.at(k).first == place.first) CHECK(done.at.at(k).second == place.second);
        }
      }
}

TEST_CASE("the work of a balanced tree is shared by many, and that of a little one by nobody") {
  EliminationTree tree{.parent = {}, .work = {}, .keeps = true};
  const int leaves = 4096;  // a binary tree by recursion, children right before their parent
  const auto build = [&](const auto& self, int size) -> int {
    if (size == 1) {
      tree.parent.push_back(-1);
    } else {
      const int left = self(self, size / 2), right = self(self, size / 2);
      tree.parent.push_back(-1);
      tree.parent[left] = tree.parent[right] = static_cast<int>(tree.parent.size()) - 1;
    }
    return static_cast<int>(tree.parent.size()) - 1;
  };
  build(build, leaves);
  tree.work.assign(tree.parent.size(), step);
  const WorkPlan plan = plan_work(tree, true);
  double most = 0.0, all = 0.0;
  for (const Task& task : plan.stages.front()) {
    most = std::max(most, task.work);
    all += task.work;
  }
  CHECK(most <= step * static_cast<double>(tree.parent.size()) / 32.0);
  CHECK(all >= 0.95 * step * static_cast<double>(tree.parent.size()));
  REQUIRE(plan_work(tree, false).stages.size() == 1);
  CHECK(plan_work(tree, false).stages.front().size() == 1);
  tree.work.assign(tree.parent.size(), 0.01 * step);
  CHECK(!plan_work(tree, true).shared);
  CHECK(plan_work(tree, true).stages.size() == 1);
}

TEST_CASE("an order that is not depth first is one task") {
  const EliminationTree tree{.parent = {2, 3, 4, 4, -1}, .work = std::vector<double>(5, 1e6), .keeps = true};
  const WorkPlan plan = plan_work(tree, true);
  REQUIRE(plan.stages.size() == 1);
  REQUIRE(plan.stages[0].size() == 1);
  CHECK(plan.stages[0][0].ranges.size() == 1);
}
