#include "linkwork/linear/block/elimination_root.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/linear/block/work_plan.hpp"

namespace linkwork::block {
namespace {

constexpr int none = -1;
constexpr double most_in_line = 0.6;  // of the work, on one way from a leaf to a root

// The nodes of a supernode and those below it are a clique of the filled graph, and the elimination tree of the
// supernodes is a tree of these cliques: each node stands in the cliques of a connected part of it, and what two
// neighbors share separates the sides. Whatever clique is taken for the root, the graph can be eliminated towards it
// without further fill (J. R. S. Blair, B. Peyton, An introduction to chordal graphs and clique trees, 1993): a clique
// eliminates what it does not share with its new parent.
class Rerooting {
 public:
  explicit Rerooting(const Elimination& elimination)
      : elimination_(elimination), children_(elimination.supernodes.size()), done_(elimination.order.size(), 0) {
    for (int s = 0; s < count(); ++s)
      if (const int p = parent(s); p != none) children_[p].push_back(s);
    find_line();
  }

  double work() const { return total_; }

  /// With the root down the line, where no more than a part of its work is left below.
  std::vector<int> order(double part) {
    const auto less = [&](int a, int b) { return all_[a] < all_[b]; };
    int to = line_;
    while (to != none && !children_[to].empty()) {
      const int next = *std::max_element(children_[to].begin(), children_[to].end(), less);
      if (all_[next] <= part * all_[line_]) break;
      to = next;
    }
    return to == line_ ? std::vector<int>() : order_with_root(to);
  }

 private:
  std::vector<int> order_with_root(int new_root) {
    std::vector<int> turned;  // the way to the old root, whose edges turn round
    for (int s = new_root; s != none; s = parent(s)) turned.push_back(s);
    const int root = turned.back();
    for (int s = 0; s < count(); ++s)
      if (parent(s) == none && s != root) append_subtree(s);
    for (std::size_t k = turned.size(); k-- > 0;) {
      for (const int child : children_[turned[k]])
        if (k == 0 || child != turned[k - 1]) append_subtree(child);
      append_clique(turned[k], k == 0 ? std::vector<int>() : supernode(turned[k - 1]).below);
    }
    return std::move(order_);
  }

  int count() const { return static_cast<int>(children_.size()); }
  const Supernode& supernode(int s) const { return elimination_.supernodes[s]; }
  int parent(int s) const { return supernode(s).parent; }

  /// The root of the longest way, if most of the work lies on it.
  void find_line() {
    const std::vector<double>& work = elimination_.work;
    std::vector<double> in_line = work;  // of the longest way in a subtree
    all_ = work;
    for (int s = 0; s < count(); ++s) {
      total_ += work[s];
      for (const int child : children_[s]) {
        all_[s] += all_[child];
        in_line[s] = std::max(in_line[s], work[s] + in_line[child]);
      }
      if (parent(s) == none && (line_ == none || in_line[s] > in_line[line_])) line_ = s;
    }
    if (line_ != none && in_line[line_] < most_in_line * total_) line_ = none;
  }

  /// As they stand: a subtree that does not turn.
  void append_subtree(int root) {
    std::vector<std::pair<int, std::size_t>> path = {{root, 0}};
    while (!path.empty()) {
      auto& [s, next] = path.back();
      if (next < children_[s].size()) {
        path.emplace_back(children_[s][next++], 0);
        continue;
      }
      for (int k = supernode(s).first; k < supernode(s).last; ++k) append(k);
      path.pop_back();
    }
  }

  void append_clique(int s, const std::vector<int>& shared) {
    const auto kept = [&](int k) { return std::binary_search(shared.begin(), shared.end(), k); };
    for (int k = supernode(s).first; k < supernode(s).last; ++k)
      if (!kept(k) && !done_[k]) append(k);
    for (const int k : supernode(s).below)
      if (!kept(k) && !done_[k]) append(k);
  }

  void append(int k) {
    done_[k] = 1;
    order_.push_back(elimination_.order[k]);
  }

  const Elimination& elimination_;
  std::vector<std::vector<int>> children_;
  int line_ = none;          ///< the supernode where it ends, a root
  double total_ = 0.0;       ///< work
  std::vector<double> all_;  ///< of each subtree
  std::vector<char> done_;   ///< of each place
  std::vector<int> order_;
};

}  // namespace

std::vector<int> order_from_other_end(const Elimination& elimination) { return Rerooting(elimination).order(0.0); }

std::vector<int> order_from_both_ends(const Elimination& elimination) {
  Rerooting rerooting(elimination);
  return rerooting.work() < worth_sharing ? std::vector<int>() : rerooting.order(0.5);
}

}  // namespace linkwork::block
