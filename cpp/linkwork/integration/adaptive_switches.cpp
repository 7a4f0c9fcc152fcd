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
  const double* first = stepper_.first_stage().data() + dynamics_.system().q_size();
  const double* last = stepper_.last_stage().data() + dynamics_.system().q_size();
  const StepSpan times = span(h);  // ends of stops may jump where it begins or ends
  const double begin = times.earliest, inside = times.latest - begin;
  const bool touches =
      touches_.suspects({begin, inside, y_, stepper_.y_new(), first, last}, dynamics_.evaluation().switches);
  if (!dynamics_.switched() && !touches) return false;
  if (stages_went_astray()) {
    reject(h, half_a_step());
    return true;
  }
  const bool apart = stays_apart_for_interpolation();
  const HermiteStep by_ends(dynamics_.system(), y_, stepper_.y_new(), h);
  const Interpolant& step = apart ? static_cast<const Interpolant&>(stepper_) : by_ends;
  const auto found = switches_.first(step, begin, inside, touches_.find(step));
  if (found) end_at(*found, h);
  else if (!apart) reject(h, half_a_step());
  return found || !apart;
}

/// Whether the stages that the interpolant still needs are on the sides of the step, too: else one may have been in a
/// contact, and spoils it. Positions at both ends then only tell where a touch is about.
bool AdaptiveSimulation::stays_apart_for_interpolation() {
  const Dynamics::Place end = dynamics_.place();
  dynamics_.take_switched();
  bool apart = false;
  dynamics_.formulation().look(true);
  try {
    with_time(t_, h_, [&] {
      if (stepper_.prepare_interpolation(dynamics_)) dynamics_.return_to(end);
    });
    apart = !dynamics_.take_switched() || dynamics_.elsewhere().by <= switches_.least();
  } catch (const OptionError&) {
    throw;
  } catch (const Error&) {
    dynamics_.return_to(end);
  }
  dynamics_.formulation().look(false);
  return apart;
}

/// The step after it ends in the contact that begins, were it not for its force.
void AdaptiveSimulation::end_at(const SwitchWatch::Switch& found, double h) {
  evaluated_ = false;
  dynamics_.end_zero_order_hold();
  double part = found.theta * h;
  if (part <= least_step * std::max(std::abs(t_), std::abs(t_new_))) {  // at the start: the step is tried again
    evaluate(t_, y_);
    switch_ = found;
    settle_history();
    if (found.positive) step_ = std::min(step_, found.until * h);
    return;
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
  accept_contacts();
  if (contact >= 0 && !switch_->positive) dynamics_.end_contact(contact);
  dynamics_.take_sides(switches_.least());
  if (switch_) dynamics_.set_side(switch_->which, switch_->positive);
  switch_.reset();
}

/// One that has begun goes on with its onset, though its depth be zero where another one ends the step.
void AdaptiveSimulation::accept_contacts() {
  const VectorXd before = dynamics_.history(), &switches = dynamics_.evaluation().switches;
  accept_history();
  VectorXd history = dynamics_.history();
  for (std::size_t k = 0; k < dynamics_.sides().size(); ++k) {
    const int contact = dynamics_.system().switches()[k];
    if (contact < 0 || !dynamics_.sides()[k] || history[contact] != 0.0) continue;
    if (switches[static_cast<Eigen::Index>(k)] >= -switches_.least()) history[contact] = before[contact];
  }
  dynamics_.set_history(history);
}

}  // namespace linkwork
