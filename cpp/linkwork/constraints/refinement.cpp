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
constexpr double slow = 0.1;         // conjugate gradients need fewer
constexpr double most_growth = 1e3;  // of residuals
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
  for (VectorXd* velocities : {&r_1_, &dx_, &p_, &Mp_, &off_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&r_2_, &dlambda_, &p_lambda_, &off_lambda_}) rows->setZero(system.row_count());
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
  const FreeMotion free = free_motion(a);
  const double of_interest = cause == Inexactness::inertia ? free.of_heaviest : free.size;
  Corrections corrections(cause, of_interest);
  for (;;) {
    correct(at, a, b, x, lambda, nearby);
    const double size = size_of(x);
    const Progress progress = corrections.judge(size, size_of(dx_));
    if (progress == Progress::slow) return accelerate(at, a, b, x, lambda, nearby, free);
    if (progress != Progress::going_on) return progress == Progress::converged;
  }
}

/// Adds what takes D x to b, and returns its size.
double Refinement::restore(const Nearby& nearby, MutableVector x, MutableVector lambda) {
  Mp_.setZero();
  nearby(Mp_, r_2_, off_, off_lambda_);
  x += off_;
  lambda += off_lambda_;
  return size_of(off_);
}

/// dx, dlambda for r_1, on ker D: steps along it may be as much longer as M^ is above M, so that what it is off there is
/// taken away once more.
void Refinement::precondition(const Evaluation& at, const Nearby& nearby) {
  r_2_.setZero();
  nearby(r_1_, r_2_, dx_, dlambda_);
  system_->multiply_D(at, dx_, r_2_);
  r_2_ = -r_2_;
  restore(nearby, dx_, dlambda_);
}

/// Along p from here: on ker D r_1 . dx, `square`, is that of the residual in the norm of M^-1, and every D^T lambda in
/// r_1 is orthogonal to all directions. Where it is not positive, roundoff is what is left: dx is taken as it is, and
/// directions begin anew.
Refinement::Step Refinement::next_step(const Evaluation& at, double& square) {
  const double before = square;
  square = r_1_.dot(dx_);
  const double beta = before > 0.0 && square > 0.0 ? square / before : 0.0;
  p_ = dx_ + beta * p_;
  p_lambda_ = dlambda_ + beta * p_lambda_;
  system_->multiply_mass(at, p_, Mp_);
  const double curvature = p_.dot(Mp_), descent = r_1_.dot(p_);
  const Step out{descent / curvature, std::pow(size_of(p_), 2) / curvature};
  if (curvature > 0.0 && descent > 0.0) return out;
  p_ = dx_;
  p_lambda_ = dlambda_;
  square = 0.0;
  return {};
}

/// Ends where residuals are nothing, or roundoff and no longer shrink, though errors be as much larger as the longest
/// step was, or as residual forces make of the softest direction, whichever is less.
bool Refinement::accelerate(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                            MutableVector lambda, const Nearby& nearby, const FreeMotion& free) {
  double square = 0.0, first = 0.0, least = INFINITY;
  Step most{1.0, 0.0};
  int waiting = 0;
  p_.setZero();
  p_lambda_.setZero();
  for (int k = 0; k < most_accelerated; ++k) {
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    const double restored = restore(nearby, x, lambda);
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    precondition(at, nearby);
    const double residual = size_of(dx_), size = size_of(x);
    if (k == 0) first = residual;
    if (!(residual <= most_growth * std::max(first, exact * free.size))) return false;
    const double by_force = residual > 0.0 ? std::abs(r_1_.dot(dx_)) / residual * most.softness : 0.0;
    const double error = std::max(k > 0 ? std::min(most.length * residual, by_force) : residual, restored);
    if (error <= exact * (size + free.of_heaviest)) return true;
    const Step step = next_step(at, square);
    most = {std::max(most.length, step.length), std::max(most.softness, step.softness)};
    dx_ = step.length * p_;
    x += dx_;
    lambda += step.length * p_lambda_;
    waiting = residual < shrinking * least ? 0 : waiting + 1;
    least = std::min(least, residual);
    if (waiting >= patience && error <= std::max(roundoff * size, exact * free.size)) return true;
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

Refinement::FreeMotion Refinement::free_motion(const ConstVector& a) const {
  using saddle_products::Doubles;
  const double* masses = &system_->mass_blocks()[0].m;
  double force = 0.0, mass = 0.0;
  FreeMotion out;
  for (int body = 0; body < system_->body_count(); ++body) {
    const double m = saddle_products::mass_of<Doubles>(body, masses);
    const double size = saddle_products::size_of_forces<Doubles>(body, lengths_.data(), a.data());
    if (m > 0.0) out.size = std::max(out.size, size / m);
    force = std::max(force, size);
    mass = std::max(mass, m);
  }
  if (mass > 0.0) out.of_heaviest = force / mass;
  return out;
}

int Refinement::least_certain_body() const {
  int out = 0;
  for (int body = 1; body < system_->body_count(); ++body)
    if (size_of_body(dx_, body) > size_of_body(dx_, out)) out = body;
  return out;
}

}  // namespace linkwork
