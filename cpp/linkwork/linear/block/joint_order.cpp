#include "linkwork/linear/block/joint_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "linkwork/linear/block/elimination_root.hpp"
#include "linkwork/linear/block/fill_reducing_order.hpp"

namespace linkwork::block {
namespace {

constexpr int none = -1;
constexpr double most_lost = 2000.0;      // operations by a merger that another one may win back
constexpr double entry_of_a_front = 8.0;  // operations in whose time it is cleared and added to that of the parent

/// Neighbors of the nodes, ascending, without the nodes themselves. `name` maps them to those of a graph of n nodes, in
/// which several may be one.
NumberLists adjacency_of(const NumberLists& cliques, std::size_t n, const std::vector<int>& name) {
  std::vector<std::size_t> next(n + 1, 0);  // of each node: where its list ends so far
  for (std::size_t k = 0; k < cliques.size(); ++k)
    for (const int node : cliques[k]) next[(name[node]) + 1] += cliques[k].size();
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> neighbors(next.back());
  const std::vector<std::size_t> begin = next;
  for (std::size_t k = 0; k < cliques.size(); ++k)
    for (const int first : cliques[k])
      for (const int second : cliques[k]) {
        const int a = name[first], b = name[second];
        if (a != b) neighbors[next[a]++] = b;
      }
  NumberLists out;
  out.reserve(n, neighbors.size());
  for (std::size_t node = 0; node < n; ++node) {
    const std::span<int> list(neighbors.data() + begin[node], next[node] - begin[node]);
    std::sort(list.begin(), list.end());
    out.add({list.begin(), std::unique(list.begin(), list.end())});
  }
  return out;
}

/// Structure of each column of the factor (places below it), in the given order.
NumberLists column_structures(const NumberLists& graph, const std::vector<int>& order) {
  const std::size_t n = order.size();
  std::vector<int> place(n), mark(n, none), column;
  std::vector<int> child(n, none), sibling(n, none);  // of the elimination tree: the last child, and the one before
  for (std::size_t k = 0; k < n; ++k) place[order[k]] = static_cast<int>(k);
  NumberLists below;
  below.reserve(n, graph.numbers().size());
  for (std::size_t k = 0; k < n; ++k) {
    column.clear();
    const auto add = [&](int p) {
      if (p <= static_cast<int>(k) || mark[p] == static_cast<int>(k)) return;
      mark[p] = static_cast<int>(k);
      column.push_back(p);
    };
    for (const int neighbor : graph[order[k]]) add(place[neighbor]);
    for (int c = child[k]; c != none; c = sibling[c])
      for (const int p : below[c]) add(p);
    std::sort(column.begin(), column.end());
    below.add(column);
    if (!column.empty()) sibling[k] = std::exchange(child[column.front()], static_cast<int>(k));
  }
  return below;
}

/// Rows of nodes, by their places.
class Rows {
 public:
  explicit Rows(const std::vector<int>& weight_at) : weight_at_(weight_at), before_(weight_at.size() + 1, 0.0) {
    std::partial_sum(weight_at.begin(), weight_at.end(), before_.begin() + 1);
  }
  double of(int first, int last) const { return before_[last] - before_[first]; }
  double of(const std::vector<int>& places) const {
    double sum = 0.0;
    for (const int p : places) sum += weight_at_[p];
    return sum;
  }

 private:
  const std::vector<int>& weight_at_;
  std::vector<double> before_;
};

/// Operations of a front that eliminates w rows and keeps r, with a fixed cost for handling it, and one for columns
/// beyond those that are eliminated at once.
double cost(double w, double r) {
  constexpr double handling = 1000.0, more_columns = 400.0, columns_at_once = 8.0;
  return handling + more_columns * std::floor((w - 1.0) / columns_at_once) + w * w * w / 3.0 + w * w * r + w * r * r;
}

/// Supernodes that stand side by side are merged where that saves time in spite of the zeros that it adds: of all ways
/// to cut the order in groups, each with the parents of its members but of the last, the one of the least cost.
std::vector<Supernode> amalgamate(std::vector<Supernode> nodes, const Rows& rows) {
  const std::size_t n = nodes.size();
  std::vector<double> least(n + 1, 0.0);  // cost of the nodes before each
  std::vector<std::size_t> begin(n);      // of the group that ends with each
  for (std::size_t end = 0; end < n; ++end) {
    const double below = rows.of(nodes[end].below), assembly = entry_of_a_front * 0.5 * below * below;
    least[end + 1] = INFINITY;
    for (std::size_t first = end + 1; first-- > 0;) {
      const bool leads_out =
          first < end && (nodes[first].below.empty() || nodes[first].below.front() >= nodes[end].last);
      const double merged = cost(rows.of(nodes[first].first, nodes[end].last), below) + assembly;
      if (leads_out || (first < end && merged > least[end + 1] - least[first] + most_lost)) break;
      if (least[first] + merged >= least[end + 1]) continue;
      least[end + 1] = least[first] + merged;
      begin[end] = first;
    }
  }
  std::vector<Supernode> out;
  for (std::size_t end = n; end > 0; end = begin[end - 1]) {
    out.push_back(std::move(nodes[end - 1]));
    out.back().first = nodes[begin[end - 1]].first;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

/// An order in which each hub stands before the joints that must follow it: they are one node to the ordering.
std::vector<int> order_with_hubs(const JointGraph& graph) {
  const std::size_t n = graph.weight.size();
  std::vector<int> name(n);
  std::vector<std::vector<int>> members;
  for (std::size_t k = 0; k < n; ++k) {
    if (graph.hub[k] != none) continue;
    name[k] = static_cast<int>(members.size());
    members.push_back({static_cast<int>(k)});
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (graph.hub[k] == none) continue;
    name[k] = name[graph.hub[k]];
    members[name[k]].push_back(static_cast<int>(k));
  }
  std::vector<int> out, weight(members.size(), 0);
  for (std::size_t k = 0; k < n; ++k) weight[name[k]] += graph.weight[k];
  out.reserve(n);
  for (const int node : fill_reducing_order(adjacency_of(graph.cliques, members.size(), name), weight))
    for (const int member : members[node]) out.push_back(member);
  return out;
}

/// Fundamental ones: a column whose structure is that of the column before it, less itself.
std::vector<Supernode> supernodes_of(const NumberLists& below) {
  std::vector<Supernode> nodes;
  for (std::size_t k = 0; k < below.size(); ++k) {
    const auto column = below[k], before = below[k > 0 ? k - 1 : 0];
    const bool same = k > 0 && before.size() == column.size() + 1 && before.front() == static_cast<int>(k);
    if (same) nodes.back().last = static_cast<int>(k) + 1;
    else nodes.push_back({static_cast<int>(k), static_cast<int>(k) + 1, none, {}});
  }
  for (Supernode& node : nodes) {
    const auto column = below[node.last - 1];
    node.below.assign(column.begin(), column.end());
  }
  return nodes;
}

Elimination eliminate(const NumberLists& adjacency, const std::vector<int>& weight, std::vector<int> order) {
  const std::size_t n = order.size();
  Elimination out;
  out.order = std::move(order);
  std::vector<int> weight_at(n);
  for (std::size_t k = 0; k < n; ++k) weight_at[k] = weight[out.order[k]];
  const Rows rows(weight_at);
  out.supernodes = amalgamate(supernodes_of(column_structures(adjacency, out.order)), rows);
  out.supernode_of.resize(n);
  for (std::size_t s = 0; s < out.supernodes.size(); ++s)
    for (int k = out.supernodes[s].first; k < out.supernodes[s].last; ++k) out.supernode_of[k] = static_cast<int>(s);
  for (Supernode& node : out.supernodes) {
    if (!node.below.empty()) node.parent = out.supernode_of[node.below.front()];
    out.work.push_back(cost(rows.of(node.first, node.last), rows.of(node.below)));
    out.cost += out.work.back();
  }
  return out;
}

}  // namespace

NumberLists neighbors_in(const JointGraph& graph) {
  std::vector<int> itself(graph.weight.size());
  std::iota(itself.begin(), itself.end(), 0);
  return adjacency_of(graph.cliques, itself.size(), itself);
}

Elimination order_joint_graph(const JointGraph& graph) { return order_joint_graph(graph, neighbors_in(graph)); }

Elimination order_joint_graph(const JointGraph& graph, const NumberLists& adjacency) {
  constexpr double little_less = 0.99, little_more = 1.01;
  if (std::any_of(graph.hub.begin(), graph.hub.end(), [](int hub) { return hub != none; }))
    return eliminate(adjacency, graph.weight, order_with_hubs(graph));
  Elimination out = eliminate(adjacency, graph.weight, fill_reducing_order(adjacency, graph.weight));
  const auto consider = [&](std::vector<int> order, double cost) {
    if (order.empty()) return;
    if (Elimination other = eliminate(adjacency, graph.weight, std::move(order)); other.cost <= cost)
      out = std::move(other);
  };
  if (std::vector<int> order = order_from_other_end(out); !order.empty()) {
    const bool ascends = order.front() < out.order.front();  // as data lie in memory
    consider(std::move(order), (ascends ? little_more : little_less) * out.cost);
  }
  consider(order_from_both_ends(out), little_more * out.cost);
  return out;
}

}  // namespace linkwork::block
