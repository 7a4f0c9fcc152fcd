#pragma once

#include <memory>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane_pack.hpp"

namespace linkwork {

/// Many mechanisms, simulated from their initial states with fixed steps by an explicit Runge-Kutta method, in packs of
/// those that have their structure in common. Options are the same for all. A mechanism has the bits of its run by
/// itself, see LaneElimination; one that leaves its pack has no motion here, and says why.
class Ensemble {
 public:
  /// Refers to `dynamics`, of which none may be there twice. `widest`: of the registers that are used. `runs`: of each
  /// what its verdict is made of; none of them where it is empty.
  Ensemble(const std::vector<Dynamics*>& dynamics, const ButcherTableau& tableau, const FixedSteps& steps,
           const InstructionSet& widest, std::vector<LaneRun*> runs = {});

  /// One pack a thread at a time.
  void run(int threads);

  struct Member {
    Frames frames;
    std::string reason;  ///< why it left its pack or was never in one; empty: it ended
    double left_at = NAN;
    std::vector<TurnCounter::Turned> turned;  ///< between frames, where that is counted
  };
  /// After `run`; the frames are handed over.
  std::vector<Member> take();

 private:
  struct Group {
    LaneStructure structure;
    std::vector<int> members;
  };
  struct Task {
    const Group* group;
    std::vector<int> members;
  };

  void refuse_distrusted();
  void run_task(const Task& task, const std::function<void()>& look);
  void run_pack(const LaneStructure& structure, const std::vector<Lane*>& lanes, const std::function<void()>& look);
  void judge(const std::vector<const LaneStructure*>& structures, const std::vector<Lane*>& lanes,
             const std::function<void()>& look);
  std::unique_ptr<LaneStructure> run_moved(const std::vector<Lane*>& lanes, const std::function<void()>& look);

  std::vector<Dynamics*> dynamics_;
  std::vector<LaneRun*> runs_;
  ButcherTableau tableau_;
  FixedSteps steps_;
  InstructionSet widest_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<Task> tasks_;
  std::vector<Member> members_;
};

}  // namespace linkwork
