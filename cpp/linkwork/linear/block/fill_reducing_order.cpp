#include "linkwork/linear/block/fill_reducing_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

using Numbers = std::vector<int>;

constexpr int none = -1;
constexpr std::size_t leaf = 100;      // nodes of a part that minimum degree orders
constexpr std::size_t large = 1000;    // from which on dissection is tried
constexpr double little = 1000.0;      // operations of a node, as many as handling it: no order saves more
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
  Eigen::SparseMatrix<double, Eigen::ColMajor, int> A(n, n);
  A.reserve(static_cast<Eigen::Index>(graph.numbers().size() + graph.size()));
  for (int node = 0; node < n; ++node) {
    const auto neighbors = graph[node];
    const auto itself = std::ranges::lower_bound(neighbors, node);
    A.startVec(node);
    for (auto it = neighbors.begin(); it != itself; ++it) A.insertBack(*it, node) = 1.0;
    A.insertBack(node, node) = 1.0;  // without it Eigen takes a node for a dense one, and puts it last
    for (auto it = itself; it != neighbors.end(); ++it) A.insertBack(*it, node) = 1.0;
  }
  A.finalize();
  Eigen::AMDOrdering<int>::PermutationType found;
  Eigen::AMDOrdering<int>()(A.selfadjointView<Eigen::Lower>(), found);
  std::copy_n(found.indices().data(), n, order.begin());
  return order;
}

/// Nodes with one neighbor or none, one after the other, each without those before it: what hangs on the rest as trees.
/// Eliminated first they cause no fill, which minimum degree alone does not find: Eigen's counts a node itself among the
/// neighbors of those that it has not met yet.
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

struct Separation {
  Numbers low = {}, between = {}, high = {};
  int rows = std::numeric_limits<int>::max();  ///< between
};

/// Nodes that separate a part of a graph into two sides. Refined by moves of single nodes from the separator to a side,
/// by which their neighbors on the other side enter it: always the move that leaves the fewest rows in it, even if they are
/// more than before, and each node once; then back to the best of all states (C. Ashcraft, J. W. H. Liu, Applications of the
/// Dulmage-Mendelsohn decomposition and network flow to graph bisection improvement, SIAM J. Matrix Anal. Appl. 19,
/// 1998; after C. M. Fiduccia, R. M. Mattheyses, 1982).
class Separator {
 public:
  Separator(const NumberLists& graph, const Numbers& weight, const Numbers& part)
      : graph_(graph), weight_(weight), part_(part), side_(graph.size(), 0), moved_(graph.size(), 0) {}

  /// Begins between the nodes whose value is below the median and the others.
  template <class Value>
  Separation find(const Numbers& nodes, int part, const Value& value) {
    begin(nodes, part, value);
    for (int pass = 0; pass < most_passes && improves(part); ++pass) look_for_interruption();
    Separation out;
    for (const int node : nodes)
      (at(side_, node) < 0 ? out.low : at(side_, node) > 0 ? out.high : out.between).push_back(node);
    if (out.low.empty() || out.high.empty()) return {};
    out.rows = rows(0);
    return out;
  }

 private:
  static constexpr int most_passes = 10;
  static constexpr int most_futile = 60;  // moves after the best state

  struct Move {
    int node, to;
    Numbers entered;
  };

  /// All of the upper nodes that have neighbors among the lower ones.
  template <class Value>
  void begin(const Numbers& nodes, int part, const Value& value) {
    values_.clear();
    for (const int node : nodes) values_.push_back(value(node));
    std::ranges::nth_element(values_, values_.begin() + static_cast<std::ptrdiff_t>(values_.size() / 2));
    const int median = values_[values_.size() / 2];
    rows_[0] = rows_[1] = rows_[2] = 0;
    separator_.clear();
    for (const int node : nodes) at(side_, node) = value(node) < median ? -1 : 1;
    for (const int node : nodes) {
      const bool beside = at(side_, node) > 0 && std::ranges::any_of(graph_[node], [&](int neighbor) {
                            return at(part_, neighbor) == part && at(side_, neighbor) < 0;
                          });
      if (beside) separator_.push_back(node);
    }
    for (const int node : separator_) at(side_, node) = 0;
    for (const int node : nodes) rows(at(side_, node)) += at(weight_, node);
  }

  int& rows(int side) { return rows_[side + 1]; }

  /// Of the neighbors on the other side, which would enter the separator.
  int rows_that_enter(int node, int to, int part) const {
    int sum = 0;
    for (const int neighbor : graph_[node])
      if (at(part_, neighbor) == part && at(side_, neighbor) == -to) sum += at(weight_, neighbor);
    return sum;
  }

  bool improves(int part) {
    ++stamp_;
    const int before = rows(0), all = rows_[0] + rows_[1] + rows_[2];
    int least = before;
    std::vector<Move> moves;
    std::size_t best = 0;
    while (moves.size() < best + most_futile) {
      int node = none, to = 0, most = 0;
      for (const int candidate : separator_) {
        if (at(moved_, candidate) == stamp_) continue;
        for (const int side : {-1, 1}) {
          if (10 * (rows(side) + at(weight_, candidate)) > 6 * all) continue;  // too much on one side
          const int gain = at(weight_, candidate) - rows_that_enter(candidate, side, part);
          if (node != none && (gain < most || (gain == most && rows(side) >= rows(to)))) continue;
          node = candidate;
          to = side;
          most = gain;
        }
      }
      if (node == none) break;
      moves.push_back(move(node, to, part));
      if (rows(0) >= least) continue;
      least = rows(0);
      best = moves.size();
    }
    for (; moves.size() > best; moves.pop_back()) take_back(moves.back());
    return least < before;
  }

  void put(int node, int side) {
    rows(at(side_, node)) -= at(weight_, node);
    rows(side) += at(weight_, node);
    at(side_, node) = side;
  }

  Move move(int node, int to, int part) {
    Move out{node, to, {}};
    at(moved_, node) = stamp_;
    put(node, to);
    std::erase(separator_, node);
    for (const int neighbor : graph_[node])
      if (at(part_, neighbor) == part && at(side_, neighbor) == -to) {
        put(neighbor, 0);
        separator_.push_back(neighbor);
        out.entered.push_back(neighbor);
      }
    return out;
  }

  void take_back(const Move& move) {
    for (const int node : move.entered) {
      put(node, -move.to);
      std::erase(separator_, node);
    }
    put(move.node, 0);
    separator_.push_back(move.node);
  }

  const NumberLists& graph_;
  const Numbers &weight_, &part_;
  Numbers side_, moved_;  ///< of each node; in which pass it was moved last
  Numbers separator_, values_;
  int rows_[3] = {};  ///< on the sides and, in the middle, in the separator
  int stamp_ = 0;
};

/// Nested dissection: what separates two parts of about the same size is eliminated after them, and these are dissected
/// likewise (A. George, Nested dissection of a regular finite element mesh, SIAM J. Numer. Anal. 10, 1973). Where to cut
/// is found by levels of breadth-first searches from nodes far out.
class Dissection {
 public:
  Dissection(const NumberLists& graph, const Numbers& weight)
      : graph_(graph), part_(graph.size(), 0), level_(graph.size(), none), separator_(graph, weight, part_) {}

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
    const Numbers found = search(part, part.nodes.front());
    if (found.size() < part.nodes.size()) return separate(part, found);
    Separation best;
    for (const auto& value : ways_across(part, found.back()))
      if (Separation other = separator_.find(part.nodes, part.name, value); other.rows < best.rows)
        best = std::move(other);
    if (best.low.empty()) return append_leaf(part);
    order_.insert(order_.end(), best.between.begin(), best.between.end());
    for (const int node : best.between) at(part_, node) = none;
    push(std::move(best.low));
    push(std::move(best.high));
  }

  /// Numbers of nodes that rise from one end of the part to another: distances from the ends of its longest way, and how
  /// much nearer each of them is than a third end. Of a rectangular sheet these are its corners, from each of which levels
  /// run across it aslant; the differences rise along its edges.
  std::vector<std::function<int(int)>> ways_across(const Part& part, int from) {
    const int first = search(part, from).back();
    const int second = search(part, first).back();
    from_first_ = level_;
    search(part, second);
    from_second_ = level_;
    const auto off = [&](int node) { return std::min(at(from_first_, node), at(from_second_, node)); };
    const int third = *std::ranges::max_element(part.nodes, {}, off);
    search(part, third);
    return {[this](int node) { return at(from_first_, node); }, [this](int node) { return at(from_second_, node); },
            [this](int node) { return at(from_first_, node) - at(level_, node); },
            [this](int node) { return at(from_second_, node) - at(level_, node); }};
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
  Numbers part_, level_;                   ///< of each node
  Numbers from_first_, from_second_ = {};  ///< levels from there
  Separator separator_;
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
  if (graph.size() >= large) consider(Dissection(graph, weight).run());
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
