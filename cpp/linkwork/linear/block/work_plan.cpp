#include "linkwork/linear/block/work_plan.hpp"

#include <algorithm>
#include <numeric>

namespace linkwork::block {
namespace {

constexpr int none = -1;
constexpr double parts = 64.0;       // of all work
constexpr double too_little = 20e3;  // for a task of its own: stays with its parent, in whose cache it is

class Planner {
 public:
  explicit Planner(const EliminationTree& tree)
      : tree_(tree), n_(static_cast<int>(tree.parent.size())), below_(tree.work), first_(tree.parent.size()) {}

  WorkPlan plan(bool for_threads) {
    if (n_ == 0) return {};
    const double total = std::accumulate(tree_.work.begin(), tree_.work.end(), 0.0);
    const bool shared = total >= worth_sharing;
    if (!shared || !for_threads || !add_up_subtrees())
      return {.stages = {{{.ranges = {{0, n_, Handing::over}}, .work = total}}}, .shared = shared};
    most_ = total / parts;
    find_branches();
    hand_out();
    return {.stages = stages(), .shared = true};
  }

 private:
  bool heavy(int k) const { return below_[k] > most_; }
  int parent(int k) const { return tree_.parent[k]; }

  /// False where a subtree does not stand right before its root.
  bool add_up_subtrees() {
    std::vector<int> size(n_, 1);
    for (int k = 0; k < n_; ++k) {
      first_[k] = k - size[k] + 1;
      if (parent(k) == none) continue;
      if (parent(k) <= k) return false;
      below_[parent(k)] += below_[k];
      size[parent(k)] += size[k];
    }
    for (int k = 0; k < n_; ++k)
      if (parent(k) != none && first_[k] < first_[parent(k)]) return false;
    return true;
  }

  /// Heavy nodes one above the other, without another heavy child on the way, are a branch: one task. A branch is done
  /// in the stage after those that end on it.
  void find_branches() {
    std::vector<int> heavy_children(n_, 0);
    for (int k = 0; k < n_; ++k)
      if (heavy(k) && parent(k) != none) heavy_children[parent(k)] += 1;
    task_.assign(n_, none);
    for (int k = n_; k-- > 0;)
      if (heavy(k)) task_[k] = parent(k) == none || heavy_children[parent(k)] > 1 ? new_task(1) : task_[parent(k)];
    for (int k = 0; k < n_; ++k)
      if (heavy(k) && parent(k) != none && task_[k] != task_[parent(k)])
        stage_[task_[parent(k)]] = std::max(stage_[task_[parent(k)]], stage_[task_[k]] + 1);
  }

  int new_task(int stage) {
    tasks_.emplace_back();
    stage_.push_back(stage);
    return static_cast<int>(tasks_.size()) - 1;
  }

  /// Light subtrees, several to a task, and branches; in the order of the nodes.
  void hand_out() {
    int group = none;
    for (int k = n_; k-- > 0;) {  // a root before its subtree
      if (heavy(k)) continue;
      if (const int p = parent(k); p != none && !heavy(p)) {
        task_[k] = task_[p];
        continue;
      }
      if (parent(k) != none && below_[k] < too_little) {
        task_[k] = task_[parent(k)];
        continue;
      }
      if (group == none || tasks_[group].work + below_[k] > most_) group = new_task(0);
      tasks_[group].work += below_[k];
      task_[k] = group;
    }
    for (Task& task : tasks_) task.work = 0.0;
    for (int k = 0; k < n_; ++k) {
      const int p = parent(k), own = task_[k];
      if (p == none || task_[p] == own) {
        append(own, k, Handing::over);
      } else if (tree_.keeps) {
        append(own, k, Handing::later);
        append(task_[p], k, Handing::only);
      } else {
        append(task_[p], k, Handing::over);
      }
    }
  }

  void append(int task, int k, Handing handing) {
    Task& to = tasks_[task];
    if (handing != Handing::only) to.work += tree_.work[k];
    if (!to.ranges.empty() && to.ranges.back().last == k && to.ranges.back().handing == handing)
      to.ranges.back().last += 1;
    else to.ranges.push_back({k, k + 1, handing});
  }

  /// The largest tasks of a stage first: who is done with one takes the next.
  std::vector<Stage> stages() {
    std::vector<Stage> out(*std::max_element(stage_.begin(), stage_.end()) + 1);
    for (std::size_t task = 0; task < tasks_.size(); ++task)
      if (!tasks_[task].ranges.empty()) out[stage_[task]].push_back(std::move(tasks_[task]));
    for (Stage& stage : out)
      std::stable_sort(stage.begin(), stage.end(), [](const Task& x, const Task& y) { return x.work > y.work; });
    const auto before = [](const Task& x, const Task& y) { return x.ranges[0].first < y.ranges[0].first; };
    std::sort(out[0].begin(), out[0].end(), before);  // many alike: what is neighboring in memory comes next
    std::erase_if(out, [](const Stage& stage) { return stage.empty(); });
    return out;
  }

  const EliminationTree& tree_;
  int n_;
  std::vector<double> below_;  ///< work of subtrees
  std::vector<int> first_;     ///< of the subtree
  double most_ = 0.0;
  std::vector<int> task_;  ///< of each node
  std::vector<Task> tasks_;
  std::vector<int> stage_;  ///< of each task
};

}  // namespace

WorkPlan plan_work(const EliminationTree& tree, bool for_threads) { return Planner(tree).plan(for_threads); }

}  // namespace linkwork::block
