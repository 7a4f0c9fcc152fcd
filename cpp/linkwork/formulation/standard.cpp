#include <algorithm>
#include <cmath>
#include <optional>

#include "linkwork/assembly/mass_ratios.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"
#include "linkwork/constraints/refinement.hpp"
#include "linkwork/formulation/direct_formulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

/// Lagrange multipliers: the system as it stands, or for the multipliers first,
///   [M  D^T] {  v_dot }   {a}
///   [D   0 ] {-lambda } = {b}                                                      (12.3)
///   (D M^-1 D^T) lambda = b - D M^-1 a                                             (12.5)
///   v_dot = M^-1 (a + D^T lambda)                                                  (12.4), (12.6)
/// Where bodies have very small inertias, and the solver does not eliminate them as they are, the matrix is that of
/// RegularizedInertia, and Refinement goes on from there.
class Standard final : public DirectFormulation {
 public:
  using DirectFormulation::DirectFormulation;

  void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) override {
    system_ = &system;
    inertia_ = rows.inertia;
    compliance_.setZero(rows.dropped.empty() ? 0 : system.row_count());  // (12.3) has no E
    for (const int row : rows.dropped) compliance_[row] = 1.0;
    saddle_->drop(rows.dropped);
    falls_back_ = false;
    regular_.reset();
    as_it_is_ = factorizes_as_it_is(typical);
    if (!as_it_is_) saddle_->analyze(inertia_->system(), typical);
    require_accuracy(accuracy_);
  }
  void require_accuracy(double relative) override {
    accuracy_ = relative;
    uneven_ = saddle_->loses_digits(MassRatios(*system_));
    refined_ = (!as_it_is_ && inertia_->refined(accuracy_)) || uneven_;
    if (refined_ || as_it_is_) refinement_ = Refinement(*system_, inertia_->lengths());
  }
  bool refines() const override { return refined_; }
  bool takes_small_inertias() const override { return as_it_is_; }

  void factorize(const Evaluation& at) override {
    attempt(at, [&] { DirectFormulation::factorize(at); });
  }
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override {
    saddle().solve(a, b, v_dot, lambda);
    refine(a, b, v_dot, lambda);
  }
  void factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector v_dot,
                           MutableVector lambda) override {
    if (!attempt(at, [&] { DirectFormulation::factorize_and_solve(at, a, b, v_dot, lambda); }))
      solve(a, b, v_dot, lambda);
  }
  SaddleSolver& saddle() const override { return falls_back_ ? regular_->saddle() : *saddle_; }
  void keep(Archive& archive) override { saddle_->keep(archive); }

 private:
  /// In the pose at first. Elsewhere they may have a motion with hardly any inertia, for which there is the other way.
  bool factorizes_as_it_is(const Evaluation& typical) {
    if (system_->massless_bodies().empty()) return false;
    try {
      if (!saddle_->analyze_as_it_is(*system_, typical, inertia_->regularized_bodies())) return false;
      saddle_->factorize(typical, compliance_);
    } catch (const SingularSystemError&) {
      return false;
    }
    return true;
  }

  /// False where small inertias do not do in this pose, and are regularized.
  template <class Factorize>
  bool attempt(const Evaluation& at, const Factorize& factorize) {
    falls_back_ = false;
    if (!as_it_is_) return factorize(), true;
    try {
      return factorize(), true;
    } catch (const SingularSystemError&) {
      if (!regular_ || regular_->saddle().reordered()) regular_.emplace(inertia_->system());
      falls_back_ = true;
    }
    at_ = &at;
    regular_->saddle().factorize(at, compliance_);
    return false;
  }

  void refine(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override {
    if (!refined_ && !falls_back_) return;
    const auto nearby = [this](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx,
                               MutableVector dlambda) { saddle().solve(r_1, r_2, dx, dlambda); };
    const bool regularized = inertia_->regularized() && (!as_it_is_ || falls_back_);
    const auto cause = regularized ? Inexactness::inertia : Inexactness::roundoff;
    const bool converged = refinement_.refine(*at_, a, b, v_dot, lambda, nearby, cause);
    if (!converged && regularized) throw_free_motion();
    if (!converged && uneven_) throw_uneven();
  }

  /// What very light bodies hold between very heavy ones is the difference of large numbers.
  [[noreturn]] void throw_uneven() const {
    ErrorDetails details;
    details.bodies = {system_->model().body_name(refinement_.least_certain_body())};
    throw NotConvergedError("uneven_masses",
                            "the accelerations are not determined to half of the digits, least of all that of body '" +
                                details.bodies.front() +
                                "': masses are too far apart; use another linear_solver, matrix_form 'schur', or "
                                "formulation 'augmented_lagrangian'",
                            details);
  }

  [[noreturn]] void throw_free_motion() const {
    ErrorDetails details;
    details.bodies = {system_->model().body_name(refinement_.least_certain_body())};
    throw SingularSystemError("free_massless_body",
                              "body '" + details.bodies.front() +
                                  "' has a motion without inertia that no joint resists in this pose; give it mass "
                                  "and inertia, or hold it by joints",
                              details);
  }

  const System* system_ = nullptr;
  const RegularizedInertia* inertia_ = nullptr;
  double accuracy_ = INFINITY;
  bool refined_ = false, as_it_is_ = false, uneven_ = false;
  bool falls_back_ = false;                          ///< what was factorized last is regularized, all the same
  std::optional<MassWeightedLeastSquares> regular_;  ///< where it was needed
  Refinement refinement_;
};

}  // namespace

FormulationInfo standard_formulation() {
  return {.name = "standard",
          .documentation = "Lagrange multipliers, Flores (2015) eq. (12.3) or (12.5)-(12.6)",
          .forms = {"schur", "kkt"},
          .needs_full_rank = true,
          .regularizes_inertia = true,
          .lanes = true,
          .make = [](std::unique_ptr<SaddleSolver> saddle, const Options&) -> std::unique_ptr<Formulation> {
            return std::make_unique<Standard>(std::move(saddle));
          }};
}

}  // namespace linkwork
