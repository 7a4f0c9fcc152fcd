#include "linkwork/linear/block/joint_order.hpp"

#include <numeric>
#include <set>

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
  for (const int nodes : {1, 2, 10, 60}) {
    if (nodes < 3) continue;
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
  std::vector<int> place(nodes);
  for (int k = 0; k < nodes; ++k) place[found.order[k]] = k;
  Eigen::MatrixXi fill = Eigen::MatrixXi::Zero(nodes, nodes);
  for (std::size_t c = 0; c < graph.cliques.size(); ++c)
    for (const int a : graph.cliques[c])
      for (const int b : graph.cliques[c]) fill(place[a], place[b]) = 1;
  for (int k = 0; k < nodes; ++k)
    for (int a = k + 1; a < nodes; ++a)
      for (int b = k + 1; b < nodes; ++b) fill(a, b) |= fill(a, k) & fill(k, b);
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
