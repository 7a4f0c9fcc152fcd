#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "linkwork/ensemble/lane.hpp"
#include "linkwork/ensemble/lane_projection.hpp"
#include "linkwork/ensemble/lane_stepper.hpp"
#include "linkwork/ensemble/lane_watches.hpp"

namespace linkwork {

/// As many mechanisms of one structure as a register has lanes, simulated with fixed steps by an explicit Runge-Kutta
/// method; watches and frames are those of each lane.
class LanePack final : private LaneGuard {
 public:
  /// At most as many lanes as registers have, which it refers to.
  LanePack(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Lane*> lanes,
           const ButcherTableau& tableau, const FixedSteps& steps);

  /// Until all lanes have ended or left. `look` is called between steps; what it throws ends the pack.
  void run(const std::function<void()>& look);

  /// Right-hand sides with reactions at the initial states, again and again; for benchmarks.
  void evaluate_start(int times);
  VectorXd accelerations(int l) const { return stepper_.accelerations(l); }  ///< of a lane, from the last one

 private:
  bool steps(int l) const override { return lanes_[l]->stepping(); }
  bool looked(int l) const override { return lanes_[l]->looked(); }
  void note(int l, double t, double pivot, bool first) override;
  void note_all(int count, const double* t, const double* pivots, bool first) override;
  void leave(int l, double t, std::string reason) override { lanes_[l]->leave(t, std::move(reason)); }

  template <class Action>
  void each_lane(Action action);
  template <class Action>
  void each_stepping(Action action);
  bool any_lane() const;
  std::int64_t first_step() const;

  void begin_step(std::int64_t step);
  void hold(std::int64_t step);
  void continue_lane(int l, std::int64_t step);
  void look_for_touches(int l, std::int64_t step);
  void begin_lane(int l, std::int64_t step);
  void cross_breaks(int l, std::int64_t step, const VectorXd& y_new);
  double clock(int l, std::int64_t step) const;
  void set_state(int l, const VectorXd& y);
  bool usual_in_redundant_rows(int l) const;
  void hear(int l);
  void take_usual_pivots(int l);
  void finish_step(std::int64_t step);
  void check_size(std::int64_t step);

  const LaneStructure& structure_;
  std::vector<Lane*> lanes_;
  const FixedSteps& steps_;
  LaneStepper stepper_;
  LaneProjection projection_;
  LaneSpans spans_;
  AlignedDoubles shares_;  ///< of the corrections of violations
  AlignedDoubles ends_;    ///< of the step
  LaneWatches watches_;
  /// Of a lane, whose watch is told of usual pivots when the step is over.
  struct Pivots {
    SingularWatch::Range usual;
    std::vector<std::pair<double, double>> unheard;  ///< with their times
  };
  std::vector<Pivots> pivots_;
  bool limited_ = false, breaks_ = false, records_ = false;
  VectorXd state_, Phi_, Phi_dot_;
};

}  // namespace linkwork
