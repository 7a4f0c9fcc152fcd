#include "linkwork/linear/block/joint_order.hpp"

#include <cholmod.h>

#include <algorithm>
#include <new>
#include <numeric>

namespace linkwork::block {
namespace {

constexpr int none = -1;

/// Adjacency of the nodes: neighbors[begin[k] .. begin[k+1]), ascending, without k itself.
struct Adjacency {
  std::vector<int> begin, neighbors;
};

/// `name` maps nodes to those of a graph of n nodes, in which several may be one.
Adjacency adjacency_of(const std::vector<std::vector<int>>& cliques, std::size_t n, const std::vector<int>& name) {
  std::vector<std::vector<int>> lists(n);
  for (const std::vector<int>& clique : cliques)
    for (const int first : clique)
      for (const int second : clique) {
        const int a = name[static_cast<std::size_t>(first)], b = name[static_cast<std::size_t>(second)];
        if (a != b) lists[static_cast<std::size_t>(a)].push_back(b);
      }
  Adjacency out;
  out.begin.push_back(0);
  for (std::vector<int>& list : lists) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    out.neighbors.insert(out.neighbors.end(), list.begin(), list.end());
    out.begin.push_back(static_cast<int>(out.neighbors.size()));
    list = {};
  }
  return out;
}

/// CHOLMOD's choice among its orderings, postordered.
std::vector<int> fill_reducing_order(const Adjacency& graph) {
  const std::size_t n = graph.begin.size() - 1;
  std::vector<int> begin = {0}, row;
  for (std::size_t column = 0; column < n; ++column) {  // the upper triangle with its diagonal
    for (int k = graph.begin[column]; k < graph.begin[column + 1]; ++k)
      if (graph.neighbors[static_cast<std::size_t>(k)] < static_cast<int>(column))
        row.push_back(graph.neighbors[static_cast<std::size_t>(k)]);
    row.push_back(static_cast<int>(column));
    begin.push_back(static_cast<int>(row.size()));
  }
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  cholmod_sparse A{};
  A.nrow = A.ncol = n;
  A.nzmax = row.size();
  A.p = begin.data();
  A.i = row.data();
  A.stype = 1;
  A.itype = CHOLMOD_INT;
  A.xtype = CHOLMOD_PATTERN;
  A.sorted = A.packed = 1;
  cholmod_factor* factor = cholmod_analyze(&A, &common);
  if (!factor) throw std::bad_alloc();
  const int* permutation = static_cast<const int*>(factor->Perm);
  std::vector<int> order(permutation, permutation + n);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  return order;
}

/// Structure of each column of the factor (places below it), in the given order.
std::vector<std::vector<int>> column_structures(const Adjacency& graph, const std::vector<int>& order) {
  const std::size_t n = order.size();
  std::vector<int> place(n);
  for (std::size_t k = 0; k < n; ++k) place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  std::vector<std::vector<int>> below(n);
  std::vector<std::vector<int>> children(n);
  std::vector<int> mark(n, none);
  for (std::size_t k = 0; k < n; ++k) {
    mark[k] = static_cast<int>(k);
    const auto add = [&](int p) {
      if (p <= static_cast<int>(k) || mark[static_cast<std::size_t>(p)] == static_cast<int>(k)) return;
      mark[static_cast<std::size_t>(p)] = static_cast<int>(k);
      below[k].push_back(p);
    };
    const auto node = static_cast<std::size_t>(order[k]);
    for (int e = graph.begin[node]; e < graph.begin[node + 1]; ++e)
      add(place[static_cast<std::size_t>(graph.neighbors[static_cast<std::size_t>(e)])]);
    for (const int child : children[k])
      for (const int p : below[static_cast<std::size_t>(child)]) add(p);
    std::sort(below[k].begin(), below[k].end());
    if (!below[k].empty()) children[static_cast<std::size_t>(below[k].front())].push_back(static_cast<int>(k));
  }
  return below;
}

double rows_of(const std::vector<int>& weight_at, int first, int last) {
  return std::accumulate(weight_at.begin() + first, weight_at.begin() + last, 0.0);
}

double rows_of(const std::vector<int>& weight_at, const std::vector<int>& places) {
  double sum = 0.0;
  for (const int p : places) sum += weight_at[static_cast<std::size_t>(p)];
  return sum;
}

/// Operations of a front that eliminates w rows and keeps r, with a fixed cost for handling it.
double cost(double w, double r) {
  constexpr double handling = 1000.0;
  return handling + w * w * w / 3.0 + w * w * r + w * r * r;
}

/// Merges a supernode into its parent where that saves time in spite of the zeros that it adds. Only a child that ends
/// where its parent begins can be merged.
std::vector<Supernode> amalgamate(std::vector<Supernode> nodes, const std::vector<int>& weight_at) {
  std::vector<Supernode> out;
  for (Supernode& node : nodes) {
    while (!out.empty() && out.back().last == node.first && !out.back().below.empty() &&
           out.back().below.front() < node.last) {
      const Supernode& child = out.back();
      const double w_child = rows_of(weight_at, child.first, child.last), w = rows_of(weight_at, node.first, node.last);
      const double r_child = rows_of(weight_at, child.below), r = rows_of(weight_at, node.below);
      if (cost(w_child + w, r) > cost(w_child, r_child) + cost(w, r) + 0.5 * r_child * r_child) break;
      node.first = child.first;
      out.pop_back();
    }
    out.push_back(std::move(node));
  }
  return out;
}

/// An order in which each hub stands before the joints that must follow it: they are one node to the ordering.
std::vector<int> order_nodes(const JointGraph& graph) {
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
    name[k] = name[static_cast<std::size_t>(graph.hub[k])];
    members[static_cast<std::size_t>(name[k])].push_back(static_cast<int>(k));
  }
  std::vector<int> out;
  out.reserve(n);
  for (const int node : fill_reducing_order(adjacency_of(graph.cliques, members.size(), name)))
    for (const int member : members[static_cast<std::size_t>(node)]) out.push_back(member);
  return out;
}

}  // namespace

Elimination order_joint_graph(const JointGraph& graph) {
  const std::size_t n = graph.weight.size();
  std::vector<int> itself(n);
  std::iota(itself.begin(), itself.end(), 0);
  const Adjacency adjacency = adjacency_of(graph.cliques, n, itself);
  Elimination out;
  out.order = order_nodes(graph);
  std::vector<int> weight_at(n);
  for (std::size_t k = 0; k < n; ++k) weight_at[k] = graph.weight[static_cast<std::size_t>(out.order[k])];
  std::vector<std::vector<int>> below = column_structures(adjacency, out.order);

  std::vector<Supernode> nodes;  // fundamental: a column whose structure is that of the column before it, less itself
  for (std::size_t k = 0; k < n; ++k) {
    const bool same = k > 0 && !below[k - 1].empty() && below[k - 1].front() == static_cast<int>(k) &&
                      below[k - 1].size() == below[k].size() + 1;
    if (same) nodes.back().last = static_cast<int>(k) + 1;
    else nodes.push_back({static_cast<int>(k), static_cast<int>(k) + 1, none, {}});
    nodes.back().below = below[k];
  }
  below = {};
  out.supernodes = amalgamate(std::move(nodes), weight_at);
  out.supernode_of.resize(n);
  for (std::size_t s = 0; s < out.supernodes.size(); ++s)
    for (int k = out.supernodes[s].first; k < out.supernodes[s].last; ++k)
      out.supernode_of[static_cast<std::size_t>(k)] = static_cast<int>(s);
  for (Supernode& node : out.supernodes) {
    if (!node.below.empty()) node.parent = out.supernode_of[static_cast<std::size_t>(node.below.front())];
    out.cost += cost(rows_of(weight_at, node.first, node.last), rows_of(weight_at, node.below));
  }
  return out;
}

}  // namespace linkwork::block
