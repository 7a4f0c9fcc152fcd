#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "linkwork/constraints/redundancy_watch.hpp"
#include "linkwork/formulation/projection.hpp"
#include "linkwork/integration/history_watch.hpp"
#include "linkwork/integration/recorder.hpp"
#include "linkwork/integration/step_sampling.hpp"
#include "linkwork/integration/violation_monitor.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {

/// Redundant rows that contradict the others, by less than a run could not go on with.
struct Contradiction {
  double t = NAN;        ///< when it was noticed [s]
  double largest = 0.0;  ///< violation [m or 1]
  std::vector<int> joints;
};

/// What a run can go on from to the last bit, however it went on or ended after it.
struct Checkpoint {
  double t = NAN;  ///< [s]; NaN: there is none
  std::string state;
};

/// Whether drift stays, of positions or of velocities: the state then goes back to the constraints where other redundant
/// rows are left out. Where a choice has turned bad, little drift of the kept rows is much of those that it leaves out;
/// of these some are kept from then on, with all of that, and it would grow tenfold from choice to choice.
bool keeps_drift(const Dynamics& dynamics);

/// A simulation on its way. `advance` returns now and then so that the caller can show progress, write frames, and end
/// the run.
class Run {
 public:
  explicit Run(Dynamics& dynamics)
      : dynamics_(dynamics),
        recorder_(dynamics),
        sampling_(dynamics),
        y_(dynamics.initial_y()),
        turns_(dynamics),
        stops_(dynamics.options().on_singular == "stop"),
        singular_poses_(dynamics.watch().singular_poses()),
        violation_monitor_(dynamics),
        redundancy_(dynamics.system(), y_.head(dynamics.system().q_size())),
        left_out_(dynamics.dropped().rows()) {
    sampling_.log_states();
  }
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Runs until finished, `max_frames` are there, or `max_seconds` have passed (looked at after each step).
  void run_on(std::int64_t max_frames, double max_seconds);

  /// What was recorded since the last call. At the end also a frame that waits for a step which will not come.
  Frames take_frames(bool at_the_end);

  /// Both.
  Frames advance(std::int64_t max_frames, double max_seconds) {
    run_on(max_frames, max_seconds);
    return take_frames(false);
  }

  /// Frames have reactions. Before the first of them.
  void record_reactions() { recorder_.record_reactions(); }
  /// How far joints turned between frames, where steps are between them; nothing else.
  const TurnCounter* turns() const { return recorder_.turns(); }

  /// Goes on from a checkpoint of a run of the same mechanism by the same method, which this run, before its first
  /// step, need not begin at: it takes the steps of the other once more up to its start, unseen, and the rest as that
  /// one would have taken them. `work` [J] at the start.
  void resume(const std::string& state, double work);
  /// The last one that is not after the last frame that was taken.
  const Checkpoint& checkpoint() const { return settled_; }
  /// The last one of all.
  const Checkpoint& last_checkpoint() const { return std::isnan(latest_.t) ? settled_ : latest_; }

  const Dynamics& dynamics() const { return dynamics_; }
  bool finished() const { return finished_; }
  virtual double t() const = 0;
  /// The last state from which the run went on: y = (q, v, work), where t() is.
  virtual const VectorXd& last_state() const { return y_; }
  virtual std::int64_t steps_total() const { return 0; }  ///< 0: nobody knows
  std::int64_t steps_done() const { return steps_done_ - steps_before_; }
  /// Whether there are steps to be judged: its own, or the one that it goes on inside of.
  bool has_steps() const { return steps_done() > 0 || !sampling_.empty(); }
  const VectorXd& y() const { return y_; }
  const ViolationMonitor& violation_monitor() const { return violation_monitor_; }
  const StepSampling& sampling() const { return sampling_; }
  virtual bool records_inside() const { return false; }  ///< of steps, by an interpolant
  /// See StepSampling; for steps that do not end at breaks.
  void expect_breaks(std::vector<double> times) { sampling_.expect_breaks(std::move(times)); }
  const Contradiction& contradiction() const { return contradiction_; }
  std::int64_t projections() const { return projections_; }  ///< that the violation monitor asked for

 protected:
  Projection& projection() {
    if (!projection_) projection_ = std::make_unique<Projection>(dynamics_);
    return *projection_;
  }
  bool projects() const {
    return projects_positions(dynamics_.stabilization()) || projects_velocities(dynamics_.stabilization());
  }

  /// Accepts the state where `dynamics` is evaluated as the one from which the run goes on.
  void accept_history() {
    dynamics_.advance_history();
    turns_.accept();
    recorder_.pass(t(), y_);
  }

  /// Begins at a state y = (q, v) other than that of the model; nothing where it is empty.
  void begin_at(double t, double t_end, const VectorXd& q_and_v);

  /// With on_singular "stop": SingularSystemError at the first singular pose.
  void stop_at_singular_pose() const;

  /// At t, where `dynamics` is evaluated at y_: compares the violation with the limits. With on_violation "project" y_
  /// goes back to the constraints where it is beyond; with "stop" that is a ViolationError. It also goes back, see
  /// keeps_drift, where others of the redundant rows are left out now. These are judged here, too: where they have become
  /// independent they count from here on, and y_ goes to the nearest state that satisfies them; where they contradict
  /// the others that is a ViolationError.
  void monitor_violation(double t);

  // Between two steps.
  /// `last`: no later state is one of a run that goes on longer.
  void mark(bool last);
  virtual void keep(Archive& archive) { archive(y_, steps_done_, turns_, redundancy_, left_out_, dynamics_); }
  /// Where the run is to begin that has just been resumed from an earlier state: a frame of it.
  virtual void record_start() = 0;
  /// Before the start of a run that was resumed.
  bool repeating() const { return repeating_; }
  bool resumed() const { return resumed_; }
  /// Whether the start is passed or reached by now.
  virtual bool past_start() const = 0;
  virtual double start() const = 0;

  /// The state has changed: multistep methods forget it.
  virtual void forget() {}

  /// A step, or a part of one.
  virtual void take_step() = 0;

  Dynamics& dynamics_;
  Recorder recorder_;
  StepSampling sampling_;
  VectorXd y_;  ///< at t()
  TurnGuard turns_;
  std::int64_t steps_done_ = 0;
  bool finished_ = false;
  bool bounded_ = false;  ///< steps are no longer those of a run that goes on longer

 private:
  void take_back(double t);
  void take_back_where_rows_changed(double t);
  void watch_redundant_rows(double t);
  void take_up_rows(double t, RedundancyExamination found);
  std::vector<int> left_joints() const;
  void note_contradiction(double t, std::vector<int> joints, bool certainly);
  bool stops_;                   ///< at singular poses
  std::int64_t singular_poses_;  ///< before this run
  std::int64_t steps_before_ = 0;
  bool repeating_ = false, resumed_ = false, due_ = true;
  Checkpoint latest_, settled_;
  ViolationMonitor violation_monitor_;
  RedundancyWatch redundancy_;
  std::vector<int> left_out_;  ///< redundant rows, at the last state that was monitored or changed
  Contradiction contradiction_;
  std::int64_t projections_ = 0;
  std::unique_ptr<Projection> projection_;  ///< where one is needed
};

/// Calls `action`; an error that leaves it says when [s], which a stage may know better, and in a step of which size
/// (NaN: none).
template <class Action>
void with_time(double t, double step, Action action) {
  try {
    action();
  } catch (Error& error) {
    if (std::isnan(error.details.time)) error.details.time = t;
    error.details.step = step;
    throw;
  }
}

}  // namespace linkwork
