#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane_stepper.hpp"
#include "linkwork/integration/adaptive_simulation.hpp"

namespace linkwork {

/// Runs of one structure, in the order in which lanes take them up.
struct TrialQueue {
  explicit TrialQueue(const Dynamics& example) : structure(example) {}

  LaneStructure structure;
  std::vector<AdaptiveSimulation*> runs;
  std::vector<std::string*> reasons;  ///< of each why it did not come to its end
  std::atomic<std::size_t> next{0};
};

/// Steps that follow tolerances, of as many runs as a register has lanes: each tries steps of its own, whose later
/// stages are evaluated side by side, and is otherwise the run that it is by itself, to the last bit. Lanes wait for
/// nobody: whose run has ended takes up the next of the queue. What lanes cannot do in a step, small pivots and other
/// redundant equations, the run does by itself.
class LaneTrials final : private LaneGuard {
 public:
  LaneTrials(TrialQueue& queue, const InstructionSet& instructions, const ButcherTableau& tableau);

  /// Until the queue is empty and all have ended. `look` is called between steps; what it throws ends it.
  void run(const std::function<void()>& look);

 private:
  struct Lane {
    AdaptiveSimulation* run = nullptr;
    std::string* reason = nullptr;
    bool trial = false;   ///< its run is to try a step
    bool active = false;  ///< with stages in the lane
    SingularWatch watch;  ///< as it was before them
  };

  bool steps(int l) const override { return lanes_[l].active; }
  bool looked(int) const override { return false; }
  void note(int l, double t, double pivot, bool first) override;
  void leave(int l, double t, std::string reason) override;
  void refuse(int l, double, std::string reason) override { give_up(lanes_[l], std::move(reason)); }

  SingularWatch& watch_of(const Lane& lane) const;
  void take_up(int l);
  void advance(int l);
  void begin(int l);
  void finish(int l);
  template <class Action>
  void guarded(Lane& lane, const Action& action);
  static void give_up(Lane& lane, std::string why);

  TrialQueue& queue_;
  LaneStepper stepper_;
  LaneSpans spans_;
  std::vector<Lane> lanes_;
};

/// Advances runs of equal options by one method to their ends, each thread some side by side; of each why it did not come
/// there, and is to be taken from its start by itself; empty: it did.
std::vector<std::string> run_trials(const std::vector<AdaptiveSimulation*>& runs, const InstructionSet& widest,
                                    int threads);

}  // namespace linkwork
