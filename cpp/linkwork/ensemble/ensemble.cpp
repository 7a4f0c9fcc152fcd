#include "linkwork/ensemble/ensemble.hpp"

#include <algorithm>

#include "linkwork/ensemble/lane_retake.hpp"
#include "linkwork/ensemble/lane_threads.hpp"
#include "linkwork/ensemble/lane_user_forces.hpp"
#include "linkwork/integration/runge_kutta.hpp"

namespace linkwork {

Ensemble::Ensemble(const std::vector<Dynamics*>& dynamics, const ButcherTableau& tableau, const FixedSteps& steps,
                   const InstructionSet& widest, std::vector<LaneRun*> runs)
    : dynamics_(dynamics),
      runs_(std::move(runs)),
      tableau_(tableau),
      steps_(steps),
      widest_(widest),
      members_(dynamics.size()) {
  check(tableau);
  for (int k = 0; k < static_cast<int>(dynamics.size()); ++k) {
    members_[k].reason = LaneStructure::refusal_of_numbers(*dynamics[k]);
    if (!members_[k].reason.empty()) continue;
    auto found = std::find_if(groups_.begin(), groups_.end(),
                              [&](const auto& group) { return group->structure.same(*dynamics[k]); });
    if (found == groups_.end()) {
      members_[k].reason = LaneStructure::refusal(*dynamics[k]);
      if (!members_[k].reason.empty()) continue;
      found = groups_.insert(groups_.end(), std::make_unique<Group>(Group{LaneStructure(*dynamics[k]), {}}));
    }
    (*found)->members.push_back(k);
  }
  const std::ptrdiff_t width = lane_kernels(widest).width;
  for (const auto& group : groups_)
    for (std::ptrdiff_t first = 0; first < std::ssize(group->members); first += width) {
      const auto last = std::min(first + width, std::ssize(group->members));
      tasks_.push_back({group.get(), {group->members.begin() + first, group->members.begin() + last}});
    }
}

void Ensemble::run_pack(const LaneStructure& structure, const std::vector<Lane*>& lanes,
                        const std::function<void()>& look) {
  const InstructionSet fitting = instruction_set_for(static_cast<int>(lanes.size()), widest_);
  LanePack pack(structure, fitting, lanes, tableau_, steps_);
  pack.run(look);
}

/// Lanes whose redundant equations are other ones now, and the same for all of them; none where lanes cannot have them.
std::unique_ptr<LaneStructure> Ensemble::run_moved(const std::vector<Lane*>& lanes, const std::function<void()>& look) {
  Lane& first = **std::find_if(lanes.begin(), lanes.end(), [](const Lane* lane) { return lane->moves(); });
  if (std::string why = LaneStructure::refusal(first.dynamics()); !why.empty()) {
    first.leave(steps_.time(first.joins_at()), why);
    return nullptr;
  }
  auto structure = std::make_unique<LaneStructure>(first.dynamics());
  std::vector<Lane*> moved;
  for (Lane* lane : lanes)
    if (lane->moves() && structure->same(lane->dynamics())) {
      lane->wait();
      moved.push_back(lane);
    }
  run_pack(*structure, moved, look);
  return structure;
}

/// Runs that have ended, for their verdicts.
void Ensemble::judge(const std::vector<const LaneStructure*>& structures, const std::vector<Lane*>& lanes,
                     const std::function<void()>& look) {
  std::vector<LaneRun*> ended;
  for (const Lane* lane : lanes)
    if (lane->run() && lane->alive()) ended.push_back(lane->run());
  if (ended.empty()) return;
  const InstructionSet fitting = instruction_set_for(static_cast<int>(ended.size()), widest_);
  judge_runs(structures, fitting, ended, tableau_, look);
}

void Ensemble::run_task(const Task& task, const std::function<void()>& look) {
  std::vector<std::unique_ptr<Lane>> lanes;
  std::vector<Lane*> alive;
  std::vector<int> members;
  for (const int member : task.members) {
    do_apart(
        [&] {
          lanes.push_back(std::make_unique<Lane>(*dynamics_[member], steps_, runs_.empty() ? nullptr : runs_[member]));
          if (steps_.counts_turns()) lanes.back()->count_turns();
          members.push_back(member);
          alive.push_back(lanes.back().get());
        },
        [&](std::string why) { members_[member].reason = std::move(why); });
  }
  if (alive.empty()) return;
  run_pack(task.group->structure, alive, look);
  std::vector<std::unique_ptr<LaneStructure>> later;
  std::vector<const LaneStructure*> structures{&task.group->structure};
  while (std::any_of(alive.begin(), alive.end(), [](const Lane* lane) { return lane->moves(); }))
    if (auto structure = run_moved(alive, look)) {
      const auto same_rows = [&](const LaneStructure* it) { return it->dropped == structure->dropped; };
      if (std::none_of(structures.begin(), structures.end(), same_rows))
        structures.push_back(later.emplace_back(std::move(structure)).get());
    }
  judge(structures, alive, look);
  for (std::size_t k = 0; k < members.size(); ++k) {
    members_[members[k]] = {lanes[k]->take_frames(), lanes[k]->reason(), lanes[k]->left_at(), {}};
    if (const TurnCounter* turns = lanes[k]->turns()) members_[members[k]].turned = turns->found();
  }
}

void Ensemble::run(int threads) {
  std::vector<LaneTask> tasks;
  for (const Task& task : tasks_)
    tasks.emplace_back([this, &task](const std::function<void()>& look) { run_task(task, look); });
  run_on_threads(tasks, threads);
  refuse_distrusted();
}

/// Members that have ended before a force of theirs was found to be another one beside others.
void Ensemble::refuse_distrusted() {
  std::vector<const Model*> models;
  for (const Dynamics* it : dynamics_) models.push_back(&it->system().model());
  const std::vector<std::string> reasons = distrusted_forces(models);
  for (std::size_t k = 0; k < members_.size(); ++k)
    if (members_[k].reason.empty() && !reasons[k].empty()) members_[k] = {{}, reasons[k], NAN, {}};
}

std::vector<Ensemble::Member> Ensemble::take() { return std::exchange(members_, {}); }

}  // namespace linkwork
