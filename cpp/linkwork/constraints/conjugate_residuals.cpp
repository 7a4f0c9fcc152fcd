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
constexpr double balanced = 1e-11;    // accelerations, by forces on the heaviest body: roundoff where these balance
constexpr double unresisted = 1e-11;  // what D makes of a motion, D^T of multipliers, of natural size 1
constexpr double nothing = 1e-290;    // residuals that are not known to digits, as of b just behind a driver's start
constexpr double shrinking = 0.5;
constexpr double weakly_resisted = 1e-5;  // likewise: nearly singular
// Small steps are the end if there are some: quick motions, if they are large, hide the slow one that the next step is
// about. Near singular poses roundoff does, for more of them, and again.
constexpr int small_steps = 2, most_small_steps = 5, most_restarts = 3;
constexpr int patience = 3;
constexpr double smallest = 1e-50;  // of directions: squares of what is smaller are lost

/// A power of two, so that nothing else changes.
double scale_of(const VectorXd& direction) {
  const double largest = direction.size() > 0 ? direction.cwiseAbs().maxCoeff() : 0.0;
  return largest > 0.0 && largest < smallest ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1023)) : 1.0;
}

}  // namespace

ConjugateResiduals::ConjugateResiduals(const System& system)
    : system_(&system),
      components_(&ConnectedComponents::of(system)),
      size_(system),
      row_lengths_(VectorXd::Ones(system.row_count())),
      progress_(components_->count()) {
  for (VectorXd* velocities : {&r_1_, &none_, &dx_, &p_, &Mx_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&r_2_, &no_rows_, &terms_, &dlambda_, &p_lambda_, &Dp_}) rows->setZero(system.row_count());
}

void ConjugateResiduals::measure_rows(const Evaluation& at) { row_lengths_ = row_lengths(*system_, at); }

bool ConjugateResiduals::solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                               MutableVector lambda, const Refinement::Nearby& nearby, double enough, int most) {
  size_.of_free_motion(a, free_motion_);
  size_.of_heaviest(a, of_heaviest_);
  progress_.assign(progress_.size(), {});
  int restarts = 0;
  begin_anew();
  for (steps_ = 0; steps_ <= most; ++steps_) {
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    if (satisfies_rows(at, b, x) || !find_step(at, nearby) || !go_on(at, x, lambda, enough)) return true;
    if (std::any_of(progress_.begin(), progress_.end(), [](const Progress& it) { return it.has_stalled(); })) {
      if (restarts++ == most_restarts) return false;
      for (Progress& it : progress_) it.small = it.has_stalled() ? 0 : it.small;
      begin_anew();
      continue;
    }
    nearby(r_1_, no_rows_, dx_, dlambda_);
    x += dx_ + step_ * p_;
    lambda += dlambda_ + step_ * p_lambda_;
  }
  return false;
}

bool ConjugateResiduals::Progress::has_stalled() const { return !done && small == most_small_steps; }

void ConjugateResiduals::begin_anew() {
  square_ = 0.0;
  for (VectorXd* direction : {&p_, &p_lambda_, &Dp_}) direction->setZero();
}

/// Whether all components are done by what their rows have left; of those that are nothing is left.
bool ConjugateResiduals::satisfies_rows(const Evaluation& at, const ConstVector& b, const ConstVector& x) {
  find_residuals_of_terms(at, b, x);
  return mark_done([this](std::size_t component, Progress& it) {
    const double residual = residuals_[static_cast<Eigen::Index>(component)];
    it.waiting = residual < shrinking * it.least ? 0 : it.waiting + 1;
    it.least = std::min(it.least, residual);
    return residual <= exact || (residual <= nearly_exact && it.waiting == patience);
  });
}

/// False where all components are done by what the step changes.
bool ConjugateResiduals::go_on(const Evaluation& at, const ConstVector& x, const ConstVector& lambda, double enough) {
  measure_step(at, x, lambda);
  return !mark_done([&](std::size_t component, Progress& it) {
    const auto k = static_cast<Eigen::Index>(component);
    if (rates_[k] <= unresisted * motions_[k]) return true;
    const bool still = step_ * motions_[k] <= enough * sizes_[k] + exact_free_motion * free_motion_[k];
    const bool steady = step_ * multipliers_[k] <= force_margin * enough * all_multipliers_[k];
    const double resisted = NaturalSize::ratio(forces_[k], multipliers_[k]);
    it.small = still && (steady || resisted <= unresisted) ? it.small + 1 : 0;
    const bool hides =
        resisted > unresisted && resisted < weakly_resisted && left_[k] > exact * (sizes_[k] + free_motion_[k]);
    return it.small > 0 && (residuals_[k] <= nearly_exact || (it.small >= small_steps && !hides));
  });
}

/// Marks components that are, and takes all those out of residuals and direction. True: there are no others.
template <class IsDone>
bool ConjugateResiduals::mark_done(const IsDone& is_done) {
  bool all = true, some = false;
  for (std::size_t k = 0; k < progress_.size(); ++k) {
    Progress& it = progress_[k];
    if (!it.done && is_done(k, it)) {
      it.done = true;
      square_ = 0.0;  // the next direction is a first one
    }
    (it.done ? some : all) = it.done;
  }
  if (all || !some) return all;
  const auto done = [this](int component) { return progress_[static_cast<std::size_t>(component)].done; };
  for (int body = 0; body < system_->body_count(); ++body)
    if (done(components_->of_body(body))) p_.segment<velocity_size>(velocity_size * body).setZero();
  for (Eigen::Index row = 0; row < r_2_.size(); ++row)
    if (done(components_->of_row(row))) r_2_[row] = p_lambda_[row] = Dp_[row] = 0.0;
  return false;
}

/// Along the next direction. False: there is none but for roundoff.
bool ConjugateResiduals::find_step(const Evaluation& at, const Refinement::Nearby& nearby) {
  nearby(none_, r_2_, dx_, dlambda_);
  const double before = square_;
  if (!(before > 0.0)) scale_ = scale_of(dx_);
  dx_ *= scale_;
  dlambda_ *= scale_;
  system_->multiply_mass(at, dx_, Mx_);
  square_ = dx_.dot(Mx_);
  const double beta = before > 0.0 ? square_ / before : 0.0;
  p_ = dx_ + beta * p_;
  p_lambda_ = dlambda_ + beta * p_lambda_;
  system_->multiply_D(at, p_, Dp_);
  nearby(none_, Dp_, dx_, dlambda_);
  const double curvature = Dp_.dot(dlambda_);
  step_ = square_ / curvature / scale_;
  return square_ > 0.0 && curvature > 0.0;
}

/// Of the worst row of each component.
void ConjugateResiduals::find_residuals_of_terms(const Evaluation& at, const ConstVector& b, const ConstVector& x) {
  terms_ = b.cwiseAbs();
  for (const ConstraintBlock& block : system_->blocks())
    for (int r = 0; r < block.rows; ++r)
      for (int k = 0; k < velocity_size; ++k)
        terms_[block.row + r] +=
            std::abs(at.D[block.offset + velocity_size * r + k] * x[velocity_size * block.body + k]);
  find_largest_rates(terms_, rates_);
  residuals_.setZero(rates_.size());
  for (Eigen::Index row = 0; row < terms_.size(); ++row) {
    const int component = components_->of_row(row);
    const bool balance = rates_[component] <= balanced * of_heaviest_[component];
    const double largest = balance ? of_heaviest_[component] : rates_[component];
    const double floor = at_rest * largest * row_lengths_[row] + nothing;
    residuals_[component] =
        std::max(residuals_[component], NaturalSize::ratio(std::abs(r_2_[row]), terms_[row] + floor));
  }
}

void ConjugateResiduals::measure_step(const Evaluation& at, const ConstVector& x, const ConstVector& lambda) {
  size_.of(x, sizes_);
  size_.of(p_, motions_);
  find_largest_rates(Dp_, rates_);
  find_largest_rates(r_2_, left_);
  find_largest(p_lambda_, multipliers_);
  find_largest(lambda, all_multipliers_);
  find_largest_forces(at);
}

/// In forces of natural size.
void ConjugateResiduals::find_largest(const ConstVector& multipliers, VectorXd& components) const {
  components.setZero(components_->count());
  for (Eigen::Index row = 0; row < multipliers.size(); ++row) {
    double& largest = components[components_->of_row(row)];
    largest = std::max(largest, std::abs(multipliers[row]) * row_lengths_[row]);
  }
}

void ConjugateResiduals::find_largest_rates(const VectorXd& rows, VectorXd& components) const {
  components.setZero(components_->count());
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    double& largest = components[components_->of_row(row)];
    largest = std::max(largest, std::abs(rows[row]) / row_lengths_[row]);
  }
}

/// Of what the multipliers of the direction do to bodies.
void ConjugateResiduals::find_largest_forces(const Evaluation& at) {
  Mx_.setZero();
  system_->add_D_transposed(at, p_lambda_, Mx_);
  forces_.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    const auto force = Mx_.segment<velocity_size>(velocity_size * body);
    double& largest = forces_[components_->of_body(body)];
    largest = std::max({largest, force.head<3>().norm() * size_.length(body), force.tail<3>().norm()});
  }
}

}  // namespace linkwork
