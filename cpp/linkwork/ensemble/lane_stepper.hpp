#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane_evaluation.hpp"
#include "linkwork/ensemble/lane_refinement.hpp"
#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/integration/integrator.hpp"

namespace linkwork {

/// Where the steps of the lanes begin and how long they are [s]: of each its own.
struct LaneSpans {
  explicit LaneSpans(int width)
      : t(width, 0.0), h(width, 0.0), earliest(width, -INFINITY), latest(width, INFINITY), begin(width, 0.0) {}
  void set(int l, const StepSpan& span) {
    t[l] = span.t, h[l] = span.h;
    earliest[l] = span.earliest, latest[l] = span.latest;
    begin[l] = span.at(0.0);
  }

  AlignedDoubles t, h, earliest, latest;  ///< as in StepSpan
  AlignedDoubles begin;                   ///< time of the first stage
};

/// Steps of an explicit Runge-Kutta method by as many mechanisms of one structure as a register has lanes.
class LaneStepper {
 public:
  /// At most as many mechanisms as registers have lanes, which it refers to. They begin with their initial states;
  /// lanes that are not used hold the numbers of the last mechanism.
  LaneStepper(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Dynamics*> mechanisms,
              const ButcherTableau& tableau);

  int width() const { return layout_.width; }
  int count() const { return static_cast<int>(mechanisms_.size()); }

  /// Of lanes that are not used the last one.
  const Dynamics& mechanism(int l) const;
  /// Another mechanism in a lane.
  void replace(int l, Dynamics& mechanism);

  // y = (q, v, work) of one lane.
  void set_state(int l, const VectorXd& y) { layout_.give(y.data(), y.size(), l, y_, 0); }
  void state(int l, VectorXd& y) const { layout_.take(y_, l, 0, y); }
  void state_before_step(int l, VectorXd& y) const { layout_.take(before_, l, 0, y); }
  // Of the last evaluation:
  double potential(int l) const { return evaluation_.at().potential[l]; }  ///< [J]
  double position_violation(int l, int row) const { return evaluation_.at().Phi[layout_.index(row, l)]; }
  double velocity_violation(int l, int row) const { return evaluation_.at().Phi_dot[layout_.index(row, l)]; }
  /// What a run by itself would find of its inerters.
  void inerters(int l, Evaluation& out) const { evaluation_.take_inerters(l, out); }
  const VectorXd& switches(int l) { return evaluation_.switches(l); }
  void violations(int l, VectorXd& Phi, VectorXd& Phi_dot) const;
  /// The largest number of a state in amount, and of its velocities; infinite where one is no number.
  const double* largest_number();
  const double* largest_velocity();

  // Of all lanes side by side.
  const LaneLayout& layout() const { return layout_; }
  const AlignedDoubles& states() const { return y_; }
  const AlignedDoubles& states_before_step() const { return before_; }
  const AlignedDoubles& mass() const { return evaluation_.mass(); }

  /// Positions, forces and joints of the current states.
  void evaluate(const LaneSpans& spans, LaneGuard& guard) { evaluate(spans.begin, guard); }
  /// The correction of violations that steps hold: of steps of `share` of the lengths, from the last evaluation.
  void hold(const LaneSpans& spans, const double* share);
  // The factorization of the first stage, ahead of the step: its smallest pivot in a lane, and with it
  // M x - D^T lambda = 0, D x = b of one that has no inerters.
  double smallest_pivot_ahead(int l);
  void solve_ahead(int l, const ConstVector& b, MutableVector x, MutableVector lambda);
  /// From states that were evaluated, not normalized yet.
  void step(const LaneSpans& spans, LaneGuard& guard);
  void normalize();

  // For projections, which move the states of single lanes.
  /// Positions, forces and joints of the current states at t of each lane; joints alone.
  void evaluate(const AlignedDoubles& t, LaneGuard& guard) { evaluation_.evaluate(t, y_, guard); }
  void evaluate_constraints(const AlignedDoubles& t, LaneGuard& guard) {
    evaluation_.evaluate_constraints(t, y_, guard);
  }
  void forces(int l, VectorXd& g) const { layout_.take(evaluation_.at().g, l, 0, g); }
  /// M x - D^T lambda = 0, D x = -Phi, or -Phi_dot, of the last evaluation: with the M and D there, or
  /// with those of the last factorization.
  enum class Violation { positions, velocities };
  void factorize_and_correct(Violation of, const AlignedDoubles& t, LaneGuard& guard);
  void correct(Violation of, const AlignedDoubles& t, LaneGuard& guard);
  void correction(int l, VectorXd& x) const { layout_.take(v_dot_, l, 0, x); }

  // The stages of a step without its end. The first one and the correction that it holds, of one lane:
  void begin_stages(int l, const VectorXd& y, const ConstVector& rates, const VectorXd& held);
  void later_stages(const LaneSpans& spans, LaneGuard& guard);
  void rates(int l, int stage, MutableVector out) const;

  /// A right-hand side with reactions.
  void evaluate_rates(const LaneSpans& spans, LaneGuard& guard);
  VectorXd accelerations(int l) const;  ///< from the last one

 private:
  using Numbers = AlignedDoubles;

  void allocate();
  template <class Action>
  void each_lane(const LaneGuard& guard, Action action);

  bool sampled() const { return stabilization_ == StabilizationKind::sampled_baumgarte; }
  bool continuous() const { return stabilization_ == StabilizationKind::baumgarte; }
  void correct();
  void combine(const LaneSpans& spans, const ConstVector& weights, Eigen::Index count, Numbers& out);
  void solve(const Numbers& t, LaneGuard& guard);
  void find_b();
  void factorize_ahead();
  void leave_out_b();
  LaneSolver::Problem problem(const Numbers& D, const Numbers& a) {
    return {D.data(), a.data(), b_.data(), v_dot_.data(), lambda_.data()};
  }
  void refine(const LaneSolver::Problem& problem, const Numbers& t, LaneGuard& guard);
  void factorize_and_solve(const Numbers& a, const Numbers& t, LaneGuard& guard);
  void eliminate(const Numbers& a);
  void conclude(const Numbers& a, const Numbers& t, bool first, LaneGuard& guard);
  void solve_as_looked(const LaneGuard& guard);
  void take_violation(Violation of);
  void find_rates(const Numbers& y, Numbers& y_dot, const LaneGuard& guard);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  LaneLayout layout_;
  std::vector<Dynamics*> mechanisms_;
  const ButcherTableau& tableau_;
  StabilizationKind stabilization_;

  LaneEvaluation evaluation_;
  LaneSolver solver_;
  LaneRefinement refinement_;

  Numbers b_, u_, v_dot_, lambda_;
  Numbers looked_v_dot_, looked_lambda_, largest_;
  bool ahead_ = false;           ///< the first stage of the step is factorized, and its solution there
  Numbers factorized_D_, none_;  ///< of projections
  Numbers ahead_b_;              ///< zero
  Numbers y_, before_, stage_, stage_t_, weights_, ones_, velocity_gains_, position_gains_;
  std::vector<Numbers> k_;
  std::vector<const double*> terms_;
  std::vector<VectorXd> stage_weights_;  ///< the rows of A
};

}  // namespace linkwork
