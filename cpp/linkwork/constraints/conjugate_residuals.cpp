#include "linkwork/constraints/conjugate_residuals.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/length_scale.hpp"

namespace linkwork {
namespace {

constexpr double exact = 1e-13, nearly_exact = 1e-10;  // residuals of rows, relative to their terms
constexpr double exact_free_motion = 1e-13;            // changes, relative to M^-1 a: all of x where it is at rest
constexpr double force_margin = 100.0;                 // multipliers are known so much less than accelerations
constexpr double at_rest = 0.01;      // of the largest terms: those of rows between bodies that are hardly accelerated
constexpr double unresisted = 1e-11;  // what D makes of a motion, D^T of multipliers, of natural size 1
constexpr double shrinking = 0.5;
constexpr double weakly_resisted = 1e-5;  // likewise: nearly singular
// Small steps are the end if there are some: quick motions, if they are large, hide the slow one that the next step is
// about. Near singular poses roundoff does, for more of them, and again.
constexpr int small_steps = 2, most_small_steps = 5, most_restarts = 3;
constexpr int patience = 3;

}  // namespace

ConjugateResiduals::ConjugateResiduals(const System& system)
    : system_(&system), size_(system), row_lengths_(VectorXd::Ones(system.row_count())) {
  for (VectorXd* velocities : {&r_1_, &none_, &dx_, &p_, &Mx_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&r_2_, &no_rows_, &terms_, &dlambda_, &p_lambda_, &Dp_}) rows->setZero(system.row_count());
}

void ConjugateResiduals::measure_rows(const Evaluation& at) { row_lengths_ = row_lengths(*system_, at); }

bool ConjugateResiduals::solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                               MutableVector lambda, const Refinement::Nearby& nearby, double enough, int most) {
  const double of_free_motion = exact_free_motion * size_.of_free_motion(a);
  double least = INFINITY;
  int small = 0, waiting = 0, restarts = 0;
  begin_anew();
  for (steps_ = 0; steps_ <= most; ++steps_) {
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    const double residual = residual_of_terms(at, b, x);
    waiting = residual < shrinking * least ? 0 : waiting + 1;
    least = std::min(least, residual);
    if (residual <= exact || (residual <= nearly_exact && waiting == patience)) return true;
    if (!find_step(at, nearby)) return true;
    const double motion = size_.of(p_), multipliers = largest(p_lambda_);
    if (largest_rate(Dp_) <= unresisted * motion) return true;
    const bool still = step_ * motion <= enough * size_.of(x) + of_free_motion;
    const bool steady = step_ * multipliers <= force_margin * enough * largest(lambda);
    const double resisted = NaturalSize::ratio(largest_force(at), multipliers);
    small = still && (steady || resisted <= unresisted) ? small + 1 : 0;
    const bool hides = resisted > unresisted && resisted < weakly_resisted &&
                       largest_rate(r_2_) > exact * (size_.of(x) + size_.of_free_motion(a));
    if (small > 0 && (residual <= nearly_exact || (small >= small_steps && !hides))) return true;
    if (small == most_small_steps) {
      if (restarts++ == most_restarts) return false;
      small = 0;
      begin_anew();
      continue;
    }
    nearby(r_1_, no_rows_, dx_, dlambda_);
    x += dx_ + step_ * p_;
    lambda += dlambda_ + step_ * p_lambda_;
  }
  return false;
}

void ConjugateResiduals::begin_anew() {
  square_ = 0.0;
  for (VectorXd* direction : {&p_, &p_lambda_, &Dp_}) direction->setZero();
}

/// Along the next direction. False: there is none but for roundoff.
bool ConjugateResiduals::find_step(const Evaluation& at, const Refinement::Nearby& nearby) {
  nearby(none_, r_2_, dx_, dlambda_);
  const double before = square_;
  system_->multiply_mass(at, dx_, Mx_);
  square_ = dx_.dot(Mx_);
  const double beta = before > 0.0 ? square_ / before : 0.0;
  p_ = dx_ + beta * p_;
  p_lambda_ = dlambda_ + beta * p_lambda_;
  system_->multiply_D(at, p_, Dp_);
  nearby(none_, Dp_, dx_, dlambda_);
  const double curvature = Dp_.dot(dlambda_);
  step_ = square_ / curvature;
  return square_ > 0.0 && curvature > 0.0;
}

/// Of the worst row.
double ConjugateResiduals::residual_of_terms(const Evaluation& at, const ConstVector& b, const ConstVector& x) {
  terms_ = b.cwiseAbs();
  for (const ConstraintBlock& block : system_->blocks())
    for (int r = 0; r < block.rows; ++r)
      for (int k = 0; k < velocity_size; ++k)
        terms_[block.row + r] +=
            std::abs(at.D[block.offset + velocity_size * r + k] * x[velocity_size * block.body + k]);
  const double floor = at_rest * largest_rate(terms_);
  double out = 0.0;
  for (Eigen::Index row = 0; row < terms_.size(); ++row)
    out = std::max(out, NaturalSize::ratio(std::abs(r_2_[row]), terms_[row] + floor * row_lengths_[row]));
  return out;
}

/// In forces of natural size.
double ConjugateResiduals::largest(const ConstVector& multipliers) const {
  double out = 0.0;
  for (Eigen::Index row = 0; row < multipliers.size(); ++row)
    out = std::max(out, std::abs(multipliers[row]) * row_lengths_[row]);
  return out;
}

double ConjugateResiduals::largest_rate(const VectorXd& rows) const {
  double out = 0.0;
  for (Eigen::Index row = 0; row < rows.size(); ++row) out = std::max(out, std::abs(rows[row]) / row_lengths_[row]);
  return out;
}

/// Of what the multipliers of the direction do to bodies.
double ConjugateResiduals::largest_force(const Evaluation& at) {
  Mx_.setZero();
  system_->add_D_transposed(at, p_lambda_, Mx_);
  double out = 0.0;
  for (int body = 0; body < system_->body_count(); ++body) {
    const auto force = Mx_.segment<velocity_size>(velocity_size * body);
    out = std::max({out, force.head<3>().norm() * size_.length(body), force.tail<3>().norm()});
  }
  return out;
}

}  // namespace linkwork
