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

/// The parts of a run whose kept steps are taken again, and how often those steps are divided.
std::vector<RunPart> parts_to_judge(const StepSampling& sampling);
int divisions(const StepSampling& sampling);

/// Calls f with the kept steps of parts, in order, and the place of their part.
template <class Function>
void each_kept_step(const std::vector<RunPart>& parts, const Function& f) {
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (const KeptStep* step : {&parts[k].any, &parts[k].steepest})
      if (step->kept()) f(*step, static_cast<int>(k));
}

/// `dynamics` and `take` as in StepJudge; `retaken`: where the steps in the order of each_kept_step end in parts, empty
/// where that has to be found.
RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take,
                    const std::vector<VectorXd>& retaken = {});

}  // namespace linkwork
