#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "linkwork/constraints/redundancy_watch.hpp"
#include "linkwork/integration/break_points.hpp"
#include "linkwork/integration/crossing.hpp"
#include "linkwork/integration/divergence.hpp"
#include "linkwork/integration/history_watch.hpp"
#include "linkwork/integration/recorder.hpp"
#include "linkwork/integration/run_judge.hpp"
#include "linkwork/integration/step_sampling.hpp"
#include "linkwork/integration/stored_energy_jumps.hpp"
#include "linkwork/integration/touch_monitor.hpp"

namespace linkwork {

/// When to step and what to keep, from t = 0.
class FixedSteps {
 public:
  /// OptionError: sizes that make no sense.
  FixedSteps(double t_end, double step, std::int64_t record_every, std::vector<double> breaks = {});

  std::int64_t count() const { return count_; }
  double step() const { return step_; }
  double t_end() const { return t_end_; }
  /// Times at which something is not smooth, beside those that models know.
  const std::vector<double>& breaks() const { return breaks_; }
  /// As Simulation counts them.
  double time(std::int64_t step) const {
    return step >= count_ && !whole_ ? t_end_ : static_cast<double>(step) * step_;
  }
  double size(std::int64_t step) const { return time(step + 1) - time(step); }
  /// See Dynamics::correct_over.
  double correction_length(std::int64_t step) const { return whole_ || step + 1 < count_ ? 0.0 : step_; }
  bool records(std::int64_t step) const { return step == count_ || step % record_every_ == 0; }
  /// The first step from this one on that does.
  std::int64_t next_record(std::int64_t step) const {
    return std::min((step + record_every_ - 1) / record_every_ * record_every_, count_);
  }
  /// Where frames are not at every step, turns of joints between them are counted.
  void count_turns() { counts_turns_ = record_every_ > 1; }
  bool counts_turns() const { return counts_turns_; }
  /// Of a frame.
  double frame_time(std::int64_t step) const { return step == count_ ? t_end_ : time(step); }

 private:
  double t_end_, step_;
  std::int64_t record_every_, count_ = 0;
  std::vector<double> breaks_;
  bool whole_ = false, counts_turns_ = false;
};

/// Energies at some times of a run [J], as of its frames.
struct EnergyFrames {
  std::vector<double> t, kinetic, potential, work;
};

/// What the verdict of a lane is made of, as that of a Run.
struct LaneRun {
  /// `steps`: records are those at which energies are kept; `balanced`: whether they are. `follows_errors`:
  /// as a Run does.
  LaneRun(Dynamics& mechanism, const FixedSteps& steps, bool balanced, bool follows_errors);

  Dynamics& dynamics;
  FixedSteps fixed_steps;
  bool balanced;
  EnergyFrames balance;  ///< for runs whose frames are too few to see it
  StepSampling sampling;
  TouchMonitor touches;
  double t = 0.0;
  VectorXd y;  ///< at t, the end
  std::int64_t steps = 0;
  std::optional<RunErrors> errors;  ///< of its steps, where they have been taken again
};

/// The first stage of a lane's step, as the pack factorizes it.
class StageFactors {
 public:
  virtual ~StageFactors() = default;
  /// 0 where a run by itself would have another order of elimination.
  virtual double smallest_pivot() = 0;
  /// M x - D^T lambda = 0, D x = b.
  virtual void solve(const ConstVector& b, MutableVector x, MutableVector lambda) = 0;
};

/// One mechanism of an ensemble: what watches it, as a single run is watched, and what is recorded of it. Whatever a
/// single run would do otherwise than take its steps makes it leave; the single run is then the one to ask.
class Lane {
 public:
  /// `run`, if any, refers to the same `dynamics`, and hears of every step.
  Lane(Dynamics& dynamics, const FixedSteps& steps, LaneRun* run = nullptr);

  Dynamics& dynamics() { return dynamics_; }
  const BreakPoints& breaks() const { return breaks_; }
  bool alive() const { return alive_ && !moves_; }
  /// Whether other rows are left out than by the pack, since the end of its last step.
  bool changed() const { return changed_; }
  /// Why it left, in words; empty where it did not, and when [s].
  const std::string& reason() const { return reason_; }
  double left_at() const { return left_at_; }
  void leave(double t, std::string reason);
  Frames take_frames() { return recorder_.take(); }
  void count_turns() { recorder_.count_turns(); }
  /// None where they are not counted.
  const TurnCounter* turns() const { return recorder_.turns(); }
  bool watches() const { return crossing_.watches(); }
  /// Whether the stage that comes was looked at ahead, and is factorized there already.
  bool looked() const { return looked_; }
  /// Over a singular pose: what the pack makes of the lane meanwhile is nothing.
  bool leaping() const { return leaping_; }
  /// Takes the pack's steps.
  bool stepping() const { return alive() && !leaping_ && !waits_; }

  // Where other equations became the redundant ones, at a step that had begun, it goes on in a pack of its structure.
  bool moves() const { return alive_ && moves_; }
  /// From the state there.
  void move(std::int64_t step, const VectorXd& y);
  /// In a pack whose steps have not come so far.
  void wait();
  bool waits() const { return waits_; }
  void join() { waits_ = false; }
  std::int64_t joins_at() const { return joins_at_; }  ///< -1 before it moved
  const VectorXd& joining_state() const { return joining_state_; }

  // At the start of a step, in this order, with the evaluation of `begin`.
  Evaluation& begin(double t, const VectorXd& y) { return dynamics_.begin_elsewhere(t, y); }
  /// Of the history variables.
  void accept(double t, double last_step);
  /// It goes on from the state y.
  void pass(double t, const VectorXd& y) { recorder_.pass(t, y); }
  // Of Phi and Phi_dot, where rows are redundant: whether those of one are as usual; else of all.
  bool usual_in_redundant_row(double Phi, double Phi_dot) const { return redundancy_.usual(Phi, Phi_dot); }
  void watch_redundant_rows(double t, const VectorXd& y);
  /// Whether violations of positions or velocities have a limit; a run by itself does what is to be done beyond it.
  bool limited() const { return std::isfinite(limits_[0]) || std::isfinite(limits_[1]); }
  void watch_limits(double t, const VectorXd& Phi, const VectorXd& Phi_dot);
  /// A frame of a state from which a step goes on waits for what is found ahead of it.
  void record(double t, double frame_t, const VectorXd& y, bool last);
  void finish_record(double t, bool first);
  /// Energies, where the verdict looks at them.
  void balance(std::int64_t step, const VectorXd& y, double potential);
  /// One step of a leap, to its state at t, or to where it ends.
  void follow_leap(double t, double step, VectorXd& y);
  bool judged() const { return run_ != nullptr; }
  LaneRun* run() const { return run_; }
  /// For the verdict.
  void sample(const VectorXd& y, double kinetic, double potential, const VectorXd& switches);
  /// The same of the step h from (t, y) to y_new, where the switches are these; h = 0: there was none.
  void look_for_touches(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& switches);
  void sample_step(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates);
  /// Singular poses ahead of a step from the state y. `factors`, where there are any, spare the lane its own.
  void look_ahead(std::int64_t at, const FixedSteps& steps, const Speeds& speeds, const VectorXd& y,
                  StageFactors* factors);
  const std::vector<char>& in_loops() const { return crossing_.in_loops(); }  ///< see Crossing
  const Eigen::Matrix3Xd& rotors() const { return crossing_.rotors(); }       ///< see rotor_axes
  void expect_nothing() { looked_ = leapt_ = false; }

  /// The smallest pivot of a stage at t.
  void note(double t, double pivot, bool first_stage);
  /// Of those from the least of this range on `hear` is enough where there is one, if anything: not of a first stage
  /// that was looked at.
  SingularWatch::Range usual_pivots() const;
  void hear(const std::vector<std::pair<double, double>>& pivots);  ///< with their times
  /// What breaks in a step from (t, y) to (t_new, y_new) do, see StoredEnergyJumps [J].
  double work_at_breaks(double t, double t_new, const VectorXd& y, const VectorXd& y_new);
  /// Whether they may do anything.
  bool has_jumps() const { return jumps_.any(); }
  /// After a step.
  void look_back(double t, double h, const VectorXd& y);
  void check(double t, double h, const VectorXd& y);
  void end(double t, const VectorXd& y);

 private:
  class StepStart;

  template <class Action>
  void guarded(double t, Action action);
  void leave_with_drift(double t);
  void begin_leap(std::int64_t at, const FixedSteps& steps, const VectorXd& y);

  Dynamics& dynamics_;
  Recorder recorder_;
  BreakPoints breaks_;
  StoredEnergyJumps jumps_;
  Crossing crossing_;
  RedundancyWatch redundancy_;
  TurnGuard turns_;
  Divergence divergence_;
  LaneRun* run_;
  std::array<double, 3> limits_;  ///< of violations, see Options
  bool alive_ = true, looked_ = false, stops_;
  bool leaping_ = false, leapt_ = false;  ///< as in Simulation
  bool recording_ = false;                ///< evaluated, with a frame that waits
  bool changed_ = false;
  bool moves_ = false, waits_ = false;             ///< between two packs; in the next one
  std::int64_t joins_at_ = -1, next_balance_ = 0;  ///< steps
  VectorXd joining_state_;
  double left_at_ = NAN;
  std::string reason_;
};

}  // namespace linkwork
