#include "linkwork/integration/adaptive_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "linkwork/math/elementary.hpp"

namespace linkwork {
namespace {

constexpr double least_relative = 1e-13;  // below, roundoff is all that an estimate sees

void check(const AdaptiveSchedule& schedule) {
  const auto refuse = [](const char* what, const char* why) { throw OptionError(what, std::string(what) + " " + why); };
  const auto& [relative, absolute] = schedule.tolerances;
  if (!(schedule.t_end >= 0.0) || !std::isfinite(schedule.t_end)) refuse("t_end", "must be finite and not negative");
  if (!(relative >= least_relative) || !std::isfinite(relative))
    refuse("rtol", "must be at least 1e-13: double precision holds no more");
  if (!(absolute > 0.0) || !std::isfinite(absolute)) refuse("atol", "must be positive and finite");
  if (!(schedule.largest_step > 0.0)) refuse("step", "must be positive");
  if (schedule.record_every < 0) refuse("record_every", "must not be negative");
  if (!std::is_sorted(schedule.times.begin(), schedule.times.end())) refuse("times", "must ascend");
  if (!schedule.times.empty() &&
      !(schedule.times.front() >= schedule.t_start && schedule.times.back() <= schedule.t_end))
    refuse("times", "must lie between the start and t_end");
}

// What a step must not add to the violation of the constraints, in units of the tolerances.
constexpr double huge = 1e3;

constexpr double small = 1e-8;  // steps, relative to t, in which the roundoff of t + h counts

// Steps tried at a singular pose: of the usual one 1, 1 - d, 1 - 2 d, ...
constexpr int most_tries = 6;
constexpr double try_decrease = 0.1;

// Violations are corrected over the longest step of late, less this part of what went by since: steps that become short
// for a while, as where a contact begins or at an end, would make velocities of the roundoff of positions.
constexpr double forgetting = 0.25;

constexpr double too_far = 1e3;  // error of a step in which full turns cannot be counted

std::string scientific(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

}  // namespace

AdaptiveSimulation::AdaptiveSimulation(Dynamics& dynamics, const EmbeddedPair& pair, const AdaptiveSchedule& schedule,
                                       std::vector<Event> events)
    : Run(dynamics),
      schedule_(schedule),
      stepper_(pair),
      measure_(dynamics.system(), schedule.tolerances),
      controller_(pair.error_order + 1),
      breaks_(dynamics.system().model(), schedule.breaks),
      jumps_(dynamics.system()),
      crossing_(dynamics),
      watch_(std::move(events)),
      switches_(dynamics, schedule.tolerances.absolute),
      touches_(dynamics, schedule.tolerances.absolute) {
  check(schedule);
  yields_ = formulation_info(dynamics.options().formulation).compliant;
  if (schedule.record_every != 1) recorder_.count_turns();
  begin_at(schedule.t_start, schedule.t_end, schedule.start);
  t_ = last_stop_ = start_ = schedule.t_start;
  if (schedule.listed) listed_ = repeated_ = *schedule.listed;
  stepper_.start(dynamics.y_size());
  if (!watch_.empty()) crossing_.watch_rotors();
  dynamics.require_accuracy(schedule.tolerances.relative);
  workspace_.resize(dynamics.y_size());
  rates_.resize(dynamics.y_size());
}

void AdaptiveSimulation::take_step() {
  if (go_on()) finish_trial();
}

/// Up to where a step is to be tried; false where something else was to be done.
bool AdaptiveSimulation::go_on() {
  if (!accepted_) mark(begun_ && near_end());
  if (!begun_) begin();
  else if (!accepted_) return prepare_trial();
  else if (output_inside()) record_inside();
  else finish_step();
  return false;
}

bool AdaptiveSimulation::advance_to_trial() {
  while (true) {
    stop_at_singular_pose();
    if (finished_) return false;
    if (go_on()) return true;
  }
}

bool AdaptiveSimulation::begin_trial() {
  try {
    with_time(t_, NAN, [&] { stepper_.begin(dynamics_, trial_span()); });
    return true;
  } catch (const OptionError&) {
    throw;
  } catch (const Error&) {
    return false;
  }
}

/// What is left of the run limits the step from here.
bool AdaptiveSimulation::near_end() const {
  return !(2.0 * std::min(step_, schedule_.largest_step) < schedule_.t_end - t_);
}

void AdaptiveSimulation::keep(Archive& archive) {
  Run::keep(archive);
  archive(t_, begun_, evaluated_, step_, proposed_, controller_, watch_, last_stop_, last_interval_, shorter_);
  archive(usual_step_, tries_, best_step_, best_error_, correction_length_, shorter_since_);
  crossing_.keep(archive, false);
  Dynamics::Place place = dynamics_.place();
  archive(place.t, place.factorized, place.fallback);
  if (!archive.reading()) return;
  if (evaluated_) dynamics_.return_to({place.t, y_, place.factorized, place.fallback});
  const bool at_break = t_ < start_ && breaks_.at(start_);  // what jumps there may be ahead of the last frame before
  if (at_break) {
    recorder_.take();  // a frame of it comes with the step
    recorder_.silence_until(std::nextafter(start_, -INFINITY));
  }
  const auto passed = [&](double t) { return at_break ? t < start_ : t <= start_; };
  while (next_time_ < schedule_.times.size() && passed(schedule_.times[next_time_])) next_time_ += 1;
}

void AdaptiveSimulation::record_start() {
  evaluate(clock(), y_);
  const bool due = schedule_.record_every > 0 || schedule_.times.empty() || schedule_.times.front() == t_;
  if (due) recorder_.record(t_, y_);
}

void AdaptiveSimulation::evaluate(double t, const VectorXd& y) {
  with_time(t, NAN, [&] { dynamics_.evaluate(t, y); });
}

void AdaptiveSimulation::begin() {
  begun_ = true;
  evaluate(clock(), y_);
  settle_history();
  with_time(t_, NAN, [&] { monitor_violation(clock()); });
  finished_ = t_ >= schedule_.t_end;
  record_if_due();
  if (finished_) return;
  with_time(t_, NAN, [&] {
    step_ = initial_step();
    watch_.expect(step_);
    watch_.start_after(dynamics_.system(), t_, y_, rates_, schedule_.happened);
  });
}

// Hairer, Norsett and Wanner (1993), Solving Ordinary Differential Equations I, section II.4: a step in which the state
// changes by one percent, then one whose error, judged by the second derivative, is one percent of the tolerances.
double AdaptiveSimulation::initial_step() {
  const double free = std::min(schedule_.largest_step, breaks_.next(t_) - t_),
               most = std::min(free, schedule_.t_end - t_);
  dynamics_.rates(rates_);
  const double speed = measure_.of_change(y_, y_, rates_).value;
  const double wanted = speed > 0.0 ? 0.01 * measure_.of_state(y_) / speed : INFINITY, first = std::min(wanted, most);
  if (steps_done_ == 0) correction_length_ = speed > 0.0 ? std::min(wanted, schedule_.largest_step) : 0.0;
  bounded_ = bounded_ || (most < free && first == most);
  evaluated_ = false;
  try {
    workspace_ = y_ + first * rates_;
    dynamics_.evaluate(breaks_.before(t_ + first), workspace_);
    dynamics_.rates(workspace_);
  } catch (const Error&) {
    return 0.01 * first;
  }
  workspace_ -= rates_;
  const double steepest = std::max(speed, measure_.of_change(y_, y_, workspace_).value / first);
  if (!std::isfinite(steepest)) return 0.01 * first;
  const double second =
      steepest > 0.0 ? elementary::power(0.01 / steepest, 1.0 / (stepper_.pair().method.order + 1)) : most;
  bounded_ = bounded_ || (most < free && std::min(100.0 * first, second) >= most);
  return std::min({100.0 * first, second, most});
}

bool AdaptiveSimulation::prepare_trial() {
  if (!evaluated_) evaluate(clock(), y_);
  if (leap()) return false;
  dynamics_.correct_over(correction_length_);
  sampling_.before(dynamics_, y_);
  double h = proposed_ = std::min(step_, schedule_.largest_step);
  h = std::min(h, crossing_.most_step());
  t_new_ = end_of_step(h);
  Phi_ = dynamics_.evaluation().Phi;
  Phi_dot_ = dynamics_.evaluation().Phi_dot;
  dynamics_.take_switched();
  touches_.begin(y_, dynamics_.evaluation().switches, dynamics_.sides());
  trial_h_ = h;
  return true;
}

void AdaptiveSimulation::finish_trial() {
  const double h = trial_h_;
  const BodyMaximum error = trial(h);
  if (error.value <= 1.0 && TurnGuard::too_far(turns_.largest(h))) reject(h, {too_far, -1});
  else if (error.value <= 1.0 && end_at_switch(h)) return;
  else if (const double shorter = error.value <= 1.0 ? crossing_.shorter_step(t_, h) : h; shorter < h) retry(shorter);
  else if (error.value <= 1.0) accept(h, error.value);
  else if (near_singular_pose()) pass_singular_pose(h, error.value);
  else reject(h, error);
}

/// Where a step h ends: at the end of the run, at a break point, or at the only knot of tables on its way.
double AdaptiveSimulation::end_of_step(double& h) const {
  const double end = next_stop(), remaining = end - t_;
  double t_new = t_ + h;
  if (h >= remaining) {
    t_new = end;
  } else if (2.0 * h > remaining) {  // no sliver at the end
    t_new = t_ + 0.5 * remaining;
  }
  if (const double knot = breaks_.only_knot(t_, t_new); knot < t_new) t_new = knot;
  if (h >= remaining || t_new < t_ + h || h < small * std::abs(t_new)) h = t_new - t_;
  return t_new;
}

/// The end of the run, or a break before it: at one that it ends in, nothing comes after.
double AdaptiveSimulation::next_stop() const {
  const double next = breaks_.next(t_);
  return next < breaks_.before(schedule_.t_end) ? next : schedule_.t_end;
}

/// Where functions of time are evaluated for what begins at t_; at the end, for what ends there.
double AdaptiveSimulation::clock() const { return breaks_.clock(t_, schedule_.t_end); }

/// Whether what acts changes in a step, which ends there; at a break where it begins it has changed before.
bool AdaptiveSimulation::meets_break(double t, double t_new) const {
  const double next = breaks_.next(t);
  return next <= t_new && next < breaks_.before(schedule_.t_end);
}

/// A step h from t_ to t_new_, between breaks.
StepSpan AdaptiveSimulation::span(double h) const {
  const double begin = clock();
  return {t_, h, begin, std::max(begin, breaks_.before(t_new_))};
}

/// An error after which about half of the step is tried.
BodyMaximum AdaptiveSimulation::half_a_step() const {
  return {elementary::power(2.0, stepper_.pair().error_order + 1), -1};
}

/// Over a singular pose, where one is ahead; the step after it is as long as those before.
bool AdaptiveSimulation::leap() {
  leapt_ = false;
  const double h = std::min(step_, schedule_.largest_step);
  const double end = next_stop(), begin = clock(), remaining = breaks_.before(end) - begin;
  with_time(t_, h, [&] {
    if (!crossing_.due(t_, std::min(h, remaining), y_, true)) return;
    const bool goes_on = end == schedule_.t_end && dynamics_.system().model().autonomous();
    leapt_ = crossing_.leap(begin, std::min(h, remaining), 0.0, goes_on ? INFINITY : remaining, y_);
    if (!leapt_) dynamics_.evaluate(clock(), y_);
  });
  bounded_ = bounded_ || (end == schedule_.t_end && crossing_.limited());
  if (!leapt_) return false;
  sampling_.correct(y_, crossing_.last().y);
  accepted_ = true;
  evaluated_ = false;
  if (crossing_.last().h > remaining) crossing_.cut(remaining);
  bounded_ = bounded_ || (end == schedule_.t_end && crossing_.limited());
  h_ = crossing_.last().followed;
  t_new_ = h_ == remaining ? end : std::min(crossing_.last().end(), end);
  y_new_ = crossing_.last().y_new;
  stops_.clear();
  switch_.reset();
  away_from_.reset();
  with_time(t_, h_, [&] {
    if (!watch_.empty()) look_for_events();
    crossing_.look_into_leap(t_new_);
    crossing_.correct_frame(recorder_, t_, y_);
    stop_at_singular_pose();
  });
  return true;
}

const Interpolant& AdaptiveSimulation::interpolant() const {
  if (leapt_) return crossing_;
  return stepper_;
}

bool AdaptiveSimulation::near_singular_pose() const { return dynamics_.watch().open() && usual_step_ > 0.0; }

// Two branches of motion cross in a singular pose: with theta along the one and z along the other the constraint is
// theta z = 0. A state that violates it by delta follows the hyperbola theta z = delta instead, which turns off onto
// the other branch at theta ~ delta^1/2, and a method that resolves this with ever smaller steps gets stuck. So steps
// stay nearly as large as they were before: the pose is jumped over, by the step out of several with the least error.
void AdaptiveSimulation::pass_singular_pose(double h, double error) {
  evaluated_ = false;
  if (tries_ == 0 || error < best_error_) {
    best_step_ = h;
    best_error_ = error;
  }
  if (tries_ < most_tries) {
    statistics_.rejected += 1;
    step_ = usual_step_ * (1.0 - try_decrease * tries_);
    tries_ += 1;
    return;
  }
  if (!std::isfinite(best_error_)) return reject(h, {best_error_, -1});
  evaluate(clock(), y_);
  proposed_ = best_step_;
  t_new_ = std::min(t_ + best_step_, next_stop());
  trial(best_step_);
  statistics_.singular += 1;
  accept(best_step_, 1.0);
}

/// A stage that has no solution, or is beyond a table, makes the error infinite: the step may only have been too large.
BodyMaximum AdaptiveSimulation::trial(double h) {
  last_failure_.clear();
  beyond_table_ = nullptr;
  try {
    const StepSpan step = span(h);
    BodyMaximum error;
    with_time(t_, h, [&] { error = stepper_.trial(dynamics_, measure_, step, y_); });
    const bool seen = error.value > 1.0 || breaks_.seen(stepper_.pair(), step, schedule_.tolerances.relative);
    if (!seen || (error.value <= 1.0 && violates(h))) return half_a_step();
    return error;
  } catch (const OptionError& error) {
    if (error.code() != outside_table) throw;
    beyond_table_ = std::current_exception();
  } catch (const Error& error) {
    last_failure_ = error.what();
  }
  return {std::numeric_limits<double>::infinity(), -1};
}

void AdaptiveSimulation::accept(double h, double error) {
  accepted_ = evaluated_ = true;
  if (ConnectedParts::of(dynamics_.system()).count() > 1) errors_ = stepper_.errors_of_parts(measure_, error);
  else errors_.setConstant(1, error);
  switch_.reset();
  h_ = h;
  correction_length_ = std::max(correction_length_, h) - forgetting * h;
  y_new_ = stepper_.y_new();
  statistics_.smallest = std::min(statistics_.smallest, h);
  statistics_.largest = std::max(statistics_.largest, h);
  step_ = controller_.after_accepted(h, error);
  if (h < 0.99 * proposed_) step_ = std::max(step_, proposed_);  // it was cut short
  tries_ = 0;
  if (!dynamics_.watch().open()) usual_step_ = h;
  else if (usual_step_ > 0.0) step_ = std::max(step_, usual_step_);
  stops_.clear();
  if (!watch_.empty()) with_time(t_, h, [&] { look_for_events(); });
}

void AdaptiveSimulation::retry(double h) {
  evaluated_ = false;
  statistics_.rejected += 1;
  step_ = h;
}

void AdaptiveSimulation::reject(double h, const BodyMaximum& error) {
  retry(controller_.after_rejected(h, error.value));
  const double span = std::max(schedule_.t_end - start_, std::abs(t_));
  if (step_ < least_step * span) with_time(t_, step_, [&] { throw_step_size(error); });
}

void AdaptiveSimulation::throw_step_size(const BodyMaximum& error) const {
  ErrorDetails details;
  std::string worst;
  if (error.body >= 0) {
    details.bodies = {dynamics_.system().model().body_name(error.body)};
    worst = " at body '" + details.bodies.front() + "'";
  }
  if (beyond_table_) std::rethrow_exception(beyond_table_);
  const std::string cause = last_failure_.empty() ? "" : "; the last trial failed: " + last_failure_;
  throw StepSizeError("step_size",
                      "the error" + worst + " stays above the tolerances however small the step, " + scientific(step_) +
                          " s at last: the motion is not smooth here (an impact, a force that jumps, a mechanism that "
                          "locks) or rtol and atol are too small" +
                          cause,
                      details);
}

/// What an estimate of the error cannot see, the constraints can: what the step adds to their violation, beyond what
/// its start explains, is an error of the step. Penalties violate them on purpose.
bool AdaptiveSimulation::violates(double h) const {
  const Evaluation& at = dynamics_.evaluation();
  if (at.Phi.size() == 0 || yields_ || near_singular_pose()) return false;
  workspace_rows_ = at.Phi.cwiseAbs() - Phi_.cwiseAbs() - h * Phi_dot_.cwiseAbs();
  return !(workspace_rows_.maxCoeff() <= huge * measure_.of_length(y_));
}

bool AdaptiveSimulation::output_inside() const {
  return next_time_ < schedule_.times.size() && schedule_.times[next_time_] < t_new_;
}

void AdaptiveSimulation::record_inside() {
  const double t = schedule_.times[next_time_++];
  if (evaluated_ && !away_from_) away_from_ = dynamics_.place();
  dynamics_.formulation().look(true);
  with_time(t, NAN, [&] {
    if (!leapt_) stepper_.prepare_interpolation(dynamics_);
    if (leapt_) crossing_.place(crossing_.theta(t), workspace_);
    else interpolant().interpolate(dynamics_.system(), (t - t_) / h_, workspace_);
    dynamics_.evaluate(span(h_).within(t), workspace_);
    if (leapt_) record_in_leap(t, workspace_);
    else record_in_step(t, workspace_);
  });
  dynamics_.formulation().look(false);
}

void AdaptiveSimulation::record_in_step(double t, const VectorXd& y) {
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  if (!crossing_.accelerations_beside(interpolant(), t_, h_, t, v_dot, lambda)) return recorder_.record(t, y);
  recorder_.record(t, y, v_dot, lambda);
}

void AdaptiveSimulation::record_in_leap(double t, const VectorXd& y) {
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  crossing_.interpolate(crossing_.theta(t), v_dot, lambda);
  recorder_.record(t, y, v_dot, lambda);
}

void AdaptiveSimulation::finish_step() {
  dynamics_.end_zero_order_hold();
  with_time(t_, h_, [&] { list_singular_poses(); });
  const double t_before = std::exchange(t_, t_new_);
  y_before_.swap(y_);
  y_ = y_new_;
  accepted_ = false;
  steps_done_ += 1;
  const bool at_break = meets_break(t_before, t_);
  if (at_break) with_time(t_, h_, [&] { cross_break(); });
  if (away_from_ && !projects() && !at_break) with_time(t_, NAN, [&] { dynamics_.return_to(*away_from_); });
  away_from_.reset();
  if (projects()) {
    with_time(t_, h_, [&] { projection().stabilize(clock(), y_); });
    evaluated_ = false;
  }
  sample(t_before, at_break);
  if (!evaluated_) evaluate(clock(), y_);
  settle_history();
  with_time(t_, h_, [&] { monitor_violation(clock()); });
  evaluated_ = true;
  finished_ = t_ >= schedule_.t_end;
  if (finished_) sampling_.before(dynamics_, y_);
  if (!stops_.empty()) finish_event(t_before);
  list_events();
  record_if_due();
  if (finished_ && crossing_.correct_last_frame(recorder_, t_, y_)) dynamics_.evaluate(clock(), y_);
  if (finished_ || (stops_.empty() && !at_break)) return;
  with_time(t_, NAN, [&] {
    if (!stops_.empty()) {
      check_accumulation();
      watch_.restart(dynamics_.system(), t_, y_new_, y_, stops_);
    }
    step_ = initial_step();
  });
  crossing_.restart();
  controller_.restart();
}

void AdaptiveSimulation::list_singular_poses() {
  if (!leapt_ && crossing_.look_back(t_, t_new_ - t_, y_)) evaluated_ = false;
  if (stops_.empty() && t_new_ < schedule_.t_end && !meets_break(t_, t_new_)) return;
  if (crossing_.end(t_new_, y_new_)) evaluated_ = false;
}

/// The step as the method made it, on its own side of breaks.
void AdaptiveSimulation::sample(double t_before, bool at_break) {
  const bool struck = at_break && dynamics_.system().time_dependent_constraints();
  if (!stops_.empty() || leapt_ || struck) return sampling_.pass_over();
  const double t = breaks_.after(t_before), t_new = breaks_.before(t_);
  if (!(t < t_new)) return sampling_.pass_over();
  sampling_.after(t, t_new - t, y_before_, y_, errors_);
  if (at_break) sampling_.pass_over();
}

/// A state at which a step begins or ends.
void AdaptiveSimulation::record_if_due() {
  const auto& times = schedule_.times;
  const bool stopped = !stops_.empty(), last = finished_ && stopped;
  bool due = schedule_.record_every > 0 && (finished_ || stopped || steps_done_ % schedule_.record_every == 0);
  const bool at_start = resumed() && breaks_.at(start_) && breaks_.at(t_) && breaks_.after(t_) == breaks_.after(start_);
  if (schedule_.record_every > 0) due = due || at_start;
  for (; next_time_ < times.size() && times[next_time_] == t_; ++next_time_) due = true;
  if (!due && !last) return;
  double t = at_start && schedule_.record_every > 0 ? std::max(start_, t_) : t_;
  if (last && resumed()) t = std::max(t, after_start());  // see since_start
  with_time(t_, NAN, [&] {
    if (leapt_ && !stopped) record_in_leap(t, y_);
    else if (finished_) recorder_.record(t, y_);
    else recorder_.record_in_step(t, y_);
  });
}

}  // namespace linkwork
