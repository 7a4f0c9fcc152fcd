#include "linkwork/ensemble/lane_projection.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/displacement.hpp"

namespace linkwork {

using Violation = LaneStepper::Violation;

LaneProjection::LaneProjection(LaneStepper& stepper, const std::vector<Dynamics*>& mechanisms)
    : stepper_(stepper), kind_(mechanisms.front()->stabilization()) {
  for (Dynamics* it : mechanisms)
    lanes_.push_back({.mechanism = it, .size = NaturalSize(it->system()), .progress = {}});
  y_.resize(mechanisms.front()->y_size());
  x_.resize(mechanisms.front()->system().v_size());
}

void LaneProjection::stabilize(const AlignedDoubles& t, LaneGuard& guard) {
  if (!projects_positions(kind_) && !projects_velocities(kind_)) return;
  if (lanes_.front().mechanism->system().row_count() == 0) return;
  stepper_.evaluate(t, guard);
  here_ = true;
  factorized_ = false;
  if (projects_velocities(kind_)) measure_forces(guard);
  if (projects_positions(kind_)) iterate(Violation::positions, t, guard);
  if (projects_velocities(kind_)) iterate(Violation::velocities, t, guard);
}

/// Where the states were evaluated.
void LaneProjection::measure_forces(const LaneGuard& guard) {
  for (int l = 0; l < count(); ++l) {
    if (!guard.steps(l)) continue;
    stepper_.forces(l, x_);
    lanes_[l].by_forces = std::sqrt(lanes_[l].size.of_free_motion(x_));
  }
}

void LaneProjection::begin(Violation of, const LaneGuard& guard) {
  for (int l = 0; l < count(); ++l) {
    Lane& lane = lanes_[l];
    lane.going_on = guard.steps(l);
    lane.progress = {};
    if (!lane.going_on) continue;
    const System& system = lane.mechanism->system();
    stepper_.state(l, y_);
    if (of == Violation::positions) lane.scale = projection_reach(lane.size, system, y_);
    else lane.scale = std::max(lane.size.of(y_.segment(system.q_size(), system.v_size())), lane.by_forces);
  }
}

void LaneProjection::iterate(Violation of, const AlignedDoubles& t, LaneGuard& guard) {
  begin(of, guard);
  while (std::any_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.going_on; })) {
    if (!here_) stepper_.evaluate_constraints(t, guard);
    if (factorized_) stepper_.correct(of, t, guard);
    else stepper_.factorize_and_correct(of, t, guard);
    here_ = false;
    factorized_ = true;
    for (int l = 0; l < count(); ++l)
      if (lanes_[l].going_on) judge(l, of, t[l], guard);
  }
}

void LaneProjection::judge(int l, Violation of, double t, LaneGuard& guard) {
  using State = ProjectionProgress::State;
  Lane& lane = lanes_[l];
  if (lane.mechanism->watch().open()) guard.leave(l, t, "a projection in a singular pose");
  State state = State::converged;
  if (guard.steps(l)) state = lane.progress.judge(of == Violation::positions ? move(l) : accelerate(l));
  if (state == State::diverged) guard.leave(l, t, "a projection does not converge");
  lane.going_on = state == State::going_on;
}

double LaneProjection::move(int l) {
  const Lane& lane = lanes_[l];
  stepper_.state(l, y_);
  stepper_.correction(l, x_);
  displace(lane.mechanism->system(), x_, y_);
  stepper_.set_state(l, y_);
  return lane.size.of(x_) / lane.scale;
}

double LaneProjection::accelerate(int l) {
  Lane& lane = lanes_[l];
  const System& system = lane.mechanism->system();
  stepper_.state(l, y_);
  stepper_.correction(l, x_);
  auto v = y_.segment(system.q_size(), system.v_size());
  v += x_;
  stepper_.set_state(l, y_);
  lane.scale = std::max(lane.scale, lane.size.of(v));
  return NaturalSize::ratio(lane.size.of(x_), lane.scale);
}

}  // namespace linkwork
