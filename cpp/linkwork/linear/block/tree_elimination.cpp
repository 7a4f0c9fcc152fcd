#include "linkwork/linear/block/tree_elimination.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace linkwork::block {
namespace {

constexpr int none = -1;

/// The other body of a joint, or none.
int other_body(const System& system, const ConstraintBlock& block) {
  for (const int index : system.joint_blocks(block.joint))
    if (system.blocks()[index].body != block.body) return system.blocks()[index].body;
  return none;
}

class TreeBuilder {
 public:
  TreeBuilder(const System& system, const PrunedLeaves& pruned, const EliminatedRows& rows, bool for_threads,
              SymbolicFactorization& out)
      : system_(system), pruned_(pruned), rows_(rows), out_(out), slot_(system.body_count(), none) {
    group_children();
    std::vector<int> roots;
    for (int body = 0; body < system.body_count(); ++body)
      if (!pruned.bodies[body] || parent(body) == none) roots.push_back(body);
    for (const int root : roots) visit(root);
    plan(for_threads);
    out_.articulated_inertia_count = slots_;
  }
  std::vector<int> slots() && { return std::move(slot_); }

 private:
  int slot(int body) const { return slot_[body]; }

  int parent(int body) const {
    const int index = pruned_.inboard_block[body];
    if (!pruned_.bodies[body] || index == none) return none;
    return other_body(system_, system_.blocks()[index]);
  }

  void group_children() {
    const int n = system_.body_count();
    child_begin_.assign(n + 1, 0);
    for (int body = 0; body < n; ++body)
      if (const int p = parent(body); p != none) child_begin_[p + 1] += 1;
    std::partial_sum(child_begin_.begin(), child_begin_.end(), child_begin_.begin());
    child_.resize(child_begin_.back());
    std::vector<int> next(child_begin_.begin(), child_begin_.end() - 1);
    for (int body = 0; body < n; ++body)
      if (const int p = parent(body); p != none) child_[next[p]++] = body;
  }

  /// Depth first, children before parents.
  void visit(int root) {
    std::vector<std::pair<int, int>> path = {{root, child_begin_[root]}};
    while (!path.empty()) {
      auto& [body, next] = path.back();
      if (next < child_begin_[body + 1]) {
        const int child = child_[next++];
        path.emplace_back(child, child_begin_[child]);
        continue;
      }
      const int done = body;
      path.pop_back();
      if (pruned_.bodies[done]) append(done);
    }
  }

  void append(int body) {
    TreeStep step{};
    step.body = body;
    step.parent = parent(body);
    step.slot = step.parent_slot = step.scattered = none;
    step.storage = out_.factor_size;
    if (const int index = pruned_.inboard_block[body]; index != none) {
      const ConstraintBlock& block = system_.blocks()[index];
      step.row = block.row;
      step.rows = block.rows;
      step.D_body = block.offset;
      step.turning = rows_.turning(block.joint);
      step.slides = rows_.slides(block.joint);
      for (const int other : system_.joint_blocks(block.joint))
        if (other != index) step.D_parent = system_.blocks()[other].offset;
      if (rows_.next(block.joint) != none) append_rows(block.joint, step);
    }
    out_.factor_size += step_storage(step.rows);
    out_.nonzeros += 21 + step.rows * (step.rows + 1) / 2 + 6 * step.rows;
    const double m = step.rows;
    work_.push_back(91.0 + m * (36.0 + 6.0 * (m + 1.0) + 6.0 * m + 21.0 * 2.0) + m * m * m / 3.0 + 24.0 * m + 72.0);
    out_.flops += work_.back();
    out_.steps.push_back(step);
  }

  /// One by one, those of the joints that are attached included.
  void append_rows(int joint, TreeStep& step) {
    step.scattered = static_cast<int>(out_.step_rows.size());
    rows_.for_blocks_on(step.body, joint, [&](const ConstraintBlock& block) {
      for (int k = 0; k < block.rows; ++k)
        out_.step_rows.push_back({block.offset + velocity_size * k, system_.row_of_zeros(), block.row + k});
    });
    step.rows = static_cast<int>(out_.step_rows.size()) - step.scattered;
    if (step.parent == none) return;
    auto row = out_.step_rows.begin() + step.scattered;
    rows_.for_blocks_on(step.parent, joint, [&](const ConstraintBlock& block) {
      for (int k = 0; k < block.rows; ++k) (row++)->D_parent = block.offset + velocity_size * k;
    });
  }

  /// Branches end on the core in the order of the steps: as if it were one body more, which takes no work.
  void plan(bool for_threads) {
    std::vector<int> step_of(slot_.size(), static_cast<int>(out_.steps.size()));
    for (std::size_t s = 0; s < out_.steps.size(); ++s) step_of[out_.steps[s].body] = static_cast<int>(s);
    EliminationTree tree{.parent = {}, .work = std::move(work_), .keeps = false};
    bool core = false;
    for (const TreeStep& step : out_.steps) {
      tree.parent.push_back(step.parent == none ? none : step_of[step.parent]);
      core = core || (step.parent != none && !pruned_.bodies[step.parent]);
    }
    if (core) {
      tree.parent.push_back(none);
      tree.work.push_back(0.0);
    }
    out_.step_plan = plan_work(tree, for_threads);
    const int count = static_cast<int>(out_.steps.size());
    for (Stage& stage : out_.step_plan.stages)
      for (Task& task : stage) {
        for (NodeRange& range : task.ranges) range.last = std::min(range.last, count);
        place(task);
      }
  }

  /// Articulated inertias: those that the steps of a task no longer need are taken again by later ones.
  void place(const Task& task) {
    free_slots_.clear();
    for (const NodeRange& range : task.ranges)
      for (int s = range.first; s < range.last; ++s) place(out_.steps[s]);
  }

  void place(TreeStep& step) {
    step.slot = slot(step.body);
    if (step.parent != none) {
      step.parent_begins = slot(step.parent) == none;
      if (step.parent_begins) slot_[step.parent] = take_slot();
      step.parent_slot = slot(step.parent);
    }
    if (step.slot != none) free_slots_.push_back(step.slot);
  }

  // The parent's slot is taken before the body's own is given back: the two are read and written in one step.
  int take_slot() {
    if (free_slots_.empty()) return slots_++;
    const int slot = free_slots_.back();
    free_slots_.pop_back();
    return slot;
  }

  const System& system_;
  const PrunedLeaves& pruned_;
  const EliminatedRows& rows_;
  SymbolicFactorization& out_;
  std::vector<int> slot_, free_slots_, child_begin_, child_;
  std::vector<double> work_;  ///< of each step
  int slots_ = 0;
};

}  // namespace

std::vector<int> eliminate_trees(const System& system, const PrunedLeaves& pruned, const EliminatedRows& rows,
                                 bool for_threads, SymbolicFactorization& out) {
  return TreeBuilder(system, pruned, rows, for_threads, out).slots();
}

}  // namespace linkwork::block
