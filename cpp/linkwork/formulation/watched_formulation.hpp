#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/least_singular_value.hpp"
#include "linkwork/constraints/minimum_norm.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "linkwork/formulation/instant.hpp"
#include "linkwork/formulation/rank_tolerant.hpp"
#include "linkwork/formulation/singular_watch.hpp"

namespace linkwork {

/// Where rows were left out last, other than those that are at first: what solves was analyzed there.
struct RowChoice {
  double t = NAN;
  VectorXd y, history;
  std::vector<int> rows;

  void keep(Archive& archive) { archive(t, y, history, rows); }
};

/// Any formulation, watched for poses in which constraint rows depend on each other. Rows that always do are left out of
/// it, and others where the motion makes those the wrong ones; where its factorization is not to be trusted, the
/// rank-revealing fallback solves instead.
class WatchedFormulation final : public Formulation {
 public:
  /// `at` and `now`, which are referred to, are evaluated; `dropped` rows are in their place.
  WatchedFormulation(const System& system, Evaluation& at, const Instant& now, std::unique_ptr<Formulation> formulation,
                     DroppedRows dropped);
  /// Where there are joints: takes the redundant rows out of `at`. `needs_full_rank`: see FormulationInfo; `watched`:
  /// pivots tell singular poses.
  void start(bool needs_full_rank, bool watched);

  void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) override;
  void require_accuracy(double relative) override { formulation_->require_accuracy(relative); }
  bool refines() const override { return formulation_->refines(); }
  bool takes_small_inertias() const override { return formulation_->takes_small_inertias(); }
  void factorize(const Evaluation& at) override;
  /// Whatever b has in rows that are left out.
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override;
  void factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector v_dot,
                           MutableVector lambda) override;
  SaddleSolver& saddle() const override { return formulation_->saddle(); }
  const Formulation& formulation() const { return *formulation_; }

  /// There is an evaluation at another state, and no factorization.
  void begin();
  /// The same, of which nothing is evaluated yet but what somebody else needs; see Dynamics::begin_elsewhere.
  void begin_elsewhere();
  bool elsewhere() const { return elsewhere_; }  ///< and still so
  bool factorized() const { return factorized_; }
  std::int64_t factorizations() const { return factorizations_; }
  double smallest_pivot() const { return smallest_pivot_; }  ///< of all, 0 where one broke down
  /// Of those since the last call.
  double take_smallest_pivot() { return std::exchange(smallest_pivot_, 1.0); }
  /// Of the last factorization: the root of the smallest pivot, see SingularWatch.
  double root_of_pivot() const { return std::sqrt(std::max(saddle().smallest_pivot(), 0.0)); }
  /// The last factorization is that of RankTolerant: some rows have no part in solutions.
  bool fallback() const { return fallback_; }
  void fall_back();

  /// A first pivot that the watch doubts: whether rows are near each other here.
  void examine_first(double pivot);
  SingularWatch& watch() { return watch_; }
  const SingularWatch& watch() const { return watch_; }
  bool watched() const { return watched_; }
  /// Evaluations from here on serve a step that knows of singular poses: the watch does not look at them.
  void watch_evaluations(bool on) { watching_ = on; }
  /// Evaluations from here on serve an observer: the watch does not hear of them.
  void look(bool on) { looking_ = on; }

  /// Where there are joints.
  const RegularizedInertia& inertia() const { return *inertia_; }
  /// What is factorized, and whether with other inertias than those of the system.
  const System& factorized_system() const { return regularized() ? inertia_->system() : system_; }
  bool regularized() const { return inertia_->regularized() && !takes_small_inertias(); }
  const DroppedRows& dropped() const { return dropped_; }
  DroppedRows& dropped() { return dropped_; }
  /// Multipliers of redundant constraints as those of MinimumNorm.
  void distribute(MutableVector lambda);
  /// Of the constraint matrix here, see LeastSingularValue; 0 where it has no factorization. Of several parts the one
  /// that is least beside its usual value counts, in units in which that is the largest usual one of all.
  double least_singular_value();
  /// The same at t by the factorization of somebody else, who has this smallest pivot there; the watch hears of it as of
  /// one's own. None, and nothing heard, where that is not enough: one's own has to be looked at.
  std::optional<double> least_singular_value(double t, double pivot, const LeastSingularValue::Solve& solve);
  double usual_least_singular_value() const { return usual_least_; }  ///< the largest of all looks
  /// The least of all parts, whatever is usual.
  double least_singular_value_of_all();
  /// The largest root of smallest pivots, or where parts have roots of their own the usual least singular value.
  double usual_root() const { return in_parts() ? usual_least_ : watch_.root_of_level(); }
  /// Whether there are several, each with a pivot of its own, of which only the smallest is known.
  bool in_parts() const { return usual_of_parts_.size() > 1; }
  /// At a pose that was stepped over, at positions q: whether it is singular. It is listed then; and where it only
  /// seemed to be because the wrong redundant rows are left out, others are from here on.
  bool cross(const VectorXd& q, double pivot);
  /// Where the least singular value is small: whether it is larger with other redundant rows at the present state; they
  /// are left out from here on.
  bool improve_rows();
  /// Leaves out these rows from here on: others have become redundant in the course of the motion. `joints` of them are
  /// reported, see SingularityCrossing::rows_changed.
  void change_redundant_rows(std::vector<int> rows, std::vector<int> joints);

  /// With t NaN where there was none.
  const RowChoice& row_choice() const { return choice_; }
  /// The present state is that where these rows were left out.
  void repeat_choice(const std::vector<int>& rows);
  void keep(Archive& archive) override {
    archive(watch_, least_singular_value_, usual_least_, usual_of_all_, usual_of_parts_, pivot_);
    formulation_->keep(archive);
  }

 private:
  template <class Factorize>
  bool attempt(Factorize factorize);
  template <class Factorize>
  double try_factorization(Factorize factorize);
  VectorXd q() const { return now_.y.head(system_.q_size()); }
  void evaluate_here();
  PoseExamination examine_here(double pivot) const;
  bool inspect();
  void leave_out(std::vector<int> rows);
  ConstVector kept(const ConstVector& b);  ///< zero in dropped rows; of the last call
  bool choose_rows(std::vector<int> rows, std::vector<int> joints, double least);
  double beside_usual(const VectorXd& least);
  Formulation& active() { return fallback_ ? *tolerant_ : *formulation_; }

  const System& system_;
  Evaluation& at_;
  const Instant& now_;
  std::unique_ptr<Formulation> formulation_;
  std::unique_ptr<RegularizedInertia> inertia_;
  std::unique_ptr<RankTolerant> tolerant_;  ///< where it was needed
  DroppedRows dropped_;
  MinimumNorm minimum_norm_;
  LeastSingularValue least_singular_value_;
  SingularWatch watch_;
  RowChoice choice_;
  VectorXd kept_b_;
  double pivot_ = 1.0, smallest_pivot_ = 1.0, usual_least_ = 0.0, usual_of_all_ = 0.0;
  VectorXd usual_of_parts_;
  std::int64_t factorizations_ = 0;
  bool rank_needed_ = false, watched_ = false, watching_ = true, looking_ = false;
  bool factorized_ = false, fallback_ = false;
  bool elsewhere_ = false;
};

}  // namespace linkwork
