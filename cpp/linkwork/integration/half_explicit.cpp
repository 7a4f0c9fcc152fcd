#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// Of the acceleration of a stage: its error enters the velocity times h.
constexpr double exact = 1e-13, roundoff = 1e-8, shrinking = 0.5;
constexpr int most_iterations = 50;
constexpr double far = 0.3;  // rad
constexpr Eigen::Index most_vectors = 50;

void check(const HalfExplicitTableau& tableau) {
  const Eigen::Index s = tableau.A.rows();
  const auto refuse = [&](const std::string& why) {
    throw OptionError("tableau", "half-explicit method '" + tableau.name + "': " + why);
  };
  if (s < 1 || tableau.A.cols() != s || tableau.A_bar.rows() != s || tableau.A_bar.cols() != s)
    refuse("A and A_bar must be s x s");
  if (!tableau.A.allFinite() || !tableau.A_bar.allFinite()) refuse("a coefficient is not finite");
  if (tableau.A.triangularView<Eigen::Upper>().toDenseMatrix().cwiseAbs().maxCoeff() > 0.0)
    refuse("A must be strictly lower triangular");
  if (tableau.A_bar.triangularView<Eigen::StrictlyUpper>().toDenseMatrix().cwiseAbs().maxCoeff() > 0.0)
    refuse("A_bar must be lower triangular");
  const Eigen::Index first = tableau.explicit_first_stage ? 1 : 0;
  if (s == first || tableau.A_bar.diagonal().tail(s - first).cwiseAbs().minCoeff() == 0.0)
    refuse("the diagonal of A_bar must not vanish");
  if (std::abs(tableau.A_bar.row(s - 1).sum() - 1.0) > consistency) refuse("the last row of A_bar must add up to 1");
}

/// Half-explicit Runge-Kutta, Brasey and Hairer (1993), SIAM J. Numer. Anal. 30, 538-552, and Murua (1997), Computing
/// 59, 43-61. With Y_i = y + h sum_{j<i} a_ij k_j and Yb_i = y + h sum_{j<=i} ab_ij k_j, k = (N V, V'), stage i solves
///   M V'_i - D(Q_i)^T L_i = g(Q_i, V_i),   D(Qb_i) V'_i = -(D(Qb_i) Vp_i + Phi_t(Qb_i)) / (h ab_ii),
/// Vp_i the part of Vb_i without V'_i, so that Yb_i satisfies the velocity constraints; the new state is Yb_s.
///
/// The matrix [M D(Q_i)^T; D(Qb_i) 0] is not symmetric. Its solution is found by iterative refinement with the
/// formulation's factorization at Q_i: with r = b - D(Qb_i) x,
///   M dx - D(Q_i)^T dL = 0,   D(Q_i) dx = r.
/// The residual shrinks by |(D(Qb_i) - D(Q_i)) M^-1 D^T S^-1| = O(h) each time, about the angle that bodies turn
/// between Q_i and Qb_i. Near a singular pose S^-1 is large in one direction; there GMRES solves
///   D(Qb_i) P y = r,   P y = dx,
/// whose matrix is the identity but for a few directions.
class HalfExplicit final : public Integrator {
 public:
  explicit HalfExplicit(const HalfExplicitTableau& tableau) : tableau_(tableau) { check(tableau); }

  const std::string& name() const override { return tableau_.name; }
  int order() const override { return tableau_.order; }

  void check_run(const Dynamics& dynamics) const override {
    const StabilizationKind kind = dynamics.stabilization();
    if (kind == StabilizationKind::baumgarte || kind == StabilizationKind::sampled_baumgarte)
      throw OptionError("conflict", "integrator '" + name() +
                                        "' meets the velocity constraints themselves and has no " +
                                        "use for stabilization '" + dynamics.options().stabilization +
                                        "': choose 'projection', 'position_projection' or 'none'");
  }

  void start(int y_size) override {
    k_.resize(y_size, tableau_.A.rows());
    for (VectorXd* state : {&stage_, &met_}) state->resize(y_size);
    at_.reset();
  }

  void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) override {
    const double h = step.h;
    prepare(dynamics.system());
    for (Eigen::Index i = 0; i < tableau_.A.rows(); ++i) {
      if (i > 0)
        dynamics.evaluate(step.at(tableau_.A.row(i).sum()), sum(tableau_.A, i, i, h, y, stage_),
                          static_cast<int>(i) + 1);
      else stage_ = y;
      if (i == 0 && tableau_.explicit_first_stage) dynamics.accelerations(x_, lambda_);
      else constrain(dynamics, step, y, i);
      dynamics.rates(x_, lambda_, k_.col(i));
    }
    sum(tableau_.A_bar, tableau_.A.rows() - 1, tableau_.A.rows(), h, y, stage_);
    y = stage_;
  }

 private:
  void prepare(const System& system) {
    if (at_) return;
    at_ = std::make_unique<Evaluation>(system.make_evaluation());
    size_ = std::make_unique<NaturalSize>(system);
    for (VectorXd* velocities : {&x_, &dx_}) velocities->setZero(system.v_size());
    none_ = x_;
    for (VectorXd* rows : {&lambda_, &dlambda_, &b_, &residual_}) rows->setZero(system.row_count());
  }

  /// out = y + h sum_{j < count} coefficients_ij k_j
  VectorXd& sum(const MatrixXd& coefficients, Eigen::Index i, Eigen::Index count, double h, const VectorXd& y,
                VectorXd& out) const {
    out = y;
    for (Eigen::Index j = 0; j < count; ++j)
      if (coefficients(i, j) != 0.0) out += (h * coefficients(i, j)) * k_.col(j);
    return out;
  }

  /// V'_i and L_i, at the state stage_ where `dynamics` is evaluated.
  void constrain(Dynamics& dynamics, const StepSpan& step, const VectorXd& y, Eigen::Index i) {
    const System& system = dynamics.system();
    const int nq = system.q_size(), nv = system.v_size();
    const double own = step.h * tableau_.A_bar(i, i);
    sum(tableau_.A_bar, i, i, step.h, y, met_);
    system.position_rates(stage_.head(nq), stage_.segment(nq, nv), k_.col(i).head(nq));
    met_.head(nq) += own * k_.col(i).head(nq);
    system.evaluate_constraints(step.at(tableau_.A_bar.row(i).sum()), met_.head(nq), met_.segment(nq, nv),
                                dynamics.history(), *at_);
    b_ = at_->Phi_dot / -own;
    dynamics.solve(dynamics.evaluation().g.head(nv), b_, x_, lambda_);
    if (system.row_count() > 0) refine(dynamics);
  }

  void refine(Dynamics& dynamics) {
    size_->of_free_motion(dynamics.evaluation().g.head(x_.size()), free_motion_);
    double last = INFINITY;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      dynamics.system().multiply_D(*at_, x_, residual_);
      residual_ = b_ - residual_;
      dynamics.solve(none_, residual_, dx_, dlambda_);
      x_ += dx_;
      lambda_ += dlambda_;
      size_->of(dx_, changes_);
      size_->of(x_, sizes_);
      sizes_ += free_motion_;
      const double change = NaturalSize::largest_ratio(changes_, sizes_);
      if (change <= exact || (change <= roundoff && change > shrinking * last)) return;
      if (!(change <= last)) break;
      last = change;
    }
    const double turn = largest_turn(dynamics.system());
    if (turn > far || !solve_by_krylov(dynamics)) throw_not_met(turn);
  }

  /// Between Q_i and Qb_i, of any body [rad].
  double largest_turn(const System& system) const {
    double largest = 0.0;
    for (int body = 0; body < system.body_count(); ++body) {
      const Eigen::Index p = 7 * body + 3;
      largest = std::max(largest, 2.0 * (met_.segment<4>(p) - stage_.segment<4>(p)).norm());
    }
    return largest;
  }

  /// GMRES with modified Gram-Schmidt and Givens rotations, Saad and Schultz (1986), SIAM J. Sci. Stat. Comput. 7,
  /// 856-869, from the solution without D(Qb_i). False where it does not converge.
  bool solve_by_krylov(Dynamics& dynamics) {
    dynamics.solve(dynamics.evaluation().g.head(x_.size()), b_, x_, lambda_);
    find_residual(dynamics, b_, x_);
    const double size = b_.norm() + (b_ - residual_).norm(), start = residual_.norm();
    std::vector<VectorXd> basis = {residual_ / start};
    MatrixXd H = MatrixXd::Zero(most_vectors + 1, most_vectors);
    VectorXd s = VectorXd::Zero(most_vectors + 1);
    std::vector<Eigen::JacobiRotation<double>> rotations;
    s[0] = start;
    Eigen::Index k = 0;
    for (; k < most_vectors && std::abs(s[k]) > exact * size; ++k) {
      dynamics.solve(none_, basis[k], dx_, dlambda_);
      dynamics.system().multiply_D(*at_, dx_, residual_);
      dynamics.dropped().take_from(residual_);
      for (Eigen::Index i = 0; i <= k; ++i) {
        H(i, k) = residual_.dot(basis[i]);
        residual_ -= H(i, k) * basis[i];
      }
      H(k + 1, k) = residual_.norm();
      if (!std::isfinite(H(k + 1, k))) return false;
      basis.push_back(H(k + 1, k) > 0.0 ? VectorXd(residual_ / H(k + 1, k)) : residual_);
      for (Eigen::Index i = 0; i < k; ++i) H.col(k).applyOnTheLeft(i, i + 1, rotations[i].adjoint());
      rotations.emplace_back();
      rotations.back().makeGivens(H(k, k), H(k + 1, k));
      H.col(k).applyOnTheLeft(k, k + 1, rotations.back().adjoint());
      s.applyOnTheLeft(k, k + 1, rotations.back().adjoint());
    }
    const VectorXd weights = H.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(s.head(k));
    residual_.setZero();
    for (Eigen::Index i = 0; i < k; ++i) residual_ += weights[i] * basis[i];
    const VectorXd y = residual_;
    dynamics.solve(none_, y, dx_, dlambda_);
    x_ += dx_;
    lambda_ += dlambda_;
    find_residual(dynamics, b_, x_);
    return residual_.norm() <= roundoff * size;
  }

  /// residual_ = b - D(Qb_i) x, without the redundant rows.
  void find_residual(Dynamics& dynamics, const VectorXd& b, const VectorXd& x) {
    dynamics.system().multiply_D(*at_, x, residual_);
    residual_ = b - residual_;
    dynamics.dropped().take_from(residual_);
  }

  /// A body that turns far does so because the step is long for the motion, or because it has become unstable.
  [[noreturn]] void throw_not_met(double turn) const {
    char angle[32];
    std::snprintf(angle, sizeof angle, "%.2g rad", turn);
    const std::string why =
        turn > far ? std::string("a body turns too far (") + angle +
                         ") within a stage, as the step is too long for the motion, or for stiff force elements, whose "
                         "vibration it lets grow"
                   : "the equations of its loops are nearly dependent there";
    throw NotConvergedError(
        "half_explicit",
        "integrator '" + name() + "': a stage does not meet its velocity constraints: " + why + "; use a smaller step");
  }

  HalfExplicitTableau tableau_;
  std::unique_ptr<Evaluation> at_;  ///< of the constraints at Yb_i
  std::unique_ptr<NaturalSize> size_;
  VectorXd free_motion_, changes_, sizes_;  ///< of each connected component
  MatrixXd k_;
  VectorXd stage_, met_, x_, dx_, none_, lambda_, dlambda_, b_, residual_;
};

}  // namespace

std::unique_ptr<Integrator> make_half_explicit(const HalfExplicitTableau& tableau) {
  return std::make_unique<HalfExplicit>(tableau);
}

}  // namespace linkwork
