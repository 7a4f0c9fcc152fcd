#include "linkwork/linear/block/fill_reducing_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

using Numbers = std::vector<int>;

constexpr int none = -1;
constexpr std::size_t leaf = 100;      // nodes of a part that minimum degree orders
constexpr std::size_t large = 1000;    // from which on dissection is tried
constexpr double little = 1000.0;       // operations of a node, as many as handling it: no order saves more
constexpr std::size_t most_bits = 64;  // up to so many nodes their rows are counted

template <class Container>
auto& at(Container& container, int k) {
  return container[k];
}

Numbers minimum_degree(const NumberLists& graph) {
  Numbers order(graph.size());
  std::iota(order.begin(), order.end(), 0);
  if (graph.numbers().empty()) return order;  // which AMD does not take
  const int n = static_cast<int>(graph.size());
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(graph.numbers().size() + graph.size());
  for (int node = 0; node < n; ++node) {
    entries.emplace_back(node, node, 1.0);  // without it Eigen takes a node for a dense one, and puts it last
    for (const int neighbor : graph[node]) entries.emplace_back(neighbor, node, 1.0);
  }
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType found;
  Eigen::AMDOrdering<int>()(A.selfadjointView<Eigen::Lower>(), found);
  std::copy_n(found.indices().data(), n, order.begin());
  return order;
}

/// Nodes with one neighbor or none, one after the other, each without those before it: what hangs on the rest as trees.
/// Eliminated first they cause no fill, which minimum degree alone does not find: Eigen's counts a node itself among the neighbors
/// of those that it has not met yet.
Numbers hanging(const NumberLists& graph) {
  const int n = static_cast<int>(graph.size());
  Numbers degree(graph.size()), order;
  std::vector<char> gone(graph.size(), 0);
  for (int node = 0; node < n; ++node) at(degree, node) = static_cast<int>(graph[node].size());
  for (int first = 0; first < n; ++first)
    for (int node = first; node != none && !at(gone, node) && at(degree, node) <= 1;) {
      at(gone, node) = 1;
      order.push_back(node);
      int next = none;
      for (const int neighbor : graph[node])
        if (!at(gone, neighbor)) {
          --at(degree, neighbor);
          next = neighbor;
        }
      node = next;
    }
  return order;
}

/// Without some nodes, and how the others are called in the whole.
std::pair<NumberLists, Numbers> without(const NumberLists& graph, const Numbers& nodes) {
  const int n = static_cast<int>(graph.size());
  Numbers number(graph.size(), 0), names, list;
  for (const int node : nodes) at(number, node) = none;
  for (int node = 0; node < n; ++node)
    if (at(number, node) != none) {
      at(number, node) = static_cast<int>(names.size());
      names.push_back(node);
    }
  NumberLists rest;
  for (const int node : names) {
    list.clear();
    for (const int neighbor : graph[node])
      if (at(number, neighbor) != none) list.push_back(at(number, neighbor));
    rest.add(list);
  }
  return {std::move(rest), std::move(names)};
}

/// Nested dissection by levels of a breadth-first search from a node far out (A. George, J. W. H. Liu, Computer
/// Solution of Large Sparse Positive Definite Systems, 1981): the level in the middle separates the others, which are
/// dissected likewise and stand before it.
class Dissection {
 public:
  explicit Dissection(const NumberLists& graph) : graph_(graph), part_(graph.size(), 0), level_(graph.size(), none) {}

  Numbers run() {
    Numbers all(graph_.size());
    std::iota(all.begin(), all.end(), 0);
    stack_.push_back({std::move(all), 0});
    while (!stack_.empty()) {
      look_for_interruption();
      Part part = std::move(stack_.back());
      stack_.pop_back();
      dissect(std::move(part));
    }
    std::reverse(order_.begin(), order_.end());
    return std::move(order_);
  }

 private:
  struct Part {
    Numbers nodes;
    int name;
  };

  /// The last come first in order_, which is reversed in the end.
  void dissect(Part part) {
    if (part.nodes.size() <= leaf) return append_leaf(part);
    const int far = search(part, part.nodes.front()).back();
    const Numbers found = search(part, search(part, far).back());
    if (found.size() < part.nodes.size()) return separate(part, found);
    const int middle = at(level_, found[found.size() / 2]);
    Numbers low, separator, high;
    for (const int node : found)
      (at(level_, node) < middle ? low : at(level_, node) > middle ? high : separator).push_back(node);
    if (low.empty() || high.empty()) return append_leaf(part);
    order_.insert(order_.end(), separator.begin(), separator.end());
    for (const int node : separator) at(part_, node) = none;
    push(std::move(low));
    push(std::move(high));
  }

  /// A part that is not connected: what was found, and the rest.
  void separate(const Part& part, const Numbers& found) {
    Numbers rest;
    for (const int node : part.nodes)
      if (at(level_, node) == none) rest.push_back(node);
    push(found);
    push(std::move(rest));
  }

  void push(Numbers nodes) {
    const int name = ++parts_;
    for (const int node : nodes) at(part_, node) = name;
    stack_.push_back({std::move(nodes), name});
  }

  /// Nodes of the part in the order in which they are reached, with their levels.
  Numbers search(const Part& part, int from) {
    for (const int node : part.nodes) at(level_, node) = none;
    Numbers queue = {from};
    at(level_, from) = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const int neighbor : graph_[queue[next]])
        if (at(part_, neighbor) == part.name && at(level_, neighbor) == none) {
          at(level_, neighbor) = at(level_, queue[next]) + 1;
          queue.push_back(neighbor);
        }
    return queue;
  }

  void append_leaf(const Part& part) {
    NumberLists own;
    Numbers& number = level_;  // no longer needed for these
    for (std::size_t k = 0; k < part.nodes.size(); ++k) at(number, part.nodes[k]) = static_cast<int>(k);
    Numbers list;
    for (const int node : part.nodes) {
      list.clear();
      for (const int neighbor : graph_[node])
        if (at(part_, neighbor) == part.name) list.push_back(at(number, neighbor));
      std::sort(list.begin(), list.end());
      own.add(list);
    }
    const Numbers order = minimum_degree(own);
    for (auto it = order.rbegin(); it != order.rend(); ++it) order_.push_back(at(part.nodes, *it));
  }

  const NumberLists& graph_;
  Numbers part_, level_;  ///< of each node
  int parts_ = 0;
  std::vector<Part> stack_;
  Numbers order_;
};

/// Parents in the elimination tree, by place in an order (J. W. H. Liu, The role of elimination trees in sparse
/// factorization, SIAM J. Matrix Anal. Appl. 11, 1990).
Numbers elimination_tree(const NumberLists& graph, const Numbers& order) {
  const auto n = static_cast<int>(order.size());
  Numbers place(order.size()), parent(order.size(), none), ancestor(order.size(), none);
  for (int k = 0; k < n; ++k) at(place, at(order, k)) = k;
  for (int k = 0; k < n; ++k)
    for (const int neighbor : graph[at(order, k)])
      for (int p = at(place, neighbor), next; p < k && p != none; p = next) {
        next = at(ancestor, p);
        at(ancestor, p) = k;
        if (next == none) at(parent, p) = k;
        if (next == k) break;
      }
  return parent;
}

/// Of a factorization in that order, with the rows below each column: row k of the factor is the ways from its neighbors
/// up to k.
double operations(const NumberLists& graph, const Numbers& weight, const Numbers& order) {
  const auto n = static_cast<int>(order.size());
  const Numbers parent = elimination_tree(graph, order);
  Numbers place(order.size()), mark(order.size(), none);
  std::vector<double> below(order.size(), 0.0);
  for (int k = 0; k < n; ++k) at(place, at(order, k)) = k;
  for (int k = 0; k < n; ++k) {
    at(mark, k) = k;
    for (const int neighbor : graph[at(order, k)])
      for (int p = at(place, neighbor); p < k && at(mark, p) != k; p = at(parent, p)) {
        at(mark, p) = k;
        at(below, p) += at(weight, at(order, k));
      }
  }
  double sum = 0.0;
  for (int k = 0; k < n; ++k) {
    const double w = at(weight, at(order, k)), r = at(below, k);
    sum += w * w * w / 3.0 + w * r * (w + r);
  }
  return sum;
}

/// Children before their parents, and next to them.
Numbers postordered(const Numbers& order, const Numbers& parent) {
  const auto n = static_cast<int>(order.size());
  Numbers first(order.size(), none), sibling(order.size(), none), out, stack;
  for (int k = n; k-- > 0;)
    if (const int p = at(parent, k); p != none) {
      at(sibling, k) = at(first, p);
      at(first, p) = k;
    }
  out.reserve(order.size());
  for (int root = 0; root < n; ++root) {
    if (at(parent, root) != none) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int k = stack.back();
      if (const int child = at(first, k); child != none) {
        at(first, k) = at(sibling, child);
        stack.push_back(child);
      } else {
        out.push_back(at(order, k));
        stack.pop_back();
      }
    }
  }
  return out;
}

NumberLists renumbered_backward(const NumberLists& graph) {
  const auto n = static_cast<int>(graph.size());
  NumberLists out;
  Numbers list;
  for (int node = n; node-- > 0;) {
    const auto neighbors = graph[node];
    list.clear();
    for (auto it = neighbors.rbegin(); it != neighbors.rend(); ++it) list.push_back(n - 1 - *it);
    out.add(list);
  }
  return out;
}

/// Of a small graph: next is always the node that is coupled to the fewest rows by then.
Numbers fewest_rows(const NumberLists& graph, const Numbers& weight) {
  const int n = static_cast<int>(graph.size());
  std::vector<std::uint64_t> coupled(graph.size(), 0);
  for (int node = 0; node < n; ++node)
    for (const int neighbor : graph[node]) at(coupled, node) |= std::uint64_t{1} << neighbor;
  const auto rows = [&](std::uint64_t nodes) {
    int sum = 0;
    for (; nodes != 0; nodes &= nodes - 1) sum += at(weight, std::countr_zero(nodes));
    return sum;
  };
  Numbers order;
  std::uint64_t left = n == 0 ? 0 : ~std::uint64_t{0} >> (most_bits - graph.size());
  while (left != 0) {
    int next = none, least = 0;
    for (int node = 0; node < n; ++node)
      if (left >> node & 1)
        if (const int below = rows(at(coupled, node)); next == none || below < least) {
          next = node;
          least = below;
        }
    const std::uint64_t itself = std::uint64_t{1} << next;
    left &= ~itself;
    for (int node = 0; node < n; ++node)
      if (at(coupled, next) >> node & 1)
        at(coupled, node) = (at(coupled, node) | at(coupled, next)) & ~itself & ~(std::uint64_t{1} << node);
    order.push_back(next);
  }
  return order;
}

/// The best of a few orders of what has no trees on it. Minimum degree breaks ties by the numbers of the nodes, often: a
/// second one has them backward.
Numbers order_of_rest(const NumberLists& graph, const Numbers& weight) {
  Numbers best = minimum_degree(graph);
  double least = operations(graph, weight, best);
  const auto consider = [&](Numbers order) {
    const double found = operations(graph, weight, order);
    if (!(found < least)) return;
    least = found;
    best = std::move(order);
  };
  if (graph.size() <= most_bits) consider(fewest_rows(graph, weight));
  else if (least <= little * static_cast<double>(graph.size())) return best;
  Numbers backward = minimum_degree(renumbered_backward(graph));
  for (int& node : backward) node = static_cast<int>(graph.size()) - 1 - node;
  consider(std::move(backward));
  if (graph.size() >= large) consider(Dissection(graph).run());
  return best;
}

}  // namespace

std::vector<int> fill_reducing_order(const NumberLists& graph, const std::vector<int>& weight) {
  Numbers order = hanging(graph), weight_of_rest;
  const auto [rest, names] = without(graph, order);
  for (const int node : names) weight_of_rest.push_back(at(weight, node));
  for (const int node : order_of_rest(rest, weight_of_rest)) order.push_back(at(names, node));
  return postordered(order, elimination_tree(graph, order));
}

}  // namespace linkwork::block
