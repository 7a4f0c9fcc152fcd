#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "linkwork/integration/energies_made.hpp"
#include "linkwork/integration/error_growth.hpp"
#include "linkwork/integration/rest.hpp"
#include "linkwork/integration/step_judge.hpp"

namespace linkwork {

/// What there is to know of a connected part in a run.
struct JudgedPart {
  int first_body = 0;
  double length = 1.0;            ///< half of the box in which its centers of mass move, or its size [m]
  double speed_as_a_whole = 0.0;  ///< of its MovingAxes [m/s]
  double fastest = 1.0;           ///< largest speed in the run, relative to that at the kept steps
  double kinetic = 0.0;           ///< largest energy in the run, as these axes see it [J]
  bool has_laws = false;          ///< of the user's own, which may have a potential but do not tell it
  bool bursts_late = true;        ///< what accelerates it does not come at times of its own: it bounces, or no driver
                                  ///< and no function of time acts there
  double nonlinearity = 1.0;      ///< see find_nonlinearity
  std::optional<Rest> rest;       ///< where there is no motion
  std::optional<EnergyMade> energy;  ///< where the balance of the run does not tell it
  /// By how much the errors of its worst steps are larger than what a first look said of them, at least 1: where
  /// something is not smooth, or steps are very long, two parts of a step are not as much better as Richardson has it.
  double resolved = 1.0;
};

/// What the kept steps of a run were off by, and of which part of the run each is.
struct RunErrors {
  std::vector<RunPart> parts;
  std::vector<StepError> steps;
  std::vector<int> part_of;                 ///< ascending
  std::vector<JudgedPart> connected_parts;  ///< as ConnectedParts
  DifferencesOfParts corrections;           ///< see StepSampling
  double kinetic_share = 1.0;               ///< see StepJudge
  std::vector<ErrorGrowth> growth;          ///< by time; none: not known
};

/// Of kept steps, in their order.
using RetakenSteps = std::vector<RetakenStep>;

/// Called as each step is begun, with the share of the work that is done.
using JudgeProgress = std::function<void(double)>;

/// Judges a run by its kept steps, and then the worst of them once more in smaller parts: those of the connected parts
/// that are worst. Each part is seen from axes that move with it, and judged as if it were alone.
class RunJudge {
 public:
  /// `dynamics` and `take` as in StepJudge; `sampling` is looked at until it has judged.
  RunJudge(const StepSampling& sampling, Dynamics& dynamics, SecondTake take);

  /// What is to be taken again, and how often the parts of those steps are divided.
  const std::vector<const KeptStep*>& steps() const { return kept_; }
  int divisions() const { return divisions_; }
  void judge(const RetakenSteps& retaken = {});
  /// As of StepJudge.
  void compare_with(Dynamics* recorded) { judge_.compare_with(recorded); }
  void report_to(JudgeProgress progress) { progress_ = std::move(progress); }

  /// After that likewise.
  std::vector<const KeptStep*> worst_steps() const;
  static int worst_divisions();
  RunErrors judge_worst(const RetakenSteps& retaken = {});

 private:
  void see_from_moving_axes();
  void look_at_forces();
  bool has_laws() const;
  void look_at_speeds();
  double kinetic_energy(const KeptStep& step, const VectorXd& y);
  double size(const StepError& error, std::size_t part) const;
  std::vector<std::size_t> worst_of(std::size_t part) const;
  void acquit_suspects();
  void find_worst();
  void look_for_rest();
  void look_at_energies();
  void look_for_nonlinearity();
  std::vector<StepDifference> errors_to_follow(std::size_t count, double until) const;
  void look_for_growth();
  StepError judge_next(std::size_t k, int divisions, bool reactions, bool inside, const RetakenStep& retaken);

  const StepSampling& sampling_;
  Dynamics& dynamics_;
  VectorXd lengths_, speeds_;  ///< of the connected parts
  std::size_t every_inside_;
  int divisions_;
  std::vector<double> breaks_;  ///< [s]
  StepJudge judge_;
  RunErrors out_;
  std::vector<const KeptStep*> kept_;
  std::vector<StepDifference> ends_;  ///< of these, where states are logged
  std::size_t suspects_ = 0;          ///< of these
  struct WorstOfPart {
    std::size_t part;
    std::vector<std::size_t> steps;
  };
  std::vector<WorstOfPart> worst_of_parts_;  ///< of the worst parts
  std::vector<std::size_t> worst_;           ///< steps of any of these
  JudgeProgress progress_;
  double done_ = 0.0;  ///< parts of steps
};

/// `recorded`: see StepJudge.
RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take, JudgeProgress progress = {},
                    Dynamics* recorded = nullptr);

}  // namespace linkwork
