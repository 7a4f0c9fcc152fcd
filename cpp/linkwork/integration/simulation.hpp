#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "linkwork/integration/integrator.hpp"

namespace linkwork {

/// Recorded states, one after the other (frame by frame).
struct Frames {
  std::vector<double> t;
  std::vector<double> q, v, v_dot, lambda;  ///< 7 n, 6 n, 6 n and rows numbers a frame
  std::vector<double> kinetic, potential, work;
  std::vector<double> violation;  ///< 3 a frame: max |Phi|, max |Phi_dot|, max |D v_dot - gamma|
};

/// When to step and what to keep. Times in s.
struct Schedule {
  double t_end = 0.0;
  double step = 0.0;
  std::int64_t record_every = 1;  ///< steps between frames; the first and the last state are always recorded
};

/// A run with a fixed step: t_n = n h exactly, a shortened last step where t_end is no multiple of h.
/// `advance` returns now and then so that the caller can show progress, write frames, and end the run.
class Simulation {
 public:
  Simulation(Dynamics& dynamics, std::unique_ptr<Integrator> integrator, const Schedule& schedule);

  /// Runs until finished, `max_frames` are there, or `max_seconds` have passed (looked at after each step).
  Frames advance(std::int64_t max_frames, double max_seconds);

  /// What was recorded since the last call (for an integrator of the user's own).
  Frames take_frames() { return std::exchange(frames_, {}); }

  const Dynamics& dynamics() const { return dynamics_; }
  bool finished() const { return finished_; }
  double t() const { return time_of(steps_done_); }
  std::int64_t steps_done() const { return steps_done_; }
  std::int64_t steps_total() const { return steps_total_; }
  const VectorXd& y() const { return y_; }

  // For an integrator of the user's own: begin_step, then accept with the new (q, v).
  /// Size of the step that begins here; 0 at the end.
  double begin_step();
  void accept(const ConstVector& q_and_v);

 private:
  double time_of(std::int64_t step) const;
  double next_step() const { return time_of(steps_done_ + 1) - time_of(steps_done_); }
  bool recording_due() const;
  void evaluate_and_record();
  void finish_step();
  void add_work();

  Dynamics& dynamics_;
  std::unique_ptr<Integrator> integrator_;  ///< null for the user's own
  Schedule schedule_;
  std::int64_t steps_total_ = 0, steps_done_ = 0;
  bool finished_ = false, evaluated_ = false;
  double last_power_ = 0.0, last_t_ = 0.0;
  VectorXd y_, v_dot_, lambda_, y_dot_;
  Frames frames_;
};

}  // namespace linkwork
