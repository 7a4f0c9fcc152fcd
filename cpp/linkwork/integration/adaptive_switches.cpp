// How steps of AdaptiveSimulation end where contacts and stops begin or end.
#include <algorithm>
#include <cmath>

#include "linkwork/integration/adaptive_simulation.hpp"

namespace linkwork {
namespace {

constexpr double far_astray = 3.0;   // times as far from a switch as the motion
constexpr int most_corrections = 6;  // of the time of a switch
constexpr double located = 1e-12;    // that time, relative to the step

}  // namespace

/// Where `dynamics` is evaluated at the end of a step: whether one of its stages was much farther on another side of a
/// switch than the motion is at both ends. It is none of that motion, and what the stages say of the error is nothing.
bool AdaptiveSimulation::stages_went_astray() {
  if (!dynamics_.take_switched()) return false;
  const Dynamics::Elsewhere& it = dynamics_.elsewhere();
  const double before = touches_.at_begin()[it.which], after = dynamics_.evaluation().switches[it.which];
  return it.by > std::max(far_astray * std::max(std::abs(before), std::abs(after)), switches_.least());
}

// Forces of contacts and stops are not smooth where they begin or end, and that of a contact depends on the speed at
// which it began: the step is taken again up to there.
bool AdaptiveSimulation::end_at_switch(double h) {
  const bool touches = touches_.suspects(t_, h, stepper_.y_new());
  if (!dynamics_.switched() && !touches) return false;
  if (stages_went_astray()) {
    reject(h, half_a_step());
    return true;
  }
  const HermiteStep by_ends(dynamics_.system(), y_, stepper_.y_new(), h);
  const bool stages_to_come = stepper_.pair().extra_c.size() > 0;  // for an interpolant, which may be in a contact
  const Interpolant& step = stages_to_come ? static_cast<const Interpolant&>(by_ends) : stepper_;
  const auto found = switches_.first(step, t_, h, touches_.find(step, t_, h));
  if (found) end_at(*found, h);
  return found.has_value();
}

/// The step after it ends in the contact that begins, were it not for its force.
void AdaptiveSimulation::end_at(const SwitchWatch::Switch& found, double h) {
  evaluated_ = false;
  dynamics_.end_zero_order_hold();
  double part = found.theta * h;
  if (part <= least_step * std::max(std::abs(t_), std::abs(t_new_))) {  // at the start: the step is tried again
    evaluate(t_, y_);
    switch_ = found;
    return settle_history();
  }
  const BodyMaximum error = end_at_zero(found.which, h, part);
  if (!(error.value <= 1.0)) return reject(part, error);
  accept(part, error.value);
  switch_ = found;
  if (!stops_.empty()) switch_.reset();
  step_ = std::max(step_, part + 0.5 * (h - part));
  if (found.positive) step_ = std::min(step_, (found.until - found.theta) * h);
}

/// Tries a step to where a switch is zero, after the time `part` or as much more as it takes, less than h, by Newton's
/// method where what said so knows but the ends of a longer step.
BodyMaximum AdaptiveSimulation::end_at_zero(int which, double h, double& part) {
  const bool exact = stepper_.pair().extra_c.size() == 0;
  for (int k = 0; k < most_corrections; ++k) {
    evaluate(t_, y_);
    t_new_ = t_ + part;
    dynamics_.take_switched();
    const BodyMaximum error = trial(part);
    if (!(error.value <= 1.0)) return error;
    if (stages_went_astray()) return half_a_step();
    const double value = dynamics_.evaluation().switches[which];
    if (exact || std::abs(value) <= switches_.least()) return error;
    const double left = -value / touches_.rate_at_end(t_, part, stepper_.y_new(), which);
    if (std::abs(left) <= located * part) return error;
    if (!(part + left > 0.0 && part + left < h)) break;
    part += left;
  }
  return half_a_step();
}

/// `dynamics` is evaluated at the state from which the run goes on.
void AdaptiveSimulation::settle_history() {
  const int contact = switch_ ? dynamics_.system().switches()[static_cast<std::size_t>(switch_->which)] : -1;
  if (contact >= 0 && switch_->positive) {
    dynamics_.begin_contact(contact);
    evaluate(t_, y_);
  }
  accept_history();
  if (contact >= 0 && !switch_->positive) dynamics_.end_contact(contact);
  dynamics_.take_sides(switches_.least());
  if (switch_) dynamics_.set_side(switch_->which, switch_->positive);
  switch_.reset();
}

}  // namespace linkwork
