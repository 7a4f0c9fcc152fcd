#include "linkwork/ensemble/lane_trials.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/ensemble/lane_threads.hpp"
#include "linkwork/ensemble/lane_user_forces.hpp"
#include "linkwork/formulation/watched_formulation.hpp"

namespace linkwork {
namespace {

/// The first ones, which lanes begin with.
std::vector<Dynamics*> first_mechanisms(const TrialQueue& queue, const InstructionSet& instructions) {
  std::vector<Dynamics*> out;
  const auto width = static_cast<std::size_t>(lane_kernels(instructions).width);
  for (std::size_t k = 0; k < std::min(width, queue.runs.size()); ++k) out.push_back(&queue.runs[k]->mechanism());
  return out;
}

}  // namespace

LaneTrials::LaneTrials(TrialQueue& queue, const InstructionSet& instructions, const ButcherTableau& tableau)
    : queue_(queue),
      stepper_(queue.structure, instructions, first_mechanisms(queue, instructions), tableau),
      spans_(stepper_.width()),
      lanes_(stepper_.count()) {
  std::fill(spans_.h.begin(), spans_.h.end(), 1.0);
  // The correction is that of each run; gains that do not depend on the step are taken here.
  const AlignedDoubles whole(stepper_.width(), 1.0);
  stepper_.hold(spans_, whole.data());
}

SingularWatch& LaneTrials::watch_of(const Lane& lane) const { return lane.run->mechanism().formulation().watch(); }

template <class Action>
void LaneTrials::guarded(Lane& lane, const Action& action) {
  do_apart(action, [&](std::string why) { give_up(lane, std::move(why)); });
}

void LaneTrials::give_up(Lane& lane, std::string why) {
  *lane.reason = std::move(why);
  lane.run = nullptr;
  lane.trial = lane.active = false;
}

void LaneTrials::take_up(int l) {
  Lane& lane = lanes_[l];
  lane.run = nullptr;
  const std::size_t next = queue_.next++;
  if (next >= queue_.runs.size()) return;
  lane.run = queue_.runs[next];
  lane.reason = queue_.reasons[next];
  stepper_.replace(l, lane.run->mechanism());
}

/// To the next step that is to be tried, of this run or of the next one.
void LaneTrials::advance(int l) {
  Lane& lane = lanes_[l];
  while (!lane.trial) {
    if (!lane.run) take_up(l);
    if (!lane.run) return;
    bool finished = false;
    guarded(lane, [&] {
      lane.trial = lane.run->advance_to_trial();
      finished = !lane.trial;
    });
    if (finished) lane.run = nullptr;
  }
}

void LaneTrials::begin(int l) {
  Lane& lane = lanes_[l];
  const Dynamics& mechanism = lane.run->mechanism();
  const bool begun = lane.run->begin_trial();  // which may find other rows redundant
  lane.active = begun && mechanism.dropped().rows() == queue_.structure.dropped;
  if (!lane.active) return;
  lane.watch = watch_of(lane);
  spans_.set(l, lane.run->trial_span());
  stepper_.begin_stages(l, lane.run->trial_start(), lane.run->stepper().first_stage(), mechanism.held_correction());
}

void LaneTrials::finish(int l) {
  Lane& lane = lanes_[l];
  if (lane.active) {
    bool finite = true;
    lane.run->stepper().supply([&](int stage, MutableVector k) {
      stepper_.rates(l, stage, k);
      finite = finite && k.allFinite();
    });
    if (!finite) leave(l, 0.0, "");
    if (!lane.active) {
      lane.run->stepper().take_back();
      lane.run->mechanism().take_switched();  // of stages that come again
    }
  }
  lane.active = false;
  lane.trial = false;
  guarded(lane, [&] { lane.run->finish_trial(); });
}

void LaneTrials::run(const std::function<void()>& look) {
  const int count = stepper_.count();
  while (true) {
    bool any = false, active = false;
    for (int l = 0; l < count; ++l) {
      advance(l);
      if (!lanes_[l].trial) continue;
      any = true;
      guarded(lanes_[l], [&] { begin(l); });
      active = active || lanes_[l].active;
    }
    if (!any) return;
    if (active) stepper_.later_stages(spans_, *this);
    for (int l = 0; l < count; ++l)
      if (lanes_[l].trial) finish(l);
    look();
  }
}

void LaneTrials::note(int l, double t, double pivot, bool) {
  SingularWatch& watch = watch_of(lanes_[l]);
  watch.note(t, pivot);
  const bool usual = pivot > singular_pivot && watch.usual(pivot);
  if (!usual || !queue_.structure.keeps_order(lanes_[l].run->mechanism(), pivot)) leave(l, t, "");
}

/// For this step: the run takes the stages by itself, and finds what there is to find.
void LaneTrials::leave(int l, double, std::string) {
  if (!lanes_[l].active) return;
  lanes_[l].active = false;
  watch_of(lanes_[l]) = lanes_[l].watch;
}

namespace {

/// Runs that have ended before a force of theirs was found to be another one beside others.
void refuse_distrusted(const std::vector<AdaptiveSimulation*>& runs, std::vector<std::string>& reasons) {
  std::vector<const Model*> models;
  for (AdaptiveSimulation* it : runs) models.push_back(&it->mechanism().system().model());
  const std::vector<std::string> found = distrusted_forces(models);
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (reasons[k].empty()) reasons[k] = found[k];
}

}  // namespace

std::vector<std::string> run_trials(const std::vector<AdaptiveSimulation*>& runs, const InstructionSet& widest,
                                    int threads) {
  std::vector<std::string> reasons(runs.size());
  std::vector<std::unique_ptr<TrialQueue>> queues;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Dynamics& mechanism = runs[k]->mechanism();
    reasons[k] = LaneStructure::refusal(mechanism);
    if (!reasons[k].empty()) continue;
    auto found =
        std::find_if(queues.begin(), queues.end(), [&](const auto& queue) { return queue->structure.same(mechanism); });
    if (found == queues.end()) found = queues.insert(queues.end(), std::make_unique<TrialQueue>(mechanism));
    (*found)->runs.push_back(runs[k]);
    (*found)->reasons.push_back(&reasons[k]);
  }
  threads = std::max(threads, 1);
  std::vector<LaneTask> tasks;
  for (const auto& queue : queues) {
    const auto width = static_cast<std::size_t>(lane_kernels(widest).width);
    const std::size_t packs = std::min<std::size_t>((queue->runs.size() + width - 1) / width, threads);
    const auto each = static_cast<int>(std::min(width, queue->runs.size()));
    const ButcherTableau& method = queue->runs.front()->pair().method;
    for (std::size_t k = 0; k < packs; ++k) {  // here, where no run is on its way yet
      const auto lanes = std::make_shared<LaneTrials>(*queue, instruction_set_for(each, widest), method);
      tasks.emplace_back([lanes](const std::function<void()>& look) { lanes->run(look); });
    }
  }
  run_on_threads(tasks, threads);
  refuse_distrusted(runs, reasons);
  return reasons;
}

}  // namespace linkwork
