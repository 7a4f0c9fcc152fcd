#pragma once

#include <functional>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane.hpp"
#include "linkwork/ensemble/lane_projection.hpp"
#include "linkwork/ensemble/lane_stepper.hpp"
#include "linkwork/integration/run_judge.hpp"

namespace linkwork {

/// Takes kept steps of several runs again, in parts and side by side, as StepJudge does: steps of one run after the
/// other, each beside those of the other runs. What the lanes cannot do is left to StepJudge: steps with other redundant
/// rows or another number of parts, history variables, suspicious pivots.
class LaneRetake final : private LaneGuard {
 public:
  /// The runs, at most as many as registers have lanes, took their steps by this method.
  LaneRetake(const LaneStructure& structure, const InstructionSet& instructions, const std::vector<LaneRun*>& runs,
             const ButcherTableau& tableau);

  struct Step {
    const KeptStep* kept;
    bool rows_change;  ///< see RetakenStep
  };

  /// The steps of each run in parts that are divided so many times. `look` is called between steps; what it throws ends
  /// it.
  std::vector<RetakenSteps> retake(const std::vector<std::vector<Step>>& steps, int divisions,
                                   const std::function<void()>& look);

 private:
  struct Lane {
    LaneRun* run;
    StepParts parts;
    const KeptStep* step = nullptr;  ///< that is taken
    std::vector<StepSpan> spans;
    bool active = false, looked = false;
    double smallest_pivot = 1.0;
  };

  bool steps(int l) const override { return lanes_[l].active; }
  bool looked(int l) const override { return lanes_[l].looked; }
  void note(int l, double t, double pivot, bool first) override;
  void leave(int l, double, std::string) override { lanes_[l].active = false; }

  void begin(int l, const Step& step, std::size_t parts);
  void take(std::size_t parts);
  void hold();

  const LaneStructure& structure_;
  LaneStepper stepper_;
  LaneProjection projection_;
  LaneSpans spans_;
  AlignedDoubles shares_, ends_;
  std::vector<Lane> lanes_;
};

/// Judges runs, at most as many as registers have lanes, with the errors of their steps side by side. `structures`: what
/// they had on their way, which differ in the rows that are left out.
void judge_runs(const std::vector<const LaneStructure*>& structures, const InstructionSet& instructions,
                const std::vector<LaneRun*>& runs, const ButcherTableau& tableau, const std::function<void()>& look);

}  // namespace linkwork
