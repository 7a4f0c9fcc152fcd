#include "linkwork/constraints/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/assembly/saddle_products.hpp"
#include "linkwork/constraints/natural_size.hpp"

namespace linkwork {
namespace {

// Corrections, relative to the size of the solution: where they are nothing, and where those that no longer shrink are
// roundoff; what the first one may be where factors are good, because the second is the square of it.
constexpr double exact = 1e-14, roundoff = 1e-7, roundoff_in_pose = 1e-10, shrinking = 0.5;
constexpr double second_order = 1e-8;
constexpr double slow = 0.1;         // conjugate gradients need fewer
constexpr double most_growth = 1e3;  // of residuals
constexpr double balance = 1e-12;    // errors, relative to forces on the heaviest body: roundoff where these balance
constexpr double nothing = 1e-60;    // in any unit
constexpr int most_corrections = 30, most_accelerated = 100, patience = 3;

}  // namespace

Corrections::Corrections(Inexactness cause)
    : cause_(cause), enough_(cause == Inexactness::roundoff ? second_order : exact) {}

Corrections::Progress Corrections::judge(double correction) {
  const bool inertia = cause_ == Inexactness::inertia;
  count_ += 1;
  if (correction <= enough_) return Progress::converged;
  if (!std::isfinite(correction)) return Progress::diverged;
  if (inertia && correction > slow * last_) return Progress::slow;
  const double noise = cause_ == Inexactness::singular_pose ? roundoff_in_pose : roundoff;
  if (!inertia && correction > shrinking * last_ && correction <= noise) return Progress::converged;
  last_ = correction;
  enough_ = exact;
  return count_ < most_corrections ? Progress::going_on : Progress::diverged;
}

Refinement::Refinement(const System& system, const VectorXd& lengths)
    : system_(&system), components_(&ConnectedComponents::of(system)), lengths_(lengths) {
  for (VectorXd* velocities : {&r_1_, &dx_, &p_, &Mp_, &off_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&r_2_, &dlambda_, &p_lambda_, &off_lambda_}) rows->setZero(system.row_count());
  for (VectorXd* components : {&restored_, &factors_, &anew_}) components->setZero(components_->count());
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
  find_free_motion(a);
  Corrections corrections(cause);
  for (;;) {
    correct(at, a, b, x, lambda, nearby);
    const Progress progress = corrections.judge(largest_correction(x, cause));
    if (progress == Progress::slow) return accelerate(at, a, b, x, lambda, nearby);
    if (progress != Progress::going_on) return progress == Progress::converged;
  }
}

double Refinement::largest_correction(const ConstVector& x, Inexactness cause) {
  find_sizes(dx_, corrections_);
  find_sizes(x, sizes_);
  sizes_ += cause == Inexactness::inertia ? of_heaviest_ : free_motion_;
  return NaturalSize::largest_ratio(corrections_, sizes_);
}

/// Adds what takes D x to b.
void Refinement::restore(const Nearby& nearby, MutableVector x, MutableVector lambda) {
  Mp_.setZero();
  nearby(Mp_, r_2_, off_, off_lambda_);
  x += off_;
  lambda += off_lambda_;
}

/// dx, dlambda for r_1, on ker D: steps along it may be as much longer as M^ is above M, so that what it is off there
/// is taken away once more.
void Refinement::precondition(const Evaluation& at, const Nearby& nearby) {
  r_2_.setZero();
  nearby(r_1_, r_2_, dx_, dlambda_);
  system_->multiply_D(at, dx_, r_2_);
  r_2_ = -r_2_;
  restore(nearby, dx_, dlambda_);
}

/// Components are done where residuals are nothing, or roundoff and no longer shrink, though errors be as much larger
/// as the longest step was, or as residual forces make of the softest direction, whichever is less. Where forces
/// balance, the solution is no more than their roundoff, which is what M^ makes of it. False: they grow.
bool Refinement::judge_residuals(const ConstVector& x) {
  find_sizes(dx_, corrections_);
  find_sizes(x, sizes_);
  find_products(r_1_, dx_, descents_);
  for (std::size_t component = 0; component < progress_.size(); ++component) {
    const auto k = static_cast<Eigen::Index>(component);
    Progress& it = progress_[component];
    if (it.done) continue;
    const bool begins = it.least == INFINITY;
    const double residual = corrections_[k], size = sizes_[k];
    if (begins) it.first = residual;
    if (!(residual <= most_growth * std::max(it.first, exact * free_motion_[k]))) return false;
    const double by_force = NaturalSize::ratio(std::abs(descents_[k]), residual) * it.softest;
    const double error = std::max(begins ? residual : std::min(it.longest * residual, by_force), restored_[k]);
    it.waiting = residual < shrinking * it.least ? 0 : it.waiting + 1;
    it.least = std::min(it.least, residual);
    const bool balanced = it.has_inertia && error <= balance * of_heaviest_[k];
    it.done = error <= std::max(nothing, exact * (size + of_heaviest_[k])) ||
              (it.waiting >= patience && (balanced || error <= std::max(roundoff * size, exact * free_motion_[k])));
  }
  return true;
}

bool Refinement::done() const {
  return std::all_of(progress_.begin(), progress_.end(), [](const Progress& it) { return it.done; });
}

/// On ker D r_1 . dx is the square of the residual in the norm of M^-1, and every D^T lambda in r_1 is orthogonal to
/// all directions.
void Refinement::find_directions() {
  for (std::size_t component = 0; component < progress_.size(); ++component) {
    const auto k = static_cast<Eigen::Index>(component);
    const double before = std::exchange(progress_[component].square, descents_[k]);
    factors_[k] = before > 0.0 && descents_[k] > 0.0 ? descents_[k] / before : 0.0;
  }
  off_ = dx_;
  off_lambda_ = dlambda_;
  add(factors_, p_, p_lambda_, off_, off_lambda_);
  p_.swap(off_);
  p_lambda_.swap(off_lambda_);
}

/// Along p from here. Where r_1 . p or p . M p is not positive, roundoff is what is left: dx is taken as it is, and
/// directions begin anew.
void Refinement::find_steps(const Evaluation& at) {
  system_->multiply_mass(at, p_, Mp_);
  find_sizes(p_, corrections_);
  find_products(r_1_, p_, descents_);
  find_products(p_, Mp_, curvatures_);
  for (std::size_t component = 0; component < progress_.size(); ++component) {
    const auto k = static_cast<Eigen::Index>(component);
    Progress& it = progress_[component];
    const bool descends = curvatures_[k] > 0.0 && descents_[k] > 0.0;
    factors_[k] = !it.done && descends ? descents_[k] / curvatures_[k] : 0.0;
    anew_[k] = !it.done && !descends ? 1.0 : 0.0;
    if (!descends) it.square = 0.0;
    it.has_inertia = it.has_inertia && (curvatures_[k] > 0.0 || corrections_[k] == 0.0);
    it.longest = std::max(it.longest, factors_[k]);
    if (descends) it.softest = std::max(it.softest, std::pow(corrections_[k], 2) / curvatures_[k]);
  }
}

bool Refinement::accelerate(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                            MutableVector lambda, const Nearby& nearby) {
  progress_.assign(static_cast<std::size_t>(components_->count()), {});
  p_.setZero();
  p_lambda_.setZero();
  for (int k = 0; k < most_accelerated; ++k) {
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    restore(nearby, x, lambda);
    find_sizes(off_, restored_);
    find_saddle_residuals(*system_, at, a, b, x, lambda, r_1_, r_2_);
    precondition(at, nearby);
    if (!judge_residuals(x)) return false;
    if (done()) return true;
    find_directions();
    find_steps(at);
    add(factors_, p_, p_lambda_, x, lambda);
    add(anew_, dx_, dlambda_, x, lambda);
  }
  return false;
}

/// To x and lambda these times the factors of their connected components.
void Refinement::add(const VectorXd& factors, const VectorXd& x, const VectorXd& lambda, MutableVector to_x,
                     MutableVector to_lambda) const {
  for (int body = 0; body < system_->body_count(); ++body)
    to_x.segment<velocity_size>(velocity_size * body) +=
        factors[components_->of_body(body)] * x.segment<velocity_size>(velocity_size * body);
  for (Eigen::Index row = 0; row < lambda.size(); ++row)
    to_lambda[row] += factors[components_->of_row(row)] * lambda[row];
}

double Refinement::size_of_body(const ConstVector& x, int body) const {
  const double size = saddle_products::size<saddle_products::Doubles>(body, lengths_.data(), x.data());
  return std::isfinite(size) ? size : INFINITY;
}

void Refinement::find_sizes(const ConstVector& x, VectorXd& components) const {
  components.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    double& largest = components[components_->of_body(body)];
    largest = std::max(largest, size_of_body(x, body));
  }
}

void Refinement::find_products(const VectorXd& x, const VectorXd& y, VectorXd& components) const {
  components.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    const int first = velocity_size * body;
    components[components_->of_body(body)] += x.segment<velocity_size>(first).dot(y.segment<velocity_size>(first));
  }
}

void Refinement::find_free_motion(const ConstVector& a) {
  using saddle_products::Doubles;
  const double* masses = &system_->mass_blocks()[0].m;
  for (VectorXd* components : {&free_motion_, &of_heaviest_, &sizes_}) components->setZero(components_->count());
  VectorXd& heaviest = sizes_;
  for (int body = 0; body < system_->body_count(); ++body) {
    const int k = components_->of_body(body);
    const double m = saddle_products::mass_of<Doubles>(body, masses);
    const double force = saddle_products::size_of_forces<Doubles>(body, lengths_.data(), a.data());
    if (m > 0.0) free_motion_[k] = std::max(free_motion_[k], force / m);
    of_heaviest_[k] = std::max(of_heaviest_[k], force);
    heaviest[k] = std::max(heaviest[k], m);
  }
  for (Eigen::Index k = 0; k < heaviest.size(); ++k)
    of_heaviest_[k] = heaviest[k] > 0.0 ? of_heaviest_[k] / heaviest[k] : 0.0;
}

int Refinement::least_certain_body() const {
  const auto part = [this](int body) {
    return NaturalSize::ratio(size_of_body(dx_, body), sizes_[components_->of_body(body)]);
  };
  int out = 0;
  for (int body = 1; body < system_->body_count(); ++body)
    if (part(body) > part(out)) out = body;
  return out;
}

}  // namespace linkwork
