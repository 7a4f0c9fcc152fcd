#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/rank.hpp"
#include "linkwork/formulation/instant.hpp"
#include "linkwork/formulation/options.hpp"
#include "linkwork/formulation/singular_watch.hpp"
#include "linkwork/formulation/stabilization.hpp"
#include "linkwork/math/instruction_set.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {

class WatchedFormulation;
struct IterationStatistics;

/// What a run cost. Times in s; of small mechanisms estimated from a part of the evaluations.
struct DynamicsStatistics {
  std::int64_t evaluations = 0, factorizations = 0, solves = 0;
  double evaluate_time = 0.0;
  double factorize_time = 0.0;  ///< with the first solution, which may be part of it
  double solve_time = 0.0;      ///< of all further solutions
  double smallest_pivot = 1.0;  ///< over the run; see Pivot
};

/// What a factorization takes; see LinearSolver. Of a solver that forms no matrix it is the kkt matrix that counts.
struct FactorizationCost {
  std::int64_t matrix_nonzeros = 0;  ///< of the lower triangle
  std::int64_t factor_nonzeros = 0;
  std::optional<double> flops;
  std::optional<std::int64_t> bytes;
};

/// A System with a formulation and a stabilization: the right-hand side of y_dot = f(t, y), y = (q, v, work), with the
/// work of the forces that have no potential [J] as the last entry.
class Dynamics {
 public:
  /// `like`: another one, whose rank is taken where it has the same joints and pose.
  Dynamics(const Model& model, const Options& options, const Dynamics* like = nullptr)
      : Dynamics(model, options, like, OnePath(options.deterministic)) {}
  ~Dynamics();

  const System& system() const { return system_; }
  const Options& options() const { return options_; }  ///< as chosen: no "auto" left
  const Evaluation& evaluation() const { return at_; }
  DynamicsStatistics statistics() const;
  const IterationStatistics& iterations() const;
  FactorizationCost factorization_cost() const;  ///< of the last one
  double assemble_time() const;                  ///< part of the factorize_time; see SaddleSolver
  int y_size() const { return system_.q_size() + system_.v_size() + 1; }
  VectorXd initial_y() const;
  // History variables (see history.hpp) are held while a step is tried, and go on when its end is accepted.
  /// Those that evaluations take as of the last accepted state; at first those of the initial state.
  const VectorXd& history() const { return now_.history; }
  const VectorXd& initial_history() const { return initial_history_; }
  /// OptionError: not as many numbers as there are history variables.
  void set_history(const ConstVector& history);
  /// Accepts the state where this is evaluated. What was evaluated there holds with the new history, too.
  void advance_history() { now_.history = at_.history; }
  /// A contact is found to begin or end in the state that is accepted next, be its depth zero or roundoff.
  void begin_contact(int variable) { now_.history[variable] = std::numeric_limits<double>::quiet_NaN(); }
  void end_contact(int variable) { now_.history[variable] = at_.history[variable] = 0.0; }
  // Switches of force elements whose law is not smooth, see Wrenches: on which side of zero they are.
  /// The sides of the state where this is evaluated are those of the step that begins there; what is zero, or no
  /// larger than `least` [m or rad], keeps its side: of contacts that only just touch, roundoff would choose anew in
  /// each state.
  void take_sides(double least);
  void set_side(int which, bool positive) { sides_[which] = positive; }
  const std::vector<char>& sides() const { return sides_; }
  /// Of an evaluation elsewhere, such as in lanes; nothing is looked for before sides are taken.
  bool looks_for_switches() const { return !sides_.empty(); }
  void look_for_switches(const VectorXd& switches);
  /// Whether an evaluation since the last call had one on another side.
  bool switched() const { return switched_; }
  bool take_switched() { return std::exchange(switched_, false); }
  /// The farthest of those.
  struct Elsewhere {
    int which = 0;
    double by = 0.0;  ///< from zero [m or rad]
  };
  const Elsewhere& elsewhere() const { return elsewhere_; }
  const RankReport& rank() const { return rank_; }
  /// What solves: redundant rows, singular poses.
  WatchedFormulation& formulation() { return *formulation_; }
  const WatchedFormulation& formulation() const { return *formulation_; }
  const SingularWatch& watch() const;
  const DroppedRows& dropped() const;

  /// Evaluates at (t, y): everything below refers to this state. Redundant rows are zero in the D of the `evaluation`.
  /// `stage` of a step, from 1 on, is for errors.
  void evaluate(double t, const ConstVector& y, int stage = 1);
  /// For ensembles: the state is (t, y), where somebody else evaluates and solves; what is needed of it goes into the
  /// evaluation. Looks at its singular values evaluate the rest.
  Evaluation& begin_elsewhere(double t, const ConstVector& y);
  /// Looks for values that are not finite in every evaluation from here on: a NotFiniteError names the first.
  void trace() { traces_ = true; }
  /// Roundoff in solutions must not show where only relative errors of this size are tolerated.
  void require_accuracy(double relative);
  /// No joints and no inerters: there is nothing to factorize.
  bool unconnected() const { return system_.row_count() == 0 && system_.inerters().empty(); }
  /// Factorizes ahead of the first solution, which else does both.
  void factorize();

  // For observers, who change no bit of what follows.
  /// Calls `look` when there has been a solution at this state: at once, or after the next one. What the step finds
  /// first is then found in the same way with and without it.
  void observe(std::function<void()> look);
  /// Calls what still waits for a solution.
  void observe_now();
  /// The state of the last evaluation and factorization, to come back to after others that only served to look.
  struct Place {
    double t;
    VectorXd y;
    bool factorized, fallback;
  };
  /// What evaluations and solutions from here on depend on beside t and y, with a step to begin.
  void keep(Archive& archive);
  Place place() const;
  void return_to(const Place& place);

  /// Accelerations and multipliers of the mechanism itself, without stabilization. The multipliers of redundant
  /// constraints are those of MinimumNorm.
  void accelerations(MutableVector v_dot, MutableVector lambda);
  /// The same, refined by the residuals of the equations until they are at roundoff.
  void refined_accelerations(MutableVector v_dot, MutableVector lambda);
  /// D v_dot - gamma of all constraints, redundant ones included.
  void acceleration_residual(const ConstVector& v_dot, MutableVector residual);

  /// Whether the D of the evaluation is that of the positions q at t to the last bit, whatever the history.
  bool has_D_of(double t, const ConstVector& q) const;
  /// See System::reactions: at the current state, by the D of all constraints.
  void reactions(const ConstVector& lambda, Eigen::Ref<Eigen::Matrix3Xd> force, Eigen::Ref<Eigen::Matrix3Xd> torque);

  /// Solves M x - D^T lambda = a, D x = b at the current state by the formulation.
  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda);

  StabilizationKind stabilization() const { return kind_; }

  // Sampled stabilization, for integrators. All three do nothing where another stabilization was chosen.
  bool sampled() const { return kind_ == StabilizationKind::sampled_baumgarte; }
  /// Violations are corrected over steps of at least this length [s]: in a step that was cut short, a correction of
  /// positions within it would be a velocity without bounds. 0: over those that are taken.
  void correct_over(double length) { correction_length_ = length; }
  double correction_length() const { return correction_length_; }
  /// Computes u from the current state with these gains of a step h (the user's, where given) and holds it for `rates`.
  void begin_zero_order_hold(Gains gains, double h);
  const VectorXd& held_correction() const { return held_u_; }  ///< u, while it is held
  void end_zero_order_hold() { held_ = held_ && first_part_ > 0.0; }
  /// From here to end_parts a step is taken in parts, the first of this share: the correction that it holds is that of
  /// the whole, and stays.
  void begin_parts(double share) { held_ = false, first_part_ = share; }
  void end_parts() { held_ = false, first_part_ = 0.0; }
  /// For multistep methods: adds to `y` the two terms of u where they belong, h (-2 alpha Phi_dot) to v and
  /// h^2 (-beta^2 Phi) to q, both through the response of the mechanism; the default alpha = 1/(2h), beta = 1/h annuls
  /// both violations to first order.
  void add_correction(double h, MutableVector y);

  /// y_dot at the current state, with the zero-order hold of u or the continuous stabilization.
  void rates(MutableVector y_dot);
  /// y_dot at the current state for accelerations and multipliers that were found otherwise.
  void rates(const ConstVector& v_dot, const ConstVector& lambda, MutableVector y_dot) const;

 private:
  friend class Busy;
  Dynamics(const Model& model, const Options& options, const Dynamics* like, const OnePath&);
  void find_rank(const Dynamics* like);
  void find_solution(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda);
  void use_threads();
  void settle_threads();
  void check_masses() const;
  void check_kkt() const;
  void check_deterministic() const;
  /// M is that of the bodies alone, each by itself.
  Gains gains_or(Gains defaults) const;
  int evaluations_on_the_clock() const;
  void rates(const ConstVector& b, MutableVector y_dot);
  void add_rates_of_position(const ConstVector& lambda, MutableVector y_dot) const;
  void look_for_nan(bool solution_is_finite) const;

  Options options_;
  System system_;
  StabilizationKind kind_;
  RankReport rank_;
  Evaluation at_;
  Instant now_;
  std::unique_ptr<WatchedFormulation> formulation_;
  VectorXd initial_history_;
  std::vector<char> sides_;  ///< empty until they are taken: positive or not
  bool switched_ = false;
  Elsewhere elsewhere_;
  std::function<void()> observer_;
  DynamicsStatistics statistics_;
  VectorXd held_u_, b_, x_, lambda_;
  int clocked_ = 1;
  bool traces_ = false, held_ = false;
  double first_part_ = 0.0;  ///< its share, of a step that is taken in parts, else 0
  double correction_length_ = 0.0;
  InterruptionMeter meter_;
  mutable std::atomic_flag busy_;
};

/// Dynamics work for one caller at a time: while this is there, for the one that made it. Nothing here waits: whoever
/// comes meanwhile, from another thread or from a function of the user's that the dynamics call, gets a BusyError.
/// For those who share dynamics; a loop of evaluations makes one of these, not one for each.
class Busy {
 public:
  explicit Busy(const Dynamics& dynamics);
  ~Busy() { dynamics_.busy_.clear(std::memory_order_release); }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;

 private:
  const Dynamics& dynamics_;
  OnePath path_;
};

/// While it is there the watch does not look at evaluations.
class Unwatched {
 public:
  explicit Unwatched(Dynamics& dynamics);
  ~Unwatched();
  Unwatched(const Unwatched&) = delete;
  Unwatched& operator=(const Unwatched&) = delete;

 private:
  Dynamics& dynamics_;
};

}  // namespace linkwork
