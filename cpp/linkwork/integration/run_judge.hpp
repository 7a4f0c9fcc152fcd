#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "linkwork/integration/rest.hpp"
#include "linkwork/integration/step_judge.hpp"

namespace linkwork {

/// What the kept steps of a run were off by, and of which part of the run each is.
struct RunErrors {
  std::vector<RunPart> parts;
  std::vector<StepError> steps;
  std::vector<int> part_of;  ///< ascending
  /// By how much the errors of the worst steps are larger than what a first look said of them, at least 1: where
  /// something is not smooth, or steps are very long, two parts of a step are not as much better as Richardson has it.
  double resolved = 1.0;
  StateDifference corrections;    ///< see StepSampling
  double diagonal = 0.0;          ///< the longest of MovingAxes [m]
  double kinetic_share = 1.0;     ///< see StepJudge
  double speed_as_a_whole = 0.0;  ///< of the fastest of MovingAxes [m/s]
  std::optional<Rest> rest;       ///< where there is no motion
};

/// Of kept steps, in their order.
using RetakenSteps = std::vector<RetakenStep>;

/// Called as each step is begun, with the share of the work that is done.
using JudgeProgress = std::function<void(double)>;

/// Judges a run by its kept steps, and then the worst of them once more in smaller parts. Motion is seen from axes that
/// move with the mechanism as a whole.
class RunJudge {
 public:
  /// `dynamics` and `take` as in StepJudge.
  RunJudge(const StepSampling& sampling, Dynamics& dynamics, SecondTake take);

  /// What is to be taken again, and how often the parts of those steps are divided.
  const std::vector<const KeptStep*>& steps() const { return kept_; }
  int divisions() const { return divisions_; }
  void judge(const RetakenSteps& retaken = {});
  void report_to(JudgeProgress progress) { progress_ = std::move(progress); }

  /// After that likewise.
  std::vector<const KeptStep*> worst_steps() const;
  static int worst_divisions();
  RunErrors judge_worst(const RetakenSteps& retaken = {});

 private:
  void see_from_moving_axes();
  double size(const StepError& error) const;
  void look_for_rest();
  StepError judge_next(std::size_t k, int divisions, bool reactions, bool inside, const RetakenStep& retaken);

  Dynamics& dynamics_;
  double length_, speed_ = 0.0;
  std::size_t every_inside_;
  int divisions_;
  std::vector<double> breaks_;  ///< [s]
  StepJudge judge_;
  RunErrors out_;
  std::vector<const KeptStep*> kept_;
  std::vector<std::size_t> worst_;  ///< of them
  JudgeProgress progress_;
  double done_ = 0.0;  ///< parts of steps
};

RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take, JudgeProgress progress = {});

}  // namespace linkwork
