#include "linkwork/constraints/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/saddle_products.hpp"

namespace linkwork {
namespace {

// Corrections, relative to the size of the solution: where they are nothing, and where those that no longer shrink are
// roundoff; what the first one may be where factors are good, because the second is the square of it.
constexpr double exact = 1e-14, roundoff = 1e-7, roundoff_in_pose = 1e-10, shrinking = 0.5;
constexpr double second_order = 1e-8;
constexpr double slow = 0.1;  // conjugate gradients need fewer
constexpr int most_corrections = 30, most_accelerated = 100, patience = 3;

}  // namespace

Corrections::Corrections(Inexactness cause, double free_motion)
    : cause_(cause), free_motion_(free_motion), enough_(cause == Inexactness::roundoff ? second_order : exact) {}

Corrections::Progress Corrections::judge(double solution, double correction) {
  const bool inertia = cause_ == Inexactness::inertia;
  const double size = solution + free_motion_;
  count_ += 1;
  if (correction <= enough_ * size) return Progress::converged;
  if (!std::isfinite(correction)) return Progress::diverged;
  if (inertia && correction > slow * last_) return Progress::slow;
  const double noise = cause_ == Inexactness::singular_pose ? roundoff_in_pose : roundoff;
  if (!inertia && correction > shrinking * last_ && correction <= noise * size) return Progress::converged;
  last_ = correction;
  enough_ = exact;
  return count_ < most_corrections ? Progress::going_on : Progress::diverged;
}

Refinement::Refinement(const System& system, const VectorXd& lengths) : system_(&system), lengths_(lengths) {
  for (VectorXd* velocities : {&r_1_, &dx_, &p_, &Mp_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&r_2_, &dlambda_, &p_lambda_}) rows->setZero(system.row_count());
}

void find_saddle_residuals(const System& system, const Evaluation& at, const ConstVector& a, const ConstVector& b,
                           const ConstVector& x, const ConstVector& lambda, VectorXd& r_1, VectorXd& r_2) {
  system.multiply_mass(at, x, r_1);
  r_1 = a - r_1;
  system.add_D_transposed(at, lambda, r_1);
  system.multiply_D(at, x, r_2);
  r_2 = b - r_2;
}

void Refinement::correct(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                         MutableVector lambda, const Nearby& nearby) {
  find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
  nearby(r_1_, r_2_, dx_, dlambda_);
  x += dx_;
  lambda += dlambda_;
}

bool Refinement::refine(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                        MutableVector lambda, const Nearby& nearby, Inexactness cause) {
  using Progress = Corrections::Progress;
  const double free = size_of_free_motion(a);
  Corrections corrections(cause, free);
  for (;;) {
    correct(at, a, b, x, lambda, nearby);
    const double size = size_of(x);
    const Progress progress = corrections.judge(size, size_of(dx_));
    if (progress == Progress::slow) return accelerate(at, a, b, x, lambda, nearby, size + free);
    if (progress != Progress::going_on) return progress == Progress::converged;
  }
}

/// From a solution with r_2 = 0 but for roundoff: then r_1 . dx is the square of the residual in the norm of M^-1 on
/// ker D, and every D^T lambda in r_1 is orthogonal to all directions. Ends where steps are nothing, or where residuals
/// are roundoff and no longer shrink.
bool Refinement::accelerate(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                            MutableVector lambda, const Nearby& nearby, double size) {
  double square = 0.0, least = INFINITY;
  int waiting = 0;
  p_.setZero();
  p_lambda_.setZero();
  for (int k = 0; k < most_accelerated; ++k) {
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    nearby(r_1_, r_2_, dx_, dlambda_);
    const double residual = size_of(dx_), before = square;
    square = r_1_.dot(dx_);
    const double beta = before > 0.0 && square > 0.0 ? square / before : 0.0;
    p_ = dx_ + beta * p_;
    p_lambda_ = dlambda_ + beta * p_lambda_;
    system_->multiply_mass(at, p_, Mp_);
    const double curvature = p_.dot(Mp_), descent = r_1_.dot(p_);
    if (!(curvature > 0.0) || !(descent > 0.0)) return residual <= roundoff * size;
    const double step = descent / curvature;
    dx_ = step * p_;
    x += dx_;
    lambda += step * p_lambda_;
    size = std::max(size, size_of(x));
    waiting = residual < shrinking * least ? 0 : waiting + 1;
    least = std::min(least, residual);
    if (size_of(dx_) <= exact * size || (waiting == patience && residual <= roundoff * size)) return true;
  }
  return false;
}

double Refinement::size_of_body(const ConstVector& x, int body) const {
  return saddle_products::size<saddle_products::Doubles>(body, lengths_.data(), x.data());
}

double Refinement::size_of(const ConstVector& x) const {
  double out = 0.0;
  for (int body = 0; body < system_->body_count(); ++body) out = std::max(out, size_of_body(x, body));
  return out;
}

/// M^-1 a, bodies without inertia taken for what their lengths make of their masses.
double Refinement::size_of_free_motion(const ConstVector& a) const {
  using saddle_products::Doubles;
  const std::vector<MassBlock>& blocks = system_->mass_blocks();
  double out = 0.0;
  for (int body = 0; body < system_->body_count(); ++body)
    if (blocks[body].m > 0.0)
      out = std::max(out, saddle_products::size_of_free_motion<Doubles>(body, lengths_.data(), &blocks[0].m, a.data()));
  return out;
}

int Refinement::least_certain_body() const {
  int out = 0;
  for (int body = 1; body < system_->body_count(); ++body)
    if (size_of_body(dx_, body) > size_of_body(dx_, out)) out = body;
  return out;
}

}  // namespace linkwork
