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
    find_middle();
  }

  std::vector<int> order() {
    if (middle_ == none) return {};
    std::vector<int> turned;  // the way from the middle to the old root, whose edges turn round
    for (int s = middle_; s != none; s = parent(s)) turned.push_back(s);
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

 private:
  int count() const { return static_cast<int>(children_.size()); }
  const Supernode& supernode(int s) const { return elimination_.supernodes[s]; }
  int parent(int s) const { return supernode(s).parent; }

  /// The last supernode, from the root of the most work down, that has half of the work below it.
  void find_middle() {
    const std::vector<double>& work = elimination_.work;
    std::vector<double> all = work, in_line = work;  // of the subtree, and on the longest way in it
    double total = 0.0;
    int longest = none;
    for (int s = 0; s < count(); ++s) {
      total += work[s];
      for (const int child : children_[s]) {
        all[s] += all[child];
        in_line[s] = std::max(in_line[s], work[s] + in_line[child]);
      }
      if (parent(s) == none && (longest == none || in_line[s] > in_line[longest])) longest = s;
    }
    if (longest == none || total < worth_sharing || in_line[longest] < most_in_line * total) return;
    const double half = 0.5 * all[longest];
    for (middle_ = longest;;) {
      const auto& below = children_[middle_];
      const auto next = std::find_if(below.begin(), below.end(), [&](int child) { return all[child] > half; });
      if (next == below.end()) break;
      middle_ = *next;
    }
    if (middle_ == longest) middle_ = none;
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
  int middle_ = none;
  std::vector<char> done_;  ///< of each place
  std::vector<int> order_;
};

}  // namespace

std::vector<int> order_from_both_ends(const Elimination& elimination) { return Rerooting(elimination).order(); }

}  // namespace linkwork::block
