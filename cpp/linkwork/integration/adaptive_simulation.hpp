#pragma once

#include <limits>
#include <string>
#include <vector>

#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/integration/run.hpp"
#include "linkwork/integration/step_control.hpp"

namespace linkwork {

/// How far to go, how exactly, and what to keep. Times in s. One of `record_every` and `times` says which states are
/// recorded; output never limits the step.
struct AdaptiveSchedule {
  double t_end = 0.0;
  Tolerances tolerances;
  double largest_step = std::numeric_limits<double>::infinity();
  std::int64_t record_every = 0;  ///< steps between frames, the first and the last state included; 0: `times`
  std::vector<double> times;      ///< ascending; states between steps come from the interpolant
};

/// Of the accepted steps, and how many were rejected.
struct StepStatistics {
  std::int64_t rejected = 0;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
};

/// A run with steps as large as the tolerances allow.
class AdaptiveSimulation final : public Run {
 public:
  AdaptiveSimulation(Dynamics& dynamics, const EmbeddedPair& pair, const AdaptiveSchedule& schedule);

  double t() const override { return t_; }
  const StepStatistics& step_statistics() const { return statistics_; }

 private:
  void work() override;
  void begin();
  double initial_step();
  void attempt();
  BodyMaximum trial(double h);
  void accept(double h, double error);
  void reject(double h, const BodyMaximum& error);
  [[noreturn]] void throw_step_size(const BodyMaximum& error) const;
  bool output_inside() const;
  void record_inside();
  void finish_step();
  void evaluate(double t, const VectorXd& y);
  void record_if_due();

  AdaptiveSchedule schedule_;
  PairStepper stepper_;
  ErrorMeasure measure_;
  StepController controller_;
  StepStatistics statistics_;
  double t_ = 0.0, t_new_ = 0.0;
  double step_ = 0.0;  ///< what the controller proposes
  bool begun_ = false;
  bool accepted_ = false;   ///< the stepper holds the step from t_ to t_new_
  bool evaluated_ = false;  ///< `dynamics` is at the state that comes next: y_, or y_new when accepted
  std::size_t next_time_ = 0;
  std::string last_failure_;  ///< of a stage of the last trial
  VectorXd work_, rates_;
};

}  // namespace linkwork
