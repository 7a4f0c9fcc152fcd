#pragma once

#include <vector>

#include "linkwork/linear/block/kernels.hpp"

namespace linkwork::block {

/// Ranges of eliminations, one after the other, by one thread.
struct Task {
  std::vector<NodeRange> ranges;
  double work = 0.0;
  double divisible = 0.0;  ///< of which in fronts so large that all threads can work on one
};

/// Of all eliminations [flops], from which on threads pay, some 0.5 ms: a stage costs some 5 us to begin and to end.
constexpr double worth_sharing = 4e6;

using Stage = std::vector<Task>;

/// Who does what, and when: the tasks of a stage depend on those of the stages before it, not on each other.
struct WorkPlan {
  std::vector<Stage> stages;
  bool shared = false;  ///< there is enough work for several threads
  bool is_empty() const { return stages.empty(); }
  bool is_one_task() const { return stages.size() == 1 && stages[0].size() == 1; }
};

/// What is eliminated, in an order where the subtree of each stands right before it, and children of one parent
/// contribute to it in that order.
struct EliminationTree {
  std::vector<int> parent;   ///< a later one, or -1
  std::vector<double> work;  ///< of each [flops]
  /// What is handed to the parent is kept until it is wanted: a task can end before it. Else a last elimination that
  /// contributes to something beyond the task is done by the one that it contributes to.
  bool keeps;
};

/// Subtrees for threads. It depends on the tree alone, so that each sum is made in one order whatever the number of
/// threads: subtrees of at most a 64th of the work first, then the ways from there to the roots, branch by branch.
/// Where the work is too little to be shared, or the order is another one, all of it is one task, and so for one thread:
/// nothing is kept then that can be added at once, and the sums are the same.
WorkPlan plan_work(const EliminationTree& tree, bool for_threads);

}  // namespace linkwork::block
