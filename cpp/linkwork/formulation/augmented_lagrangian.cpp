#include <cmath>
#include <cstdio>

#include "linkwork/constraints/conjugate_residuals.hpp"
#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/constraints/refinement.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double stagnation = 0.95, roundoff_change = 1e-7;  // a change that no longer shrinks, and is small: roundoff

// Redundant rows have been left out, so a large penalty resolves no noise of rows that contradict each other a little
// off the constraints: begin where about three iterations do, and raise it while the iteration is slow on this model.
constexpr double first_scale = 1e8, last_scale = 1e10, scale_factor = 10.0;
constexpr int slow_iterations = 15;
constexpr double quick_change = 1e-10;
constexpr double least_enough = 1e-10;  // of the changes by conjugate residuals, which go on to roundoff where they can

/// The iteration (12.16)-(12.18): from lambda_k the accelerations, and from them the next multipliers,
///   (M + D^T alpha D) v_dot_{k+1} = a + D^T (lambda_k + alpha b)                               (12.17)
///   lambda_{k+1} = lambda_k + alpha (b - D v_dot_{k+1}),                                       (12.18)
/// in incremental form: with the residuals r_1 = a - M v_dot + D^T lambda and r_2 = b - D v_dot,
///   (M + D^T alpha D) dv = r_1 + D^T alpha r_2,   dlambda = alpha (r_2 - D dv),
/// which has the same limit and loses no digits to the size of alpha. It begins with lambda_0 = 0.
///
/// Where it is slow, or what no longer changes is not the limit, ConjugateResiduals go on: such a motion is between very
/// heavy and very light bodies, or near a singular pose.
class AugmentedLagrangian final : public Formulation {
 public:
  AugmentedLagrangian(std::unique_ptr<SaddleSolver> saddle, const Options& options)
      : saddle_(std::move(saddle)), options_(options) {}

  void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) override {
    system_ = &system;
    saddle_->drop(rows.dropped);
    saddle_->analyze(system, typical);
    refinement_ = Refinement(system);
    size_ = std::make_unique<NaturalSize>(system);
    residuals_ = std::make_unique<ConjugateResiduals>(system);
    residuals_->measure_rows(typical);
    choose_penalties(typical, rows);
  }

  void factorize(const Evaluation& at) override {
    saddle_->factorize(at, compliance_);
    at_ = &at;
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override {
    const int most = *options_.max_iterations;
    const bool given = options_.penalty || options_.penalty_scale;
    if (!iterate(a, b, v_dot, lambda, given ? most : std::min(most, slow_iterations)) && given)
      throw_not_converged(refinement_.r_2(), most);
    const double enough = std::max(least_enough, *options_.tolerance);
    if (!residuals_->solve(*at_, a, b, v_dot, lambda, nearby_, enough, most))
      throw_not_converged(residuals_->r_2(), repeated_ + residuals_->steps());
    count(residuals_->steps(), residuals_->r_2());
  }

  SaddleSolver& saddle() const override { return *saddle_; }

 private:
  /// Tries scales on the initial state until the iteration is quick.
  void choose_penalties(const Evaluation& typical, const ConstraintRows& rows) {
    const bool given = options_.penalty || options_.penalty_scale;
    VectorXd v_dot(system_->v_size()), lambda(system_->row_count()), gamma = typical.gamma;
    for (const int row : rows.dropped) gamma[row] = 0.0;
    for (double scale = options_.penalty_scale.value_or(first_scale);; scale *= scale_factor) {
      compliance_ = row_penalties(rows, options_.penalty, scale).cwiseInverse();
      if (given || scale >= last_scale) break;
      factorize(typical);
      const bool quick = iterate(typical.g.head(system_->v_size()), gamma, v_dot, lambda, slow_iterations);
      if (quick && iterations_.last_change < quick_change) break;
    }
    iterations_ = {};
  }

  /// False where `most` iterations were not enough.
  bool iterate(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda, int most) {
    saddle_->solve(a, b, v_dot, lambda);  // (12.16): the first, from lambda_0 = 0
    size_->of_free_motion(a, free_motion_);
    double last_change = INFINITY;
    for (int iteration = 2; iteration <= most; ++iteration) {
      refinement_.correct(*at_, a, b, v_dot, lambda, nearby_);  // (12.17), (12.18)
      size_->of(refinement_.dx(), changes_);
      size_->of(v_dot, sizes_);
      sizes_ += free_motion_;
      const double change = NaturalSize::largest_ratio(changes_, sizes_);
      const bool stagnated = change > stagnation * last_change && change < roundoff_change;
      last_change = iterations_.last_change = change;
      if (change > *options_.tolerance && !stagnated && iteration < most) continue;
      repeated_ = iteration;
      iterations_.iterations += iteration;
      iterations_.most = std::max(iterations_.most, iteration);
      iterations_.stagnations += change > *options_.tolerance && stagnated ? 1 : 0;
      return change <= *options_.tolerance || stagnated;
    }
    return false;
  }

  /// Of conjugate residuals, and what they have left.
  void count(int steps, const VectorXd& r_2) {
    iterations_.iterations += steps;
    iterations_.accelerated += steps > 0 ? 1 : 0;
    iterations_.last_residual = r_2.size() > 0 ? r_2.cwiseAbs().maxCoeff() : 0.0;
    iterations_.worst_residual = std::max(iterations_.worst_residual, iterations_.last_residual);
  }

  [[noreturn]] void throw_not_converged(const VectorXd& r_2, int iterations) const {
    Eigen::Index row = -1;
    ErrorDetails details;
    std::string where;
    if (r_2.size() > 0) {
      const double residual = r_2.cwiseAbs().maxCoeff(&row);
      details.joints = {system_->model().joint_name(system_->model().joint_of_row(static_cast<int>(row)))};
      details.residuals = {{details.joints.front(), residual}};
      where = "; the largest residual is at " + system_->model().describe_row(static_cast<int>(row));
    }
    throw NotConvergedError("augmented_lagrangian",
                            "augmented Lagrangian: " + what_is_left() + " after " + std::to_string(iterations) +
                                " iterations" + where + "; " + remedy(),
                            details);
  }

  bool motion_is_found() const { return iterations_.last_change <= *options_.tolerance; }

  std::string what_is_left() const {
    if (motion_is_found()) return "accelerations no longer change, residuals of constraints are left";
    char number[32];
    std::snprintf(number, sizeof number, "%.1e", iterations_.last_change);
    return "relative change " + std::string(number);
  }

  std::string remedy() const {
    if (motion_is_found())
      return "here constraints contradict each other, the pose is singular, or masses are very far apart: begin in "
             "another pose, leave out joints that others imply, or raise max_iterations";
    return "raise penalty or max_iterations, or use formulation 'standard'";
  }

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  std::unique_ptr<SaddleSolver> saddle_;
  Options options_;
  VectorXd compliance_;
  Refinement refinement_;
  Refinement::Nearby nearby_ = [this](const ConstVector& r_1, const ConstVector& r_2, MutableVector dv,
                                      MutableVector dlambda) { saddle_->solve(r_1, r_2, dv, dlambda); };
  std::unique_ptr<ConjugateResiduals> residuals_;
  int repeated_ = 1;  ///< iterations of the last solution, without those of conjugate residuals
  std::unique_ptr<NaturalSize> size_;
  VectorXd free_motion_, changes_, sizes_;  ///< of each connected component
};

}  // namespace

FormulationInfo augmented_lagrangian_formulation() {
  return {.name = "augmented_lagrangian",
          .documentation = "Augmented Lagrangian iteration, Flores (2015) eq. (12.16)-(12.18), in incremental form",
          .forms = {"normal"},
          .options = {"penalty", "penalty_scale", "damping_ratio", "frequency", "tolerance", "max_iterations"},
          .make = [](std::unique_ptr<SaddleSolver> saddle, const Options& options) -> std::unique_ptr<Formulation> {
            return std::make_unique<AugmentedLagrangian>(std::move(saddle), options);
          }};
}

}  // namespace linkwork
