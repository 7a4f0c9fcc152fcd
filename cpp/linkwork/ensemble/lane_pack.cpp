#include "linkwork/ensemble/lane_pack.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace linkwork {
namespace {

constexpr double restless = 1.0;  // way or angle of a step in which a lane is looked at more closely

std::vector<Dynamics*> mechanisms_of(const std::vector<Lane*>& lanes) {
  std::vector<Dynamics*> out;
  for (Lane* lane : lanes) out.push_back(&lane->dynamics());
  return out;
}

}  // namespace

LanePack::LanePack(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Lane*> lanes,
                   const ButcherTableau& tableau, const FixedSteps& steps)
    : structure_(structure),
      lanes_(std::move(lanes)),
      steps_(steps),
      stepper_(structure, instructions, mechanisms_of(lanes_), tableau),
      projection_(stepper_, mechanisms_of(lanes_)),
      spans_(stepper_.width()),
      whole_(stepper_.width(), 1.0),
      ends_(stepper_.width(), 0.0),
      state_(structure.y_size()),
      new_state_(structure.y_size()),
      Phi_(structure.rows),
      Phi_dot_(structure.rows) {
  for (const Lane* it : lanes_) {
    watches_ = watches_ || it->watches();
    judged_ = judged_ || it->judged();
    limited_ = limited_ || it->limited();
  }
}

template <class Action>
void LanePack::each_lane(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->alive()) action(l, *lanes_[l]);
}

/// But for those that leap, or wait.
template <class Action>
void LanePack::each_stepping(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->stepping()) action(l, *lanes_[l]);
}

bool LanePack::any_lane() const {
  return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane* lane) { return lane->alive(); });
}

void LanePack::run(const std::function<void()>& look) {
  for (std::int64_t step = first_step(); any_lane(); ++step) {
    begin_step(step);
    if (step == steps_.count()) break;
    stepper_.hold(spans_, whole_.data());
    stepper_.step(spans_, *this);
    finish_step(step);
    look();
  }
}

std::int64_t LanePack::first_step() const {
  const auto starts = [](const Lane* lane) { return std::max<std::int64_t>(lane->joins_at(), 0); };
  std::int64_t first = starts(lanes_.front());
  for (const Lane* lane : lanes_) first = std::min(first, starts(lane));
  return first;
}

void LanePack::evaluate_start(int times) {
  for (int l = 0; l < stepper_.width(); ++l) spans_.set(l, 0.0, 0.0);
  for (int k = 0; k < times; ++k) stepper_.evaluate_rates(spans_, *this);
}

void LanePack::note(int l, double t, double pivot, bool first) {
  Lane& lane = *lanes_[l];
  if (structure_.keeps_order(lane.dynamics(), pivot)) lane.note(t, pivot, first);
  else lane.leave(t, "a small pivot changes the order of elimination");
}

// --- one step ---

void LanePack::begin_step(std::int64_t step) {
  const double t = steps_.time(step);
  each_lane([&](int l, Lane&) { continue_lane(l, step); });
  const double h = step < steps_.count() ? steps_.size(step) : 0.0;
  for (int l = 0; l < stepper_.width(); ++l) spans_.set(l, t, h);
  stepper_.evaluate(spans_, *this);
  const bool records = steps_.records(step),
             needs_state = records || watches_ || judged_ || limited_ || !structure_.dropped.empty();
  each_lane([&](int l, Lane& lane) {
    if (lane.waits() || lane.joins_at() == step) return;
    lane.accept(t, step > 0 ? steps_.size(step - 1) : 0.0);
    if (needs_state && lane.alive()) begin_lane(l, step);
  });
}

/// Those that join, or leap, have a state that is not the pack's.
void LanePack::continue_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  if (lane.waits()) {
    if (lane.joins_at() != step) return;
    lane.join();
    state_ = lane.joining_state();
  } else {
    lane.expect_nothing();
    if (!lane.leaping()) return;
    lane.follow_leap(steps_.frame_time(step), steps_.step(), state_);
  }
  stepper_.set_state(l, state_);
}

void LanePack::begin_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  const double t = steps_.time(step);
  const bool last = step == steps_.count();
  stepper_.state(l, state_);
  if (!structure_.dropped.empty() && !lane.leaping()) {
    Evaluation& at = lane.begin(t, state_);
    stepper_.violations(l, at.Phi, at.Phi_dot);
    lane.watch_redundant_rows(t, state_);
  }
  if (structure_.inerters > 0 && !lane.leaping()) stepper_.inerters(l, lane.begin(t, state_));
  if (lane.limited() && !lane.leaping()) {
    stepper_.violations(l, Phi_, Phi_dot_);
    lane.watch_limits(t, Phi_, Phi_dot_);
  }
  if (lane.alive() && steps_.records(step)) lane.record(t, steps_.frame_time(step), state_, last);
  const double potential = stepper_.potential(l);
  if (lane.alive()) lane.balance(step, state_, potential);
  if (!lane.stepping()) return;
  if (last) {
    lane.sample(steps_.t_end(), state_, potential);
    if (lane.watches()) lane.end(steps_.t_end(), state_);
    return;
  }
  if (lane.watches()) lane.look_ahead(step, steps_, state_);
  lane.finish_record(t);
  if (lane.stepping() || (lane.moves() && !lane.leaping())) lane.sample(t, state_, potential);
  if (lane.moves()) lane.move(step, state_);
}

void LanePack::finish_step(std::int64_t step) {
  check_size(step);
  stepper_.normalize();
  std::fill(ends_.begin(), ends_.end(), steps_.time(step + 1));
  projection_.stabilize(ends_, *this);
  if (!watches_ && !judged_) return;
  const double t = steps_.time(step), h = steps_.size(step);
  each_stepping([&](int l, Lane& lane) {
    stepper_.state_before_step(l, state_);
    if (lane.judged()) {
      stepper_.state(l, new_state_);
      lane.sample_step(t, h, state_, new_state_);
    }
    if (lane.watches()) lane.look_back(t, h, state_);
  });
}

/// Lanes that diverge, or whose numbers are none, leave, and stay where they are no burden.
void LanePack::check_size(std::int64_t step) {
  const double t = steps_.time(step + 1), h = steps_.size(step);
  const double* largest = stepper_.largest_number();
  each_stepping([&](int l, Lane& lane) {
    if (!std::isfinite(largest[l])) lane.leave(t, "a number is not finite");
  });
  largest = stepper_.largest_velocity();
  each_stepping([&](int l, Lane& lane) {
    if (largest[l] * h < restless) return;
    stepper_.state(l, state_);
    lane.check(t, h, state_);
  });
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (!lanes_[l]->alive()) stepper_.set_state(l, lanes_[l]->dynamics().initial_y());
}

}  // namespace linkwork
