#include "linkwork/formulation/watched_formulation.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/formulation/not_finite.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double crossed_pivot = 1e-6;  // in a singular pose that is known to some 1e-4 rad
constexpr double well_chosen = 0.1;     // least singular value, relative to the usual one
constexpr double better = 1.5;          // times the least singular value, for other redundant rows
constexpr double broken = -1.0;         // for a pivot of a factorization that broke down

}  // namespace

WatchedFormulation::WatchedFormulation(const System& system, Evaluation& at, const Instant& now,
                                       std::unique_ptr<Formulation> formulation, DroppedRows dropped)
    : system_(system), at_(at), now_(now), formulation_(std::move(formulation)), dropped_(std::move(dropped)) {}

void WatchedFormulation::start(bool needs_full_rank, bool watched) {
  inertia_ = std::make_unique<RegularizedInertia>(system_, at_);
  rank_needed_ = needs_full_rank;
  watched_ = watched;
  analyze(system_, at_, {mean_delassus_diagonal(inertia_->system(), at_), dropped_.rows(), inertia_.get()});
}

/// At `at_`, with the D of all rows.
void WatchedFormulation::analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) {
  minimum_norm_ = MinimumNorm(system, rows.delassus, dropped_);
  dropped_.take_out(at_);
  least_singular_value_ = LeastSingularValue(system, rows.delassus, dropped_);
  look_for_interruption();
  formulation_->analyze(system, typical, rows);
}

void WatchedFormulation::begin() {
  dropped_.take_out(at_);
  factorized_ = fallback_ = elsewhere_ = false;
}

void WatchedFormulation::begin_elsewhere() {
  factorized_ = fallback_ = false;
  elsewhere_ = true;
}

void WatchedFormulation::evaluate_here() {
  if (!elsewhere_) return;
  system_.evaluate_constraints(now_.t, q(), now_.y.segment(system_.q_size(), system_.v_size()), now_.history, at_);
  begin();
}

void WatchedFormulation::factorize(const Evaluation& at) {
  evaluate_here();
  if (!factorized_) attempt([&] { formulation_->factorize(at); });
}

void WatchedFormulation::solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  active().solve(a, kept(b), v_dot, lambda);
}

void WatchedFormulation::factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b,
                                             MutableVector v_dot, MutableVector lambda) {
  if (!attempt([&] { formulation_->factorize_and_solve(at, a, kept(b), v_dot, lambda); })) solve(a, b, v_dot, lambda);
}

ConstVector WatchedFormulation::kept(const ConstVector& b) {
  if (dropped_.empty()) return b;
  kept_b_ = b;
  dropped_.take_from(kept_b_);
  return kept_b_;
}

/// False where `factorize` was not the last word: a solution that it found is none.
template <class Factorize>
bool WatchedFormulation::attempt(Factorize factorize) {
  pivot_ = try_factorization(factorize);
  factorized_ = true;
  factorizations_ += 1;
  smallest_pivot_ = std::min(smallest_pivot_, std::max(pivot_, 0.0));
  if (!watched_ || !watching_) return true;
  if (watch_.doubts_first(pivot_)) examine_first(pivot_);
  if (!looking_) {
    watch_.note(now_.t, pivot_);
    return watch_.usual(pivot_) || inspect();
  }
  if (!rank_needed_ || !watch_.untrustworthy(pivot_)) return true;
  fall_back();
  return false;
}

/// The smallest pivot; -1 where the matrix is singular. A state that is not finite makes it so: say which it is.
template <class Factorize>
double WatchedFormulation::try_factorization(Factorize factorize) {
  try {
    factorize();
  } catch (const SingularSystemError&) {
    const bool pivots = std::isfinite(saddle().smallest_pivot());
    if (!pivots || !now_.y.allFinite() || !at_.Phi.allFinite() || !at_.Phi_dot.allFinite())
      throw_not_finite(system_, now_.y, now_.t, now_.stage);
    if (!rank_needed_ || !watching_ || (!looking_ && !watch_.open() && examine_here(broken).rows.empty())) throw;
    return broken;
  }
  return saddle().smallest_pivot();
}

PoseExamination WatchedFormulation::examine_here(double pivot) const {
  return examine_pose(system_, {now_.t, q(), now_.history}, dropped_.rows(), watch_.near(pivot));
}

void WatchedFormulation::examine_first(double pivot) { watch_.start(examine_here(pivot).rows.empty() ? pivot : 1.0); }

/// A small pivot, or any inside a crossing. False where the factorization is another one than before.
bool WatchedFormulation::inspect() {
  if (watch_.open()) {
    watch_.go_on(pivot_);
  } else {
    PoseExamination found = examine_here(pivot_);
    if (found.rows.empty()) {
      watch_.suspect_less();
      return true;
    }
    if (!found.better_choice.empty()) {
      watch_.change_rows(now_.t, pivot_, std::move(found.joints));
      leave_out(std::move(found.better_choice));
      return false;
    }
    watch_.begin(now_.t, pivot_, std::move(found.joints));
  }
  if (!rank_needed_ || !watch_.untrustworthy(pivot_)) return true;
  fall_back();
  watch_.count_fallback();
  return false;
}

void WatchedFormulation::fall_back() {
  if (!tolerant_) tolerant_ = std::make_unique<RankTolerant>(system_, *inertia_);
  tolerant_->factorize(at_);
  fallback_ = true;
}

void WatchedFormulation::distribute(MutableVector lambda) {
  if (!dropped_.empty()) minimum_norm_.distribute(dropped_, active(), lambda);
}

double WatchedFormulation::least_singular_value() {
  try {
    factorize(at_);
  } catch (const SingularSystemError&) {
    return 0.0;
  }
  return beside_usual(least_singular_value_.of(saddle(), at_));
}

double WatchedFormulation::least_singular_value_of_all() {
  try {
    factorize(at_);
  } catch (const SingularSystemError&) {
    return 0.0;
  }
  const VectorXd& least = least_singular_value_.of(saddle(), at_);
  beside_usual(least);
  return least.minCoeff();
}

std::optional<double> WatchedFormulation::least_singular_value(double t, double pivot,
                                                               const LeastSingularValue::Solve& solve) {
  if (!watched_ || !watching_ || looking_ || !(pivot > 0.0) || watch_.suspicious(pivot)) return {};
  watch_.note(t, pivot);
  watch_.usual(pivot);
  return beside_usual(least_singular_value_.of(solve, at_));
}

double WatchedFormulation::beside_usual(const VectorXd& least) {
  usual_of_all_ = std::max(usual_of_all_, least.minCoeff());
  if (least.size() == 1) {
    usual_least_ = usual_of_all_;
    return least[0];
  }
  if (usual_of_parts_.size() == 0) usual_of_parts_.setZero(least.size());
  double fallen = 1.0;
  for (Eigen::Index part = 0; part < least.size(); ++part) {
    double& usual = usual_of_parts_[part];
    if (least[part] < INFINITY) usual = std::max(usual, least[part]);
    if (usual > 0.0) fallen = std::min(fallen, least[part] / usual);
  }
  usual_least_ = usual_of_parts_.maxCoeff();
  return fallen * usual_least_;
}

void WatchedFormulation::leave_out(std::vector<int> rows) {
  choice_ = {now_.t, now_.y, now_.history, rows};
  dropped_.put_back(at_);
  dropped_ = DroppedRows(system_, std::move(rows));
  analyze(system_, at_, {mean_delassus_diagonal(inertia_->system(), at_), dropped_.rows(), inertia_.get()});
  formulation_->factorize(at_);
}

void WatchedFormulation::repeat_choice(const std::vector<int>& rows) {
  try {
    leave_out(rows);
  } catch (const SingularSystemError&) {  // in a singular pose, as then
  }
}

void WatchedFormulation::change_redundant_rows(std::vector<int> rows, std::vector<int> joints) {
  watch_.change_rows(now_.t, saddle().smallest_pivot(), std::move(joints));
  leave_out(std::move(rows));
  factorized_ = true;
  fallback_ = false;
}

/// Takes the choice where it makes the least singular value at least so large.
bool WatchedFormulation::choose_rows(std::vector<int> rows, std::vector<int> joints, double least) {
  const std::vector<int> before = dropped_.rows();
  if (rows.empty() || rows == before) return false;
  const double pivot = saddle().smallest_pivot();
  const auto least_with = [this](std::vector<int> choice) {
    try {
      leave_out(std::move(choice));
      return least_singular_value_.of(saddle(), at_).minCoeff();
    } catch (const SingularSystemError&) {
      return -1.0;  // either may be singular, in a singular pose
    }
  };
  if (!(least_with(std::move(rows)) >= least)) {
    factorized_ = least_with(before) >= 0.0;
    return false;
  }
  watch_.change_rows(now_.t, pivot, std::move(joints));
  return true;
}

bool WatchedFormulation::improve_rows() {
  if (dropped_.empty()) return false;
  factorize(at_);
  std::vector<int> rows = choose_redundant_rows(system_, {now_.t, q(), now_.history}, dropped_.rows()), joints;
  for (const int row : dropped_.rows())
    if (!std::binary_search(rows.begin(), rows.end(), row))
      if (const int joint = system_.model().joint_of_row(row); joints.empty() || joints.back() != joint)
        joints.push_back(joint);
  if (!choose_rows(std::move(rows), std::move(joints), better * least_singular_value_of_all())) return false;
  watch_.forget_trend();
  return true;
}

bool WatchedFormulation::cross(const VectorXd& q, double pivot) {
  PoseExamination found =
      examine_pose(system_, {now_.t, q, now_.history}, dropped_.rows(), watch_.near(std::max(pivot, crossed_pivot)));
  if (found.rows.empty()) return false;
  if (choose_rows(std::move(found.better_choice), found.joints, well_chosen * usual_of_all_)) return false;
  if (!found.singular) return false;
  watch_.cross(now_.t, pivot, std::move(found.joints));
  return true;
}

}  // namespace linkwork
