#pragma once

#include <functional>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane.hpp"
#include "linkwork/ensemble/lane_stepper.hpp"
#include "linkwork/integration/run_judge.hpp"

namespace linkwork {

/// Takes kept steps of several runs again, in parts and side by side, as StepJudge does: steps of one run after the
/// other, each beside those of the other runs. What the lanes cannot do is left to StepJudge: steps with other redundant
/// rows or another number of parts, history variables, suspicious pivots.
class LaneRetake final : private LaneGuard {
 public:
  /// The runs, at most as many as registers have lanes, took their steps by this method.
  LaneRetake(const LaneStructure& structure, const InstructionSet& instructions, std::vector<LaneRun*> runs,
             const ButcherTableau& tableau);

  /// Leaves the ends in `retaken` of each run. `look` is called between steps; what it throws ends it.
  void run(const std::function<void()>& look);

 private:
  struct Lane {
    LaneRun* run;
    std::vector<RunPart> parts;
    std::vector<const KeptStep*> steps;
    StepParts divided;
    const KeptStep* step = nullptr;  ///< that is taken
    bool active = false;
    std::vector<Span> spans;
  };

  bool steps(int l) const override { return lanes_[l].active; }
  bool looked(int) const override { return false; }
  void note(int l, double t, double pivot, bool first) override;
  void leave(int l, double, std::string) override { lanes_[l].active = false; }

  void begin(Lane& lane, std::size_t step);
  void take_parts();
  void hold();

  const LaneStructure& structure_;
  LaneStepper stepper_;
  LaneSpans spans_;
  AlignedDoubles shares_;
  std::vector<Lane> lanes_;
};

}  // namespace linkwork
