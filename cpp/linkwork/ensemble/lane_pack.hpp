#pragma once

#include <functional>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane.hpp"
#include "linkwork/ensemble/lane_refinement.hpp"
#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/math/aligned.hpp"

namespace linkwork {

/// As many mechanisms of one structure as a register has lanes, simulated with fixed steps by an explicit Runge-Kutta
/// method. What is not the same arithmetic for all of them is done lane by lane: functions of time, force elements,
/// couplers, watches, frames.
class LanePack {
 public:
  /// At most as many lanes as registers have, which it refers to.
  LanePack(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Lane*> lanes,
           const ButcherTableau& tableau, const FixedSteps& steps);

  /// Until all lanes have ended or left. `look` is called between steps; what it throws ends the pack.
  void run(const std::function<void()>& look);

  /// Right-hand sides with reactions at the initial states, again and again; for benchmarks.
  void evaluate_start(int times);
  VectorXd accelerations(int l);  ///< of a lane, from the last one

 private:
  using Numbers = AlignedDoubles;

  void load_numbers();
  void load_masses();
  void load_joints();
  LaneData data();
  double* lane(Numbers& numbers, std::ptrdiff_t k, int l) { return numbers.data() + k * width_ + l; }
  void take(const Numbers& numbers, int l, std::ptrdiff_t first, VectorXd& out) const;
  void give(const double* from, std::ptrdiff_t count, int l, Numbers& to, std::ptrdiff_t first) const;
  template <class Action>
  void each_lane(Action action);
  template <class Action>
  void each_stepping(Action action);
  bool any_lane() const;
  std::int64_t first_step() const;

  void begin_step(std::int64_t step);
  void continue_lane(int l, std::int64_t step);
  void begin_lane(int l, std::int64_t step);
  void evaluate(double t, const Numbers& y);
  void evaluate_rest(int l, double t, const Numbers& y);
  void give_parameters(int l, const Evaluation& at);
  void give_special_joints(int l, const Evaluation& at);
  void evaluate_joints();
  void leave_out_rows();
  void solve(double t, bool first);
  void solve_as_looked();
  void find_rates(const Numbers& y, Numbers& y_dot);
  void take_step(std::int64_t step);
  void finish_step(std::int64_t step);
  void check_size(std::int64_t step);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  const LaneElimination& elimination_;
  int level_, width_;
  std::vector<Lane*> lanes_;
  const ButcherTableau& tableau_;
  const FixedSteps& steps_;
  bool rest_ = false, watches_ = false, judged_ = false;

  LaneRefinement refinement_;

  Numbers mass_, nearby_mass_, mass_factors_, gravity_, states_;
  std::vector<Numbers> attachments_, parameters_;  ///< by kind
  Numbers D_, Phi_, Phi_t_, Phi_dot_, gamma_, g_, b_, u_, v_dot_, lambda_, smallest_, power_, potential_;
  Numbers looked_v_dot_, looked_lambda_, largest_;
  Numbers factors_, articulated_inertias_, panels_, contributions_, scratch_;
  Numbers y_, before_, stage_;
  std::vector<Numbers> k_;
  VectorXd state_, new_state_, rows_, rates_;
  Gains gains_{0.0, 0.0};
};

}  // namespace linkwork
