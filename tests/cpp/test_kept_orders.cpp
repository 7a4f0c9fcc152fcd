#include "linkwork/linear/block/kept_orders.hpp"

#include "linkwork/constraints/rank.hpp"
#include "linkwork/linear/block/block_solver.hpp"
#include "mechanisms.hpp"
#include "support.hpp"

using namespace support;
using namespace linkwork::block;

namespace {

/// A row of nodes, each coupled to the next.
JointGraph row_of_nodes(int nodes) {
  JointGraph graph;
  graph.weight.assign(nodes, 5);
  graph.hub.assign(nodes, -1);
  for (int k = 0; k + 1 < nodes; ++k) graph.cliques.add(std::vector<int>{k, k + 1});
  return graph;
}

bool same(const Elimination& a, const Elimination& b) {
  bool equal = a.order == b.order && a.supernode_of == b.supernode_of && a.work == b.work && a.cost == b.cost &&
               a.supernodes.size() == b.supernodes.size();
  for (std::size_t s = 0; equal && s < a.supernodes.size(); ++s)
    equal = a.supernodes[s].first == b.supernodes[s].first && a.supernodes[s].last == b.supernodes[s].last &&
            a.supernodes[s].parent == b.supernodes[s].parent && a.supernodes[s].below == b.supernodes[s].below;
  return equal;
}

}  // namespace

TEST_CASE("an order is found once for the same graph, however its cliques are written") {
  KeptOrders orders;
  const JointGraph graph = row_of_nodes(20);
  JointGraph written_otherwise = graph;
  written_otherwise.cliques = {};
  for (std::size_t k = graph.cliques.size(); k-- > 0;)
    for (int twice = 0; twice < 2; ++twice)
      written_otherwise.cliques.add(std::vector<int>{graph.cliques[k][1], graph.cliques[k][0]});
  const auto found = orders.order(graph);
  CHECK(orders.order(graph) == found);
  CHECK(orders.order(written_otherwise) == found);
  CHECK(same(*found, order_joint_graph(written_otherwise)));
}

TEST_CASE("a graph with another coupling, weight, hub or number of nodes has an order of its own") {
  KeptOrders orders;
  const JointGraph graph = row_of_nodes(20);
  const auto found = orders.order(graph);
  std::vector<JointGraph> others(4, graph);
  others[0].cliques.add(std::vector<int>{0, 19});
  others[1].weight[7] = 4;
  others[2].hub[8] = 7;
  others[3] = row_of_nodes(21);
  for (const JointGraph& other : others) {
    const auto own = orders.order(other);
    CHECK(own != found);
    CHECK(same(*own, order_joint_graph(other)));
  }
}

TEST_CASE("few orders are kept, and those that are in use stay whole") {
  KeptOrders orders;
  const JointGraph graph = row_of_nodes(20);
  const auto found = orders.order(graph);
  const std::vector<int> order = found->order;
  const std::weak_ptr<const Elimination> second = orders.order(row_of_nodes(21));
  for (int more = 2; more <= static_cast<int>(KeptOrders::most); ++more) {
    orders.order(graph);
    orders.order(row_of_nodes(20 + more));
  }
  CHECK(second.expired());
  CHECK(orders.order(graph) == found);
  orders.forget();
  CHECK(orders.order(graph) != found);
  CHECK(found->order == order);
}

TEST_CASE("systems with the same joints share orders, others do not") {
  const System one(parallelogram(0.3)), with_other_masses(parallelogram(0.3)), other(parallelogram(0.4));
  share_orders(one, with_other_masses);
  CHECK(&kept_orders(one) == &kept_orders(with_other_masses));
  CHECK(&kept_orders(one) != &kept_orders(other));
}

TEST_CASE("solutions do not depend on what was ordered before them") {
  const Model model = parallelogram(0.3);
  const System fresh(model), used(model);
  examine_rank(used);
  const Evaluation at = evaluate_initially(fresh);
  const std::vector<int> dropped = examine_rank(System(model)).redundant_rows;
  const auto solution = [&](const System& system) {
    const auto solver = make_block_solver();
    solver->drop(dropped);
    solver->analyze(system, at);
    VectorXd e = VectorXd::Zero(system.row_count()), x(system.v_size()), lambda(system.row_count());
    for (const int row : dropped) e[row] = 1.0;
    solver->factorize_and_solve(at, e, at.g.head(system.v_size()), at.gamma, x, lambda);
    return VectorXd((VectorXd(x.size() + lambda.size()) << x, lambda).finished());
  };
  CHECK(solution(fresh) == solution(used));
}

TEST_CASE("an analysis of a small system is found once for the same blocks and rows that are left out") {
  const System one(parallelogram(0.3)), with_other_masses(parallelogram(0.3));
  share_orders(one, with_other_masses);
  const std::vector<int> dropped = examine_rank(one).redundant_rows;
  const auto analysis = [&](const System& system, const std::vector<int>& rows, bool grounded) {
    return kept_orders(system).analysis(system, rows, system.row_count(), grounded);
  };
  const auto found = analysis(one, dropped, true);
  CHECK(analysis(with_other_masses, dropped, true) == found);
  CHECK(analysis(one, {}, true) != found);
  CHECK(analysis(one, dropped, false) != found);
  CHECK(analysis(one, dropped, true) == found);
  kept_orders(one).forget();
  CHECK(analysis(one, dropped, true) != found);
}
