#include "linkwork/ensemble/lane_stepper.hpp"

#include <algorithm>
#include <utility>

namespace linkwork {

LaneStepper::LaneStepper(const LaneStructure& structure, const InstructionSet& instructions,
                         std::vector<Dynamics*> mechanisms, const ButcherTableau& tableau)
    : structure_(structure),
      kernels_(lane_kernels(instructions)),
      layout_{kernels_.width},
      mechanisms_(std::move(mechanisms)),
      tableau_(tableau),
      stabilization_(mechanisms_.front()->stabilization()),
      evaluation_(structure, instructions, mechanisms_),
      solver_(structure, instructions),
      refinement_(structure, kernels_, mechanisms_) {
  allocate();
  for (int l = 0; l < width(); ++l) {
    solver_.load(l, mechanism(l));
    set_state(l, mechanism(l).initial_y());
  }
}

void LaneStepper::allocate() {
  const int n = structure_.bodies, m = structure_.rows;
  evaluation_.size_D(factorized_D_);
  layout_.size(u_, m);
  for (Numbers* multipliers : {&b_, &lambda_, &looked_lambda_, &ahead_b_})
    layout_.size(*multipliers, structure_.multipliers());
  for (Numbers* velocities : {&v_dot_, &looked_v_dot_, &none_}) layout_.size(*velocities, velocity_size * n);
  for (Numbers* one : {&largest_, &stage_t_, &velocity_gains_, &position_gains_}) layout_.size(*one, 1);
  ones_.assign(width(), 1.0);
  for (Numbers* state : {&y_, &before_, &stage_}) layout_.size(*state, structure_.y_size());
  k_.assign(tableau_.b.size(), y_);
  layout_.size(weights_, tableau_.b.size());
  for (Eigen::Index i = 0; i < tableau_.A.rows(); ++i) stage_weights_.emplace_back(tableau_.A.row(i));
}

const Dynamics& LaneStepper::mechanism(int l) const { return *mechanisms_[std::min(l, count() - 1)]; }

template <class Action>
void LaneStepper::each_lane(const LaneGuard& guard, Action action) {
  for (int l = 0; l < count(); ++l)
    if (guard.steps(l)) action(l);
}

void LaneStepper::replace(int l, Dynamics& mechanism) {
  mechanisms_[l] = &mechanism;
  evaluation_.replace(l, mechanism);
  solver_.load(l, mechanism);
  refinement_.replace(l, mechanism);
  set_state(l, mechanism.initial_y());
}

void LaneStepper::violations(int l, VectorXd& Phi, VectorXd& Phi_dot) const {
  layout_.take(evaluation_.at().Phi, l, 0, Phi);
  layout_.take(evaluation_.at().Phi_dot, l, 0, Phi_dot);
}

const double* LaneStepper::largest_number() {
  kernels_.largest(structure_.y_size(), y_.data(), largest_.data());
  return largest_.data();
}

const double* LaneStepper::largest_velocity() {
  const std::ptrdiff_t q_size = position_size * structure_.bodies;
  kernels_.largest(velocity_size * structure_.bodies, y_.data() + q_size * width(), largest_.data());
  return largest_.data();
}

void LaneStepper::normalize() { kernels_.normalize(structure_.bodies, y_.data()); }

void LaneStepper::evaluate_rates(const LaneSpans& spans, LaneGuard& guard) {
  evaluate(spans, guard);
  solve(spans.begin, guard);
  find_rates(y_, k_.front(), guard);
}

VectorXd LaneStepper::accelerations(int l) const {
  VectorXd out(velocity_size * structure_.bodies);
  layout_.take(v_dot_, l, 0, out);
  return out;
}

// --- one step ---

void LaneStepper::hold(const LaneSpans& spans, const double* share) {
  if (!sampled() && !continuous()) return;
  const Options& options = mechanism(0).options();
  const double lag = tableau_.b.dot(tableau_.c);
  for (int l = 0; l < width(); ++l) {
    if (l > 0 && spans.h[l] == spans.h[l - 1] && share[l] == share[l - 1]) {  // as in most lanes
      velocity_gains_[l] = velocity_gains_[l - 1];
      position_gains_[l] = position_gains_[l - 1];
      continue;
    }
    Gains gains{};
    if (sampled()) gains = deadbeat_gains(lag, spans.h[l]);
    if (sampled() && share[l] < 1.0) gains = {gains.alpha * share[l], gains.beta * share[l]};
    const double alpha = options.baumgarte_alpha.value_or(gains.alpha);
    const double beta = options.baumgarte_beta.value_or(gains.beta);
    velocity_gains_[l] = -2.0 * alpha;
    position_gains_[l] = -(beta * beta);
  }
  if (sampled()) correct();
}

void LaneStepper::correct() {
  const LaneValues& at = evaluation_.at();
  kernels_.weigh(structure_.rows, velocity_gains_.data(), at.Phi_dot.data(), position_gains_.data(), at.Phi.data(),
                 u_.data());
}

/// y + h sum weights k.
void LaneStepper::combine(const LaneSpans& spans, const ConstVector& weights, Eigen::Index count, Numbers& out) {
  terms_.clear();
  for (Eigen::Index j = 0; j < count; ++j) {
    if (weights[j] == 0.0) continue;
    double* factors = weights_.data() + std::ssize(terms_) * width();
    for (int l = 0; l < width(); ++l) factors[l] = spans.h[l] * weights[j];
    terms_.push_back(k_[j].data());
  }
  kernels_.combine(structure_.y_size(), y_.data(), static_cast<int>(terms_.size()), weights_.data(), terms_.data(),
                   out.data());
}

void LaneStepper::step(const LaneSpans& spans, LaneGuard& guard) {
  factorize_ahead();
  conclude(evaluation_.at().g, spans.begin, true, guard);
  ahead_ = false;
  find_rates(y_, k_[0], guard);
  later_stages(spans, guard);
  combine(spans, tableau_.b, tableau_.b.size(), before_);
  std::swap(y_, before_);
}

void LaneStepper::begin_stages(int l, const VectorXd& y, const ConstVector& rates, const VectorXd& held) {
  set_state(l, y);
  layout_.give(rates.data(), rates.size(), l, k_[0], 0);
  if (sampled()) layout_.give(held.data(), held.size(), l, u_, 0);
}

void LaneStepper::later_stages(const LaneSpans& spans, LaneGuard& guard) {
  for (Eigen::Index i = 1; i < tableau_.b.size(); ++i) {
    for (int l = 0; l < width(); ++l)
      stage_t_[l] = std::clamp(spans.t[l] + tableau_.c[i] * spans.h[l], spans.earliest[l], spans.latest[l]);
    combine(spans, stage_weights_[static_cast<std::size_t>(i)], i, stage_);
    evaluation_.evaluate(stage_t_, stage_, guard);
    solve(stage_t_, guard);
    find_rates(stage_, k_[i], guard);
  }
}

void LaneStepper::rates(int l, int stage, MutableVector out) const { layout_.take(k_[stage], l, 0, out); }

// --- one solution ---

void LaneStepper::solve(const Numbers& t, LaneGuard& guard) {
  find_b();
  factorize_and_solve(evaluation_.at().g, t, guard);
}

/// With the correction of violations.
void LaneStepper::find_b() {
  if (continuous()) correct();
  const Numbers& gamma = evaluation_.at().gamma;
  if (!sampled() && !continuous()) std::copy(gamma.begin(), gamma.end(), b_.begin());
  else {
    const double* const u = u_.data();
    kernels_.combine(structure_.rows, gamma.data(), 1, ones_.data(), &u, b_.data());
  }
}

void LaneStepper::factorize_ahead() {
  if (std::exchange(ahead_, true)) return;
  find_b();
  eliminate(evaluation_.at().g);
}

double LaneStepper::smallest_pivot_ahead(int l) {
  factorize_ahead();
  return solver_.smallest_pivots()[l];
}

void LaneStepper::solve_ahead(int l, const ConstVector& b, MutableVector x, MutableVector lambda) {
  factorize_ahead();
  layout_.give(b.data(), b.size(), l, ahead_b_, 0);
  solver_.solve(
      {evaluation_.at().D.data(), none_.data(), ahead_b_.data(), looked_v_dot_.data(), looked_lambda_.data()});
  for (Eigen::Index row = 0; row < b.size(); ++row) ahead_b_[layout_.index(row, l)] = 0.0;
  layout_.take(looked_v_dot_, l, 0, x);
  layout_.take(looked_lambda_, l, 0, lambda);
}

void LaneStepper::leave_out_b() {
  for (const int row : structure_.dropped) layout_.clear(b_, row, 1);
}

/// M x - D^T lambda = a, D x = b.
void LaneStepper::factorize_and_solve(const Numbers& a, const Numbers& t, LaneGuard& guard) {
  eliminate(a);
  conclude(a, t, false, guard);
}

void LaneStepper::eliminate(const Numbers& a) {
  leave_out_b();
  solver_.factorize_and_solve(problem(evaluation_.at().D, a));
}

/// What there is to do beside the elimination.
void LaneStepper::conclude(const Numbers& a, const Numbers& t, bool first, LaneGuard& guard) {
  if (solver_.factorizes()) guard.note_all(count(), t.data(), solver_.smallest_pivots().data(), first);
  bool looked = false;
  if (first) each_lane(guard, [&](int l) { looked = looked || guard.looked(l); });
  if (looked) solve_as_looked(guard);
  refine(problem(evaluation_.at().D, a), t, guard);
}

void LaneStepper::refine(const LaneSolver::Problem& problem, const Numbers& t, LaneGuard& guard) {
  if (!refinement_.needed()) return;
  refinement_.refine({t.data(), evaluation_.mass().data(), evaluation_.inertance().data()}, problem, solver_, guard);
}

/// Lanes that were looked at ahead have factors already there, where a single run substitutes in another order.
void LaneStepper::solve_as_looked(const LaneGuard& guard) {
  const LaneValues& at = evaluation_.at();
  solver_.solve({at.D.data(), at.g.data(), b_.data(), looked_v_dot_.data(), looked_lambda_.data()});
  each_lane(guard, [&](int l) {
    if (!guard.looked(l)) return;
    for (std::size_t k = l; k < v_dot_.size(); k += width()) v_dot_[k] = looked_v_dot_[k];
    for (std::size_t k = l; k < lambda_.size(); k += width()) lambda_[k] = looked_lambda_[k];
  });
}

void LaneStepper::factorize_and_correct(Violation of, const Numbers& t, LaneGuard& guard) {
  take_violation(of);
  factorize_and_solve(none_, t, guard);
  evaluation_.exchange_D(factorized_D_);
}

void LaneStepper::correct(Violation of, const Numbers& t, LaneGuard& guard) {
  take_violation(of);
  leave_out_b();
  solver_.solve(problem(factorized_D_, none_));
  refine(problem(factorized_D_, none_), t, guard);
}

void LaneStepper::take_violation(Violation of) {
  const LaneValues& at = evaluation_.at();
  const Numbers& from = of == Violation::positions ? at.Phi : at.Phi_dot;
  for (std::size_t k = 0; k < from.size(); ++k) b_[k] = -from[k];
}

/// With the power of forces and drivers last.
void LaneStepper::find_rates(const Numbers& y, Numbers& y_dot, const LaneGuard& guard) {
  kernels_.rates(structure_.bodies, y.data(), v_dot_.data(), y_dot.data());
  if (!evaluation_.has_power()) return;
  const LaneValues& at = evaluation_.at();
  each_lane(guard, [&](int l) {
    double drivers = 0.0;
    for (const int row : mechanism(l).system().driven_rows())
      drivers += lambda_[layout_.index(row, l)] * at.Phi_t[layout_.index(row, l)];
    *layout_.place(y_dot, structure_.y_size() - 1, l) = at.power[l] - drivers;
  });
}

}  // namespace linkwork
