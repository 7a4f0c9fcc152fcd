#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "linkwork/integration/break_points.hpp"
#include "linkwork/integration/crossing.hpp"
#include "linkwork/integration/divergence.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/integration/run.hpp"
#include "linkwork/integration/stored_energy_jumps.hpp"
#include "linkwork/integration/touch_monitor.hpp"

namespace linkwork {

/// When to step and what to keep. Times in s.
struct Schedule {
  double t_end = 0.0;
  double step = 0.0;
  std::int64_t record_every = 1;  ///< steps between frames; the first and the last state are always recorded
  double t_start = 0.0;
  VectorXd start = {};              ///< y = (q, v) at t_start; empty: that of the model
  std::vector<double> breaks = {};  ///< times at which something is not smooth, beside those that the model knows
};

/// A run with a fixed step: t_n = n h exactly, a shortened last step where t_end is no multiple of h. A run that starts
/// at a multiple of h goes on counting there, so that it takes the steps of one that started at 0. A break at which a
/// step ends is between two steps, each of which sees its own side of it.
class Simulation final : public Run {
 public:
  Simulation(Dynamics& dynamics, std::unique_ptr<Integrator> integrator, const Schedule& schedule);

  double t() const override;
  const VectorXd& last_state() const override { return kept_y_; }
  double origin() const { return origin_; }  ///< from which steps are counted [s]
  std::int64_t steps_total() const override { return steps_total_ - start_step_; }
  const std::vector<PassedTouch>& passed_touches() const { return touches_.passed(); }

  // For an integrator of the user's own: begin_step, then accept with the new (q, v).
  /// Size of the step that begins here; 0 at the end.
  double begin_step();
  void accept(const ConstVector& q_and_v);

 private:
  void take_step() override;
  void forget() override;
  void keep(Archive& archive) override;
  void record_start() override;
  bool past_start() const override { return steps_done_ >= start_step_; }
  double start() const override { return start_; }
  /// With the state at which a resumed run starts.
  bool begins() const { return steps_done_ == start_step_ && !std::isnan(given_start_); }
  bool natural() const { return whole_ || steps_done_ < steps_total_; }
  double time_of(std::int64_t step) const;
  /// Where functions are evaluated for what begins at t().
  double clock() const { return breaks_.clock(time_of(steps_done_), schedule_.t_end); }
  StepSpan span() const { return breaks_.span(time_of(steps_done_), time_of(steps_done_ + 1)); }
  double next_step() const { return time_of(steps_done_ + 1) - time_of(steps_done_); }
  bool recording_due() const;
  void find_origin();
  void count_steps();
  void meet_breaks();
  bool same(double a, double b) const;
  void go_on_to(double start);
  void evaluate_and_record();
  void look_for_touches();
  void accept_state();
  void record();
  void finish_step();
  void finish();
  void cross_breaks();
  void begin_leap();
  void follow_leap();
  void add_work();
  double work_of_step(VectorXd y_dot_before, double h);
  void find_correction();
  void trace_step(double h);

  std::unique_ptr<Integrator> integrator_;  ///< null for the user's own
  Schedule schedule_;
  Divergence divergence_;
  double origin_ = 0.0;
  std::int64_t first_step_ = 0;  ///< in this count
  bool whole_ = false;           ///< the last step is not shortened
  std::int64_t steps_total_ = 0;
  std::int64_t start_step_ = 0;  ///< of a run that was resumed, the first that is not before its start
  double start_ = NAN;           ///< its start,
  double given_start_ = NAN;     ///< where that is the end of a step
  BreakPoints breaks_;
  double jumped_ = 0.0;  ///< up to when the work of what jumps at breaks is counted [s]
  StoredEnergyJumps jumps_;
  Crossing crossing_;
  TouchMonitor touches_;
  bool evaluated_ = false;
  bool leaping_ = false;  ///< over a singular pose: states come from the leap
  bool leapt_ = false;    ///< to the present state
  double last_t_ = 0.0;
  VectorXd y_dot_, correction_;  ///< of an integrator of the user's own, where the step begins
  VectorXd kept_y_;              ///< at the start of the step
};

}  // namespace linkwork
