#pragma once

#include <vector>

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
  StateDifference corrections;  ///< see StepSampling
  double diagonal = 0.0;        ///< see StepJudge
};

/// `dynamics` and `take` as in StepJudge.
RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take);

}  // namespace linkwork
