#include "linkwork/integration/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/formulation/not_finite.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double same_time = 1e-9;            // relative to the step: roundoff of t_end / step
constexpr Eigen::Index long_steps = 100'000;  // numbers of a state; shorter steps are not worth to be interrupted

/// Between the passes over all bodies of one step.
void look_where_steps_are_long(Eigen::Index numbers) {
  if (numbers >= long_steps) look_for_interruption();
}

}  // namespace

Simulation::Simulation(Dynamics& dynamics, std::unique_ptr<Integrator> integrator, const Schedule& schedule)
    : Run(dynamics),
      integrator_(std::move(integrator)),
      schedule_(schedule),
      divergence_(dynamics.system()),
      breaks_(dynamics.system().model(), schedule.breaks),
      jumps_(dynamics.system()),
      crossing_(dynamics),
      touches_(dynamics) {
  if (!(schedule.step > 0.0) || !std::isfinite(schedule.step))
    throw OptionError("step", "step must be positive and finite");
  if (!(schedule.t_end >= 0.0) || !std::isfinite(schedule.t_end))
    throw OptionError("t_end", "t_end must be finite and not negative");
  if (schedule.record_every < 1) throw OptionError("record_every", "record_every must be at least 1");
  if (schedule.record_every > 1) recorder_.count_turns();
  begin_at(schedule.t_start, schedule.t_end, schedule.start);
  find_origin();
  count_steps();
  meet_breaks();
  jumped_ = clock();
  y_dot_.setZero(y_.size());
  kept_y_ = y_;
  sampling_.expect(steps_total_);
  if (!integrator_) return;
  integrator_->check_run(dynamics);
  integrator_->start(static_cast<int>(y_.size()));
  sampling_.remember(integrator_->memory());
}

bool Simulation::same(double a, double b) const {
  return std::abs(a - b) <= same_time * schedule_.step + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(a);
}

void Simulation::find_origin() {
  const double h = schedule_.step, start = schedule_.t_start;
  if (std::abs(start / h) < 1e15 && same(start, std::round(start / h) * h))
    first_step_ = static_cast<std::int64_t>(std::round(start / h));
  else origin_ = start;
}

void Simulation::count_steps() {
  const double end = schedule_.t_end, steps = std::ceil((end - schedule_.t_start) / schedule_.step - same_time);
  if (steps > 1e15) throw OptionError("step", "t_end / step is more than 1e15 steps; use a larger step");
  steps_total_ = static_cast<std::int64_t>(steps);
  whole_ = true;
  whole_ = same(end, time_of(steps_total_));
}

void Simulation::meet_breaks() { breaks_.meet_steps(origin_, schedule_.step, {schedule_.t_start, schedule_.t_end}); }

/// Where steps begin and end. `t` differs at both ends of the run by the roundoff of what was asked for.
double Simulation::time_of(std::int64_t step) const {
  if (step >= steps_total_ && !whole_) return schedule_.t_end;
  return origin_ + static_cast<double>(first_step_ + step) * schedule_.step;
}

double Simulation::t() const {
  if (steps_done_ == steps_total_) return schedule_.t_end;
  return steps_done_ == 0 ? schedule_.t_start : time_of(steps_done_);
}

void Simulation::keep(Archive& archive) {
  const double start = schedule_.t_start;
  Run::keep(archive);
  archive(schedule_.t_start, origin_, first_step_, jumped_, leaping_, leapt_);
  if (!integrator_) archive(kept_y_, y_dot_, last_t_);
  crossing_.keep(archive, leaping_ || leapt_);
  if (integrator_) integrator_->keep(archive);
  if (archive.reading()) go_on_to(start);
}

/// Steps are counted as in the run that is resumed, in which the start may be between two of them.
void Simulation::go_on_to(double start) {
  const double h = schedule_.step, done = (start - origin_) / h - static_cast<double>(first_step_);
  count_steps();
  meet_breaks();
  const double jumped = std::exchange(jumped_, clock());  // a run ends before what jumps where it ends
  if (jumped < jumped_) {
    y_[y_.size() - 1] += jumps_.work(jumped, jumped_, y_, dynamics_.history());
    forget();
  }
  evaluated_ = finished_ = false;
  start_ = start;
  start_step_ = static_cast<std::int64_t>(std::ceil(done - same_time));
  if (!same(start, time_of(start_step_))) return;
  given_start_ = start;
  recorder_.take();  // a frame of it comes with the step
  recorder_.silence_until(std::nextafter(start, -INFINITY));
}

/// After what jumps there, before which the run has ended.
void Simulation::record_start() {
  y_[y_.size() - 1] += jumps_.work(breaks_.before(time_of(steps_done_)), clock(), y_, dynamics_.history());
  dynamics_.evaluate(clock(), y_);
  recorder_.record(schedule_.t_start, y_);
}

bool Simulation::recording_due() const {
  return begins() || steps_done_ == steps_total_ || steps_done_ % schedule_.record_every == 0;
}

void Simulation::take_step() {
  const double h = begin_step();
  if (h == 0.0) return;
  try {
    divergence_.blame(kept_y_, t(), h, [&] { with_time(t(), h, [&] { integrator_->step(dynamics_, span(), y_); }); });
    finish_step();
  } catch (const NotFiniteError& error) {
    if (error.code() != Divergence::code) trace_step(h);
    throw;
  }
}

/// The same step once more, looking for the first value that is not finite; what comes of it may be found much later.
void Simulation::trace_step(double h) {
  dynamics_.trace();
  y_ = kept_y_;
  with_time(t(), h, [&] {
    dynamics_.evaluate(clock(), y_);
    integrator_->step(dynamics_, span(), y_);
  });
}

double Simulation::begin_step() {
  while (!finished_) {
    if (!evaluated_ && natural()) mark(steps_done_ == steps_total_ - (whole_ ? 0 : 1));
    look_where_steps_are_long(y_.size());
    dynamics_.correct_over(whole_ || steps_done_ + 1 < steps_total_ ? 0.0 : schedule_.step);
    divergence_.blame(y_, t(), schedule_.step, [&] { with_time(t(), NAN, [&] { evaluate_and_record(); }); });
    finished_ = steps_done_ == steps_total_;
    kept_y_ = y_;
    if (finished_) finish();
    if (finished_) break;
    look_where_steps_are_long(y_.size());
    if (!leaping_) with_time(t(), next_step(), [&] { begin_leap(); });
    if (!leaping_) {
      look_where_steps_are_long(y_.size());
      sampling_.before(dynamics_, y_);
      if (!integrator_) with_time(t(), next_step(), [&] { find_correction(); });
      return next_step();
    }
    follow_leap();
  }
  return 0.0;
}

void Simulation::finish() {
  sampling_.before(dynamics_, y_);
  crossing_.correct_last_frame(recorder_, begins() ? given_start_ : t(), y_);
  if (crossing_.end(t(), y_)) dynamics_.evaluate(clock(), y_);
}

/// Where a singular pose is ahead.
void Simulation::begin_leap() {
  if (!crossing_.due(t(), next_step(), y_, false)) return;
  const double end = dynamics_.system().model().autonomous() ? INFINITY : schedule_.t_end - t();
  const double most = std::min(end, breaks_.room(t(), schedule_.step));
  leaping_ = crossing_.leap(clock(), next_step(), schedule_.step, most, y_);
  bounded_ = bounded_ || crossing_.limited();
  if (!leaping_) return dynamics_.evaluate(clock(), y_);
  sampling_.correct(y_, crossing_.last().y);
  if (crossing_.last().end() > schedule_.t_end) crossing_.cut(schedule_.t_end - t());
  bounded_ = bounded_ || crossing_.limited();
  crossing_.look_into_leap(std::min(crossing_.last().end(), schedule_.t_end));
  crossing_.correct_frame(recorder_, begins() ? given_start_ : t(), y_);
  if (integrator_) integrator_->start(static_cast<int>(y_.size()));
  stop_at_singular_pose();
}

void Simulation::follow_leap() {
  sampling_.pass_over();
  steps_done_ += 1;
  leaping_ = t() < crossing_.last().end() - same_time * schedule_.step;
  if (leaping_) crossing_.interpolate(dynamics_.system(), crossing_.theta(t()), y_);
  else y_ = crossing_.last().y_new;
  cross_breaks();
  leapt_ = true;
  evaluated_ = false;
}

/// In the step that ends here, and at its end. What begins after them has not been together with what was before.
void Simulation::cross_breaks() {
  const double t = std::exchange(jumped_, clock()), t_new = jumped_;
  if (!(breaks_.next(t) <= t_new)) return;
  with_time(t_new, t_new - t,
            [&] { y_[y_.size() - 1] += jumps_.work_in_step(breaks_, t, t_new, kept_y_, y_, dynamics_.history()); });
  forget();
}

void Simulation::forget() {
  if (integrator_) integrator_->start(static_cast<int>(y_.size()));
}

void Simulation::evaluate_and_record() {
  if (evaluated_) return;
  dynamics_.evaluate(clock(), y_);
  look_where_steps_are_long(y_.size());
  look_for_touches();
  accept_state();
  if (!leaping_) monitor_violation(clock());
  evaluated_ = true;
  if (!integrator_) add_work();
  if (recording_due()) record();
  leapt_ = false;
}

void Simulation::look_for_touches() {
  const VectorXd& switches = dynamics_.evaluation().switches;
  if (leapt_ || steps_done_ == 0) return touches_.restart(switches);
  const double t = time_of(steps_done_ - 1);
  touches_.pass(t, time_of(steps_done_) - t, kept_y_, y_, switches);
}

/// StepSizeError: an angle has turned so far that full turns cannot be counted.
void Simulation::accept_state() {
  if (steps_done_ > 0) {
    const double h = time_of(steps_done_) - time_of(steps_done_ - 1), turned = turns_.largest(h);
    if (TurnGuard::too_far(turned)) turns_.refuse(h, turned);
  }
  accept_history();
}

void Simulation::record() {
  const double t = begins() ? given_start_ : this->t();
  if (!leapt_ && (!integrator_ || steps_done_ == steps_total_)) return recorder_.record(t, y_);
  if (!leapt_) return recorder_.record_in_step(t, y_);
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  crossing_.interpolate(crossing_.theta(this->t()), v_dot, lambda);
  recorder_.record(t, y_, v_dot, lambda);
}

void Simulation::finish_step() {
  const System& system = dynamics_.system();
  const double t_new = time_of(steps_done_ + 1);
  look_where_steps_are_long(y_.size());
  if (!y_.allFinite()) with_time(t_new, next_step(), [&] { throw_not_finite(system, y_, t_new); });
  divergence_.check(y_, t_new, next_step());
  system.normalize(y_.head(system.q_size()));
  if (projects())
    with_time(t_new, next_step(), [&] { projection().stabilize(breaks_.clock(t_new, schedule_.t_end), y_); });
  look_where_steps_are_long(y_.size());
  sampling_.after(t(), next_step(), kept_y_, y_);
  look_where_steps_are_long(y_.size());
  with_time(t_new, next_step(), [&] { crossing_.look_back(t(), next_step(), kept_y_); });
  steps_done_ += 1;
  cross_breaks();
  evaluated_ = false;
}

/// Of an integrator of the user's own, which returns only q and v.
void Simulation::add_work() {
  VectorXd before = y_dot_;
  dynamics_.rates(y_dot_);
  if (steps_done_ > 0 && !leapt_) y_.tail<1>()[0] += work_of_step(std::move(before), t() - last_t_);
  last_t_ = t();
}

/// By Simpson's rule, in the middle of the step with the state of Hermite's cubics: of order 4. Euler parameters of one
/// orientation may have either sign.
double Simulation::work_of_step(VectorXd y_dot_before, double h) {
  const double first = y_dot_before.tail<1>()[0], last = y_dot_.tail<1>()[0];
  if (first == 0.0 && last == 0.0) return 0.0;
  VectorXd before = kept_y_;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const int p = position_size * body + 3;
    if (before.segment<4>(p).dot(y_.segment<4>(p)) >= 0.0) continue;
    before.segment<4>(p) *= -1.0;
    y_dot_before.segment<4>(p) *= -1.0;
  }
  const Dynamics::Place end = dynamics_.place();
  VectorXd middle = 0.5 * (before + y_) + 0.125 * h * (y_dot_before - y_dot_), y_dot(y_.size());
  dynamics_.system().normalize(middle.head(dynamics_.system().q_size()));
  dynamics_.formulation().look(true);
  dynamics_.evaluate(t() - 0.5 * h, middle);
  dynamics_.rates(y_dot);
  dynamics_.return_to(end);
  return h / 6.0 * (first + 4.0 * y_dot.tail<1>()[0] + last);
}

/// Apart from the rates, as of multistep methods: nobody knows how an integrator of the user's own combines these.
void Simulation::find_correction() {
  correction_.setZero(y_.size());
  dynamics_.add_correction(next_step(), correction_);
}

void Simulation::accept(const ConstVector& q_and_v) {
  const Eigen::Index size = y_.size() - 1;
  if (q_and_v.size() != size)
    throw OptionError("integrator", "the integrator returned " + std::to_string(q_and_v.size()) + " numbers, not " +
                                        std::to_string(size));
  y_.head(size) = q_and_v + correction_.head(size);
  finish_step();
  stop_at_singular_pose();
}

}  // namespace linkwork
