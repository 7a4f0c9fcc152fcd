#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane_refinement.hpp"
#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/ensemble/lane_user_forces.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/math/aligned.hpp"

namespace linkwork {

/// Where the steps of the lanes begin and how long they are [s]: of each its own.
struct LaneSpans {
  explicit LaneSpans(int width) : t(width, 0.0), h(width, 0.0), earliest(width, -INFINITY), latest(width, INFINITY) {}
  void set(int l, double begin, double length) { t[l] = begin, h[l] = length; }
  void set(int l, const StepSpan& span) {
    set(l, span.t, span.h);
    earliest[l] = span.earliest;
    latest[l] = span.latest;
  }

  AlignedDoubles t, h, earliest, latest;  ///< as in StepSpan
};

/// Steps of an explicit Runge-Kutta method by as many mechanisms of one structure as a register has lanes. What is not
/// the same arithmetic for all of them is done lane by lane: functions of time, force elements, couplers.
class LaneStepper {
 public:
  /// At most as many mechanisms as registers have lanes, which it refers to. They begin with their initial states;
  /// lanes that are not used hold the numbers of the last mechanism.
  LaneStepper(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Dynamics*> mechanisms,
              const ButcherTableau& tableau);

  int width() const { return width_; }
  int count() const { return static_cast<int>(mechanisms_.size()); }

  /// Another mechanism in a lane.
  void replace(int l, Dynamics& mechanism);

  // y = (q, v, work) of one lane.
  void set_state(int l, const VectorXd& y) { give(y.data(), y.size(), l, y_, 0); }
  void state(int l, VectorXd& y) const { take(y_, l, 0, y); }
  void state_before_step(int l, VectorXd& y) const { take(before_, l, 0, y); }
  double potential(int l) const { return potential_[l]; }  ///< [J] at the last evaluation
  void violations(int l, VectorXd& Phi, VectorXd& Phi_dot) const;
  /// The largest number of a state in amount, and of its velocities; infinite where one is no number.
  const double* largest_number();
  const double* largest_velocity();

  /// Positions, forces and joints of the current states.
  void evaluate(const LaneSpans& spans, LaneGuard& guard) { evaluate(spans.t, y_, guard); }
  /// The correction of violations that steps hold: of steps of `share` of the lengths, from the last evaluation.
  void hold(const LaneSpans& spans, const double* share);
  /// From states that were evaluated, not normalized yet.
  void step(const LaneSpans& spans, LaneGuard& guard);
  void normalize();

  // For projections, which move the states of single lanes.
  /// Positions, forces and joints of the current states at t of each lane; joints alone.
  void evaluate(const AlignedDoubles& t, LaneGuard& guard) { evaluate(t, y_, guard); }
  void evaluate_constraints(const AlignedDoubles& t, LaneGuard& guard);
  void forces(int l, VectorXd& g) const { take(g_, l, 0, g); }
  /// M x - D^T lambda = 0, D x = -Phi, or -Phi_dot, of the last evaluation: with the M and D there, or
  /// with those of the last factorization.
  enum class Violation { positions, velocities };
  void factorize_and_correct(Violation of, const AlignedDoubles& t, LaneGuard& guard);
  void correct(Violation of, const AlignedDoubles& t, LaneGuard& guard);
  void correction(int l, VectorXd& x) const { take(v_dot_, l, 0, x); }

  // The stages of a step without its end. The first one and the correction that it holds, of one lane:
  void begin_stages(int l, const VectorXd& y, const ConstVector& rates, const VectorXd& held);
  void later_stages(const LaneSpans& spans, LaneGuard& guard);
  void rates(int l, int stage, MutableVector out) const;

  /// A right-hand side with reactions.
  void evaluate_rates(const LaneSpans& spans, LaneGuard& guard);
  VectorXd accelerations(int l) const;  ///< from the last one

 private:
  using Numbers = AlignedDoubles;

  void size(Numbers& numbers, std::ptrdiff_t count) const;
  void allocate_motion();
  void allocate_parameters();
  void load(int l, const Dynamics& mechanism);
  void load_masses(int l, const Dynamics& mechanism);
  void load_joints(int l, const Model& model);
  const Dynamics& mechanism(int l) const;
  double* lane(Numbers& numbers, std::ptrdiff_t k, int l) { return numbers.data() + k * width_ + l; }
  void take(const Numbers& numbers, int l, std::ptrdiff_t first, MutableVector out) const;
  void give(const double* from, std::ptrdiff_t count, int l, Numbers& to, std::ptrdiff_t first) const;
  template <class Action>
  void each_lane(const LaneGuard& guard, Action action);

  void evaluate(const Numbers& t, const Numbers& y, LaneGuard& guard);
  template <class Evaluate>
  void evaluate_apart(int l, double t, const Numbers& y, LaneGuard& guard, Evaluate evaluate);
  void evaluate_rest(const Numbers& t, const Numbers& y, LaneGuard& guard);
  void evaluate_rest(int l, double t, const Numbers& y, LaneGuard& guard);
  void give_parameters(int l, const Evaluation& at);
  void give_special_joints(int l, const Evaluation& at);
  void evaluate_joints();
  void leave_out_rows();
  bool sampled() const { return stabilization_ == StabilizationKind::sampled_baumgarte; }
  bool continuous() const { return stabilization_ == StabilizationKind::baumgarte; }
  void correct();
  void combine(const LaneSpans& spans, const ConstVector& weights, Eigen::Index count, Numbers& out);
  void solve(const Numbers& t, bool first, LaneGuard& guard);
  void leave_out_b();
  LaneSolver::Problem problem(const Numbers& D, const Numbers& a) {
    return {D.data(), a.data(), b_.data(), v_dot_.data(), lambda_.data()};
  }
  void factorize_and_solve(const Numbers& a, const Numbers& t, bool first, LaneGuard& guard);
  void solve_as_looked(const LaneGuard& guard);
  void take_violation(Violation of);
  void find_rates(const Numbers& y, Numbers& y_dot, const LaneGuard& guard);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  int level_, width_;
  std::vector<Dynamics*> mechanisms_;
  const ButcherTableau& tableau_;
  bool rest_ = false;
  StabilizationKind stabilization_;

  LaneSolver solver_;
  LaneRefinement refinement_;
  LaneUserForces user_forces_;

  Numbers mass_, gravity_, states_;
  std::vector<Numbers> attachments_, parameters_;  ///< by kind
  Numbers D_, Phi_, Phi_t_, Phi_dot_, gamma_, g_, b_, u_, v_dot_, lambda_, power_, potential_;
  Numbers looked_v_dot_, looked_lambda_, largest_;
  Numbers factorized_D_, none_;  ///< of projections
  Numbers y_, before_, stage_, stage_t_, weights_, ones_, velocity_gains_, position_gains_;
  std::vector<Numbers> k_;
  std::vector<const double*> terms_;
  VectorXd state_, rows_, rates_;
};

}  // namespace linkwork
