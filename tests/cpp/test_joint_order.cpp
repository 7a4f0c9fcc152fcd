#include "linkwork/linear/block/joint_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "filled_graph.hpp"
#include "support.hpp"

using namespace support;
using namespace linkwork::block;

namespace {

/// Cliques of a few nodes at random.
JointGraph random_graph(Random& random, int nodes) {
  JointGraph graph;
  for (int k = 0; k < nodes; ++k) graph.weight.push_back(random.integer(1, 6));
  graph.hub.assign(nodes, -1);
  for (int k = 0; k < nodes; ++k) {
    std::set<int> clique = {k};
    while (clique.size() < 3) clique.insert(random.integer(0, nodes - 1));
    graph.cliques.add(std::vector<int>(clique.begin(), clique.end()));
  }
  return graph;
}

}  // namespace

TEST_CASE("an order of joints is a permutation, cut into supernodes whose parents come after them") {
  Random random(71);
  for (const int nodes : {3, 10, 60}) {
    const Elimination found = order_joint_graph(random_graph(random, nodes));
    std::vector<int> order = found.order, all(nodes);
    std::sort(order.begin(), order.end());
    std::iota(all.begin(), all.end(), 0);
    CHECK(order == all);
    int next = 0;
    for (std::size_t s = 0; s < found.supernodes.size(); ++s) {
      const Supernode& node = found.supernodes[s];
      CHECK(node.first == next);
      next = node.last;
      for (int place = node.first; place < node.last; ++place) CHECK(found.supernode_of[place] == static_cast<int>(s));
      CHECK((node.parent < 0) == node.below.empty());
      if (node.parent >= 0) CHECK(node.parent == found.supernode_of[node.below.front()]);
      CHECK(std::is_sorted(node.below.begin(), node.below.end()));
      if (!node.below.empty()) CHECK(node.below.front() >= node.last);
    }
    CHECK(next == nodes);
  }
}

TEST_CASE("the structure of the factor is that of a dense elimination, or more where supernodes were merged") {
  Random random(72);
  const int nodes = 40;
  const JointGraph graph = random_graph(random, nodes);
  const Elimination found = order_joint_graph(graph);
  const Eigen::MatrixXi fill = filled(graph, found.order);
  for (const Supernode& node : found.supernodes)
    for (int k = node.first; k < node.last; ++k)
      for (int row = node.last; row < nodes; ++row)
        if (fill(row, k)) CHECK(std::binary_search(node.below.begin(), node.below.end(), row));
}

TEST_CASE("joints that must follow a hub stand right after it or after others that do") {
  JointGraph graph;  // node 3 is a hub of joints 0 to 2
  graph.weight = {5, 5, 5, 6};
  graph.hub = {3, 3, 3, -1};
  for (const int joint : {0, 1, 2}) graph.cliques.add(std::vector<int>{3, joint});
  CHECK(order_joint_graph(graph).order.front() == 3);
}

TEST_CASE("of all ways to cut an order in supernodes, that of the fewest operations is taken") {
  Random random(73);
  for (int trial = 0; trial < 20; ++trial) {
    const int nodes = 11;
    const JointGraph graph = random_graph(random, nodes);
    const Elimination found = order_joint_graph(graph);
    const Eigen::MatrixXi fill = filled(graph, found.order);
    const auto weight_at = [&](int place) { return static_cast<double>(graph.weight[found.order[place]]); };
    const auto cost = [&](int first, int last) {  // of places first .. last as one; infinite if a part leads beyond it
      for (int k = first; k < last; ++k)
        if (fill.col(k).segment(k + 1, last - k).sum() == 0) return INFINITY + 0.0;
      double w = 0.0, r = 0.0;
      for (int k = first; k <= last; ++k) w += weight_at(k);
      for (int k = last + 1; k < nodes; ++k) r += fill(k, last) * weight_at(k);
      return 1000.0 + 400.0 * std::floor((w - 1.0) / 8.0) + w * w * w / 3.0 + w * r * (w + r) + 4.0 * r * r;
    };
    double least = INFINITY;
    for (unsigned cuts = 0; cuts < 1u << (nodes - 1); ++cuts) {
      double sum = 0.0;
      for (int first = 0, k = 0; k < nodes; ++k)
        if (k == nodes - 1 || (cuts >> k & 1)) {
          sum += cost(first, k);
          first = k + 1;
        }
      least = std::min(least, sum);
    }
    double own = 0.0;
    for (const Supernode& node : found.supernodes) own += cost(node.first, node.last - 1);
    CHECK(own <= 1.0001 * least);
  }
}
