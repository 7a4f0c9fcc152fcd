#include "linkwork/ensemble/lane.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "linkwork/ensemble/lane_guard.hpp"
#include "linkwork/integration/run.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double same_time = 1e-9;  // as in Simulation
constexpr const char* small_pivot = "a small pivot: the pose may be singular";

}  // namespace

FixedSteps::FixedSteps(double t_end, double step, std::int64_t record_every, std::vector<double> breaks)
    : t_end_(t_end), step_(step), record_every_(record_every), breaks_(std::move(breaks)) {
  if (!(step > 0.0) || !std::isfinite(step)) throw OptionError("step", "step must be positive and finite");
  if (!(t_end >= 0.0) || !std::isfinite(t_end)) throw OptionError("t_end", "t_end must be finite and not negative");
  if (record_every < 1) throw OptionError("record_every", "record_every must be at least 1");
  const double steps = std::ceil(t_end / step - same_time);
  if (steps > 1e15) throw OptionError("step", "t_end / step is more than 1e15 steps; use a larger step");
  count_ = static_cast<std::int64_t>(steps);
  const double end = static_cast<double>(count_) * step;
  whole_ = std::abs(t_end - end) <= same_time * step + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t_end);
}

LaneRun::LaneRun(Dynamics& mechanism, const FixedSteps& steps, bool keeps_balance, bool follows_errors)
    : dynamics(mechanism),
      fixed_steps(steps),
      balanced(keeps_balance),
      sampling(mechanism),
      touches(mechanism),
      y(mechanism.initial_y()) {
  sampling.expect(steps.count());
  if (follows_errors) sampling.log_states();
}

Lane::Lane(Dynamics& dynamics, const FixedSteps& steps, LaneRun* run)
    : dynamics_(dynamics),
      recorder_(dynamics),
      breaks_(dynamics.system().model(), steps.breaks()),
      jumps_(dynamics.system()),
      crossing_(dynamics),
      redundancy_(dynamics.system(), dynamics.initial_y().head(dynamics.system().q_size())),
      turns_(dynamics),
      divergence_(dynamics.system()),
      run_(run),
      limits_(dynamics.options().violation_limit),
      stops_(dynamics.options().on_singular == "stop") {
  breaks_.meet_steps(0.0, steps.step(), {0.0, steps.t_end()});
}

void Lane::leave(double t, std::string reason) {
  if (!alive_) return;
  alive_ = false;
  left_at_ = t;
  reason_ = std::move(reason);
}

template <class Action>
void Lane::guarded(double t, Action action) {
  do_apart(action, [&](std::string why) { leave(t, std::move(why)); });
}

void Lane::accept(double t, double last_step) {
  if (dynamics_.system().history_size() == 0) return;
  if (last_step > 0.0 && TurnGuard::too_far(turns_.largest(last_step)))
    return leave(t, "an angle turns too far in a step");
  dynamics_.advance_history();
  turns_.accept();
}

void Lane::watch_redundant_rows(double t, const VectorXd& y) {
  const System& system = dynamics_.system();
  const auto v = y.segment(system.q_size(), system.v_size());
  if (redundancy_.suspicious(system, dynamics_.evaluation(), dynamics_.dropped(), v))
    leave(t, "redundant equations are violated more than the others");
}

void Lane::watch_limits(double t, const VectorXd& Phi, const VectorXd& Phi_dot) {
  const auto beyond = [](const VectorXd& violation, double limit) { return (violation.array().abs() > limit).any(); };
  if (beyond(Phi, limits_[0])) leave(t, "positions are violated by more than their violation_limit");
  else if (beyond(Phi_dot, limits_[1])) leave(t, "velocities are violated by more than their violation_limit");
}

void Lane::record(double t, double frame_t, const VectorXd& y, bool last) {
  guarded(t, [&] {
    dynamics_.evaluate(t, y);
    recording_ = !last && !leapt_;
    if (recording_) return recorder_.record_in_step(frame_t, y);
    if (!leapt_) return recorder_.record(frame_t, y);
    VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
    crossing_.interpolate(crossing_.theta(frame_t), v_dot, lambda);
    recorder_.record(frame_t, y, v_dot, lambda);
  });
}

/// As a run records in the course of a step: by solving once more with the factors of the step. Those of the first step
/// are what later pivots are compared with, and count whatever their own.
void Lane::finish_record(double t, bool first) {
  if (!std::exchange(recording_, false)) return;
  std::optional<Unwatched> unwatched;
  if (first) unwatched.emplace(dynamics_);
  dynamics_.formulation().look(true);
  guarded(t, [&] {
    if (!leaping_) dynamics_.factorize();
    dynamics_.observe_now();
  });
  dynamics_.formulation().look(false);
}

void Lane::balance(std::int64_t step, const VectorXd& y, double potential) {
  if (step < next_balance_ || !run_ || !run_->balanced) return;
  next_balance_ = run_->fixed_steps.next_record(step);
  if (step < next_balance_) return;
  next_balance_ += 1;
  const double t = run_->fixed_steps.frame_time(step);
  const System& system = dynamics_.system();
  guarded(t, [&] {
    if (leaping_ || leapt_) {  // the pack has not evaluated its forces
      dynamics_.evaluate(breaks_.clock(t, run_->fixed_steps.t_end()), y);
      potential = dynamics_.evaluation().potential;
    }
    EnergyFrames& out = run_->balance;
    out.t.push_back(t);
    out.kinetic.push_back(system.kinetic_energy(dynamics_.evaluation(), y.segment(system.q_size(), system.v_size())));
    out.potential.push_back(potential);
    out.work.push_back(y[y.size() - 1]);
  });
}

void Lane::sample(const VectorXd& y, double kinetic, double potential, const VectorXd& switches) {
  if (run_) run_->sampling.before(dynamics_, y, kinetic, potential, switches);
}

void Lane::look_for_touches(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& switches) {
  if (!run_ || switches.size() == 0) return;
  if (h == 0.0 || leaping_ || leapt_) return run_->touches.restart(switches);
  guarded(t, [&] { run_->touches.pass(t, h, y, y_new, switches); });
}

void Lane::sample_step(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates) {
  if (!run_) return;
  run_->sampling.after(t, h, y, y_new, rates);
  run_->steps += 1;
}

/// The state of a step, to which a look brings the dynamics, which have else nothing to do with it.
class Lane::StepStart final : public Arrival {
 public:
  /// `evaluated`: they are there.
  StepStart(Dynamics& dynamics, double t, const VectorXd& y, bool evaluated, StageFactors* factors)
      : dynamics_(dynamics), t_(t), y_(y), arrived_(evaluated), factors_(factors) {}

  /// With the forces, which leaps and passages look at.
  const VectorXd& arrive() override {
    if (std::exchange(arrived_, true)) return y_;
    dynamics_.evaluate(t_, y_);
    if (looked_) factorize_as_looked();
    return y_;
  }

  std::optional<double> least_singular_value() override {
    if (arrived_ || !factors_) return {};
    const auto solve = [this](const ConstVector& b, MutableVector x, MutableVector lambda) {
      factors_->solve(b, x, lambda);
    };
    const auto found = dynamics_.formulation().least_singular_value(t_, factors_->smallest_pivot(), solve);
    looked_ = found.has_value();
    return found;
  }

  /// Whether there are factors in this state: of a run by itself these would be its own.
  bool factorized() const { return arrived_ ? dynamics_.formulation().factorized() : looked_; }

 private:
  /// The watch has heard of it.
  void factorize_as_looked() {
    const Unwatched unwatched(dynamics_);
    dynamics_.factorize();
  }

  Dynamics& dynamics_;
  double t_;
  const VectorXd& y_;
  bool arrived_, looked_ = false;
  StageFactors* factors_;
};

/// As Simulation does.
void Lane::look_ahead(std::int64_t at, const FixedSteps& steps, const Speeds& speeds, const VectorXd& y,
                      StageFactors* factors) {
  const double t = steps.time(at), h = steps.size(at), clock = breaks_.clock(t, steps.t_end());
  const bool changed = std::exchange(changed_, false);
  StepStart start(dynamics_, clock, y, recording_, changed ? nullptr : factors);
  const std::int64_t changes = dynamics_.watch().row_changes(), poses = dynamics_.watch().singular_poses();
  guarded(t, [&] {
    if (crossing_.due(t, h, speeds, false, start)) {
      const double end = dynamics_.system().model().autonomous() ? INFINITY : steps.t_end() - t;
      const double most = std::min(end, breaks_.room(t, steps.step()));
      leaping_ = crossing_.leap(clock, h, steps.step(), most, y);
      if (leaping_) begin_leap(at, steps, y);
      else dynamics_.evaluate(clock, y);
    }
    moves_ = changed || dynamics_.watch().row_changes() != changes;
    if (moves_) leave_with_drift(t);
    if (!leaping_ && dynamics_.watch().singular_poses() != poses) leave(t, "the motion is in a singular pose");
    looked_ = !leaping_ && start.factorized();
  });
}

/// Where other rows are left out: a run by itself goes back to the constraints.
void Lane::leave_with_drift(double t) {
  if (keeps_drift(dynamics_)) leave(t, "other redundant equations are left out");
}

void Lane::move(std::int64_t step, const VectorXd& y) {
  joins_at_ = step;
  joining_state_ = y;
}

void Lane::wait() {
  moves_ = false;
  waits_ = true;
}

void Lane::begin_leap(std::int64_t at, const FixedSteps& steps, const VectorXd& y) {
  const double t = steps.time(at);
  if (stops_) return leave(t, "a singular pose is ahead");
  if (run_) run_->sampling.correct(y, crossing_.last().y);
  if (crossing_.last().end() > steps.t_end()) crossing_.cut(steps.t_end() - t);
  crossing_.look_into_leap(std::min(crossing_.last().end(), steps.t_end()));
  crossing_.correct_frame(recorder_, steps.frame_time(at), y);
}

void Lane::follow_leap(double t, double step, VectorXd& y) {
  if (run_) {
    run_->sampling.pass_over();
    run_->steps += 1;
  }
  leapt_ = true;
  leaping_ = t < crossing_.last().end() - same_time * step;
  if (!leaping_) {
    y = crossing_.last().y_new;
    return;
  }
  crossing_.interpolate(dynamics_.system(), crossing_.theta(t), y);
  guarded(t, [&] { dynamics_.evaluate(t, y); });
}

void Lane::note(double t, double pivot, bool first_stage) {
  if (!(pivot > singular_pivot)) return leave(t, "the equations are singular");
  if (first_stage && looked_) return;
  SingularWatch& watch = dynamics_.formulation().watch();
  watch.note(t, pivot);
  if (watch.doubts_first(pivot)) dynamics_.formulation().examine_first(pivot);
  if (!watch.usual(pivot)) leave(t, small_pivot);
}

/// One may be no longer usual beside larger ones before it.
void Lane::hear(const std::vector<std::pair<double, double>>& pivots) {
  SingularWatch& watch = dynamics_.formulation().watch();
  for (const auto& [t, pivot] : pivots) {
    watch.note(t, pivot);
    if (!watch.usual(pivot)) leave(t, small_pivot);
  }
}

SingularWatch::Range Lane::usual_pivots() const {
  static const double least = std::nextafter(singular_pivot, 1.0);
  SingularWatch::Range out = dynamics_.watch().usual_pivots();
  out.least = std::max(out.least, least);
  return out;
}

void Lane::look_back(double t, double h, const VectorXd& y) {
  const std::int64_t changes = dynamics_.watch().row_changes(), poses = dynamics_.watch().singular_poses();
  guarded(t, [&] { crossing_.look_back(t, h, y); });
  changed_ = dynamics_.watch().row_changes() != changes;
  if (changed_) leave_with_drift(t);
  if (stops_ && dynamics_.watch().singular_poses() != poses) leave(t, "a singular pose was passed");
}

double Lane::work_at_breaks(double t, double t_new, const VectorXd& y, const VectorXd& y_new) {
  double out = 0.0;
  guarded(t, [&] { out = jumps_.work_in_step(breaks_, t, t_new, y, y_new, dynamics_.history()); });
  return out;
}

void Lane::check(double t, double h, const VectorXd& y) {
  guarded(t, [&] { divergence_.check(y, t, h); });
}

void Lane::end(double t, const VectorXd& y) {
  if (run_) {
    run_->t = t;
    run_->y = y;
  }
  if (!watches()) return;
  const std::int64_t poses = dynamics_.watch().singular_poses();
  guarded(t, [&] {
    crossing_.correct_last_frame(recorder_, t, y);
    crossing_.end(t, y);
  });
  if (stops_ && dynamics_.watch().singular_poses() != poses) leave(t, "the motion ends in a singular pose");
}

}  // namespace linkwork
