#include "linkwork/ensemble/lane_retake.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/formulation/watched_formulation.hpp"

namespace linkwork {
namespace {

std::vector<Dynamics*> mechanisms_of(const std::vector<LaneRun*>& runs) {
  std::vector<Dynamics*> out;
  for (LaneRun* run : runs) out.push_back(&run->dynamics);
  return out;
}

}  // namespace

LaneRetake::LaneRetake(const LaneStructure& structure, const InstructionSet& instructions, std::vector<LaneRun*> runs,
                       const ButcherTableau& tableau)
    : structure_(structure),
      stepper_(structure, instructions, mechanisms_of(runs), tableau),
      spans_(stepper_.width()),
      shares_(stepper_.width(), 1.0) {
  std::fill(spans_.h.begin(), spans_.h.end(), 1.0);  // of lanes that have no step
  lanes_.reserve(runs.size());
  for (LaneRun* run : runs) {
    lanes_.push_back({run, parts_to_judge(run->sampling), {}, {run->sampling.breaks(), golden_share}, nullptr, false, {}});
    Lane& lane = lanes_.back();
    lane.divided.divide(divisions(run->sampling));
    each_kept_step(lane.parts, [&](const KeptStep& step, int) { lane.steps.push_back(&step); });
    run->retaken.assign(lane.steps.size(), VectorXd());
  }
}

void LaneRetake::run(const std::function<void()>& look) {
  std::size_t most = 0;
  for (const Lane& lane : lanes_) most = std::max(most, lane.steps.size());
  for (std::size_t step = 0; step < most; ++step) {
    for (Lane& lane : lanes_) begin(lane, step);
    take_parts();
    for (int l = 0; l < static_cast<int>(lanes_.size()); ++l) {
      if (!lanes_[l].active) continue;
      VectorXd& end = lanes_[l].run->retaken[step];
      end.resize(structure_.y_size());
      stepper_.state(l, end);
    }
    look();
  }
}

void LaneRetake::begin(Lane& lane, std::size_t step) {
  lane.active = step < lane.steps.size() && lane.run->dynamics.system().history_size() == 0 &&
                lane.steps[step]->left_out == structure_.dropped;
  if (!lane.active) return;
  lane.step = lane.steps[step];
  lane.spans = lane.divided.of(*lane.step);
  const std::size_t usual = std::size_t{1} << divisions(lane.run->sampling);
  const auto l = static_cast<int>(&lane - lanes_.data());
  lane.active = lane.spans.size() == usual && usual == std::size_t{1} << divisions(lanes_.front().run->sampling);
  if (lane.active) stepper_.set_state(l, lane.step->y);
}

void LaneRetake::take_parts() {
  const auto parts = std::size_t{1} << divisions(lanes_.front().run->sampling);
  for (std::size_t part = 0; part < parts; ++part) {
    for (int l = 0; l < static_cast<int>(lanes_.size()); ++l) {
      if (!lanes_[l].active) continue;
      const Span& span = lanes_[l].spans[part];
      spans_.set(l, span.from, span.to - span.from);
    }
    stepper_.evaluate(spans_, *this);
    if (part == 0) hold();
    stepper_.step(spans_, *this);
    stepper_.normalize();
  }
}

/// The correction that a step holds is that of the whole, in all of its parts.
void LaneRetake::hold() {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l].active) shares_[l] = spans_.h[l] / lanes_[l].step->h;
  stepper_.hold(spans_, shares_.data());
}

void LaneRetake::note(int l, double t, double pivot, bool) {
  SingularWatch& watch = lanes_[l].run->dynamics.formulation().watch();
  watch.note(t, pivot);
  if (!watch.usual(pivot)) lanes_[l].active = false;
}

}  // namespace linkwork
