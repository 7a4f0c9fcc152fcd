#include "linkwork/linear/block/elimination_root.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "filled_graph.hpp"
#include "linkwork/linear/block/work_plan.hpp"
#include "support.hpp"

using namespace support;
using namespace linkwork::block;

namespace {

/// Joints of 5 rows in a row, each coupled to the next two, with a tail of three on some.
JointGraph row_of_loops(Random& random, int joints) {
  JointGraph graph;
  int last[2] = {0, 1};
  graph.weight = {5, 5};
  const auto add = [&](int to) {
    graph.weight.push_back(5);
    const int own = static_cast<int>(graph.weight.size()) - 1;
    graph.cliques.add({{to, own}});
    return own;
  };
  for (int k = 2; k < joints; ++k) {
    const int next = add(last[1]);
    graph.cliques.add({{last[0], last[1], next}});
    last[0] = std::exchange(last[1], next);
    if (random.number() > 0.9) add(add(add(next)));
  }
  graph.hub.assign(graph.weight.size(), -1);
  return graph;
}

/// Work on the longest way from a leaf to a root, relative to all of it.
double longest_way(const Elimination& elimination) {
  std::vector<double> way = elimination.work;
  double longest = 0.0;
  for (std::size_t s = 0; s < way.size(); ++s) {
    longest = std::max(longest, way[s]);
    if (const int p = elimination.supernodes[s].parent; p >= 0) way[p] = std::max(way[p], elimination.work[p] + way[s]);
  }
  return longest / elimination.cost;
}

}  // namespace

TEST_CASE("a row of loops is eliminated from its other end within the same entries") {
  Random random(8);
  const JointGraph graph = row_of_loops(random, 60);
  const Elimination found = order_joint_graph(graph);
  const std::vector<int> order = order_from_other_end(found);
  const int n = static_cast<int>(graph.weight.size());
  REQUIRE(static_cast<int>(order.size()) == n);
  std::vector<int> place(n, -1), place_before(n);
  for (int k = 0; k < n; ++k) place[order[k]] = k;
  for (int k = 0; k < n; ++k) place_before[found.order[k]] = k;
  CHECK(std::count(place.begin(), place.end(), -1) == 0);
  CHECK(place_before[order.front()] > n / 2);
  Eigen::MatrixXi allowed = Eigen::MatrixXi::Zero(n, n);
  for (const Supernode& node : found.supernodes) {
    std::vector<int> clique = node.below;
    for (int k = node.first; k < node.last; ++k) clique.push_back(k);
    for (const int a : clique)
      for (const int b : clique) allowed(place[found.order[a]], place[found.order[b]]) = 1;
  }
  CHECK(((filled(graph, order) - allowed).array() <= 0).all());
}

TEST_CASE("a long row of loops is eliminated from both ends, with no more work, every joint once") {
  Random random(7);
  const JointGraph graph = row_of_loops(random, 4000);
  const Elimination found = order_joint_graph(graph);
  CHECK(found.cost > worth_sharing);
  CHECK(longest_way(found) < 0.55);
  std::vector<int> sorted = found.order, all(graph.weight.size());
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  CHECK(sorted == all);
  CHECK(order_from_both_ends(found).empty());  // it is no longer one way
}

TEST_CASE("what is turned round has little more than the entries of a band of two joints") {
  Random random(8);
  const JointGraph graph = row_of_loops(random, 4000);
  double entries = 0.0;
  for (const Supernode& node : order_joint_graph(graph).supernodes) {
    const double w = 5.0 * (node.last - node.first), r = 5.0 * static_cast<double>(node.below.size());
    entries += w * (w + 1) / 2 + w * r;
  }
  CHECK(entries < 1.3 * (15.0 + 50.0) * static_cast<double>(graph.weight.size()));
}

TEST_CASE("little work keeps its order") {
  Random random(9);
  CHECK(order_from_both_ends(order_joint_graph(row_of_loops(random, 50))).empty());
}
