#include "linkwork/ensemble/lane_stepper.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/model/joint_kind.hpp"

namespace linkwork {

LaneStepper::LaneStepper(const LaneStructure& structure, const InstructionSet& instructions,
                         std::vector<Dynamics*> mechanisms, const ButcherTableau& tableau)
    : structure_(structure),
      kernels_(lane_kernels(instructions)),
      level_(instructions.level),
      width_(kernels_.width),
      mechanisms_(std::move(mechanisms)),
      tableau_(tableau),
      stabilization_(mechanisms_.front()->stabilization()),
      solver_(structure, instructions),
      refinement_(structure, kernels_, mechanisms_),
      user_forces_(mechanisms_) {
  for (const Dynamics* it : mechanisms_) rest_ = rest_ || it->system().has_rest();
  allocate_motion();
  allocate_parameters();
  for (int l = 0; l < width_; ++l) load(l, mechanism(l));
}

void LaneStepper::size(Numbers& numbers, std::ptrdiff_t count) const { numbers.assign(count * width_, 0.0); }

void LaneStepper::allocate_motion() {
  const int n = structure_.bodies, m = structure_.rows;
  size(states_, 18 * (n + 1));
  for (Numbers* D : {&D_, &factorized_D_}) size(*D, structure_.D_size);
  for (Numbers* rows : {&Phi_, &Phi_t_, &Phi_dot_, &gamma_, &u_}) size(*rows, m);
  for (Numbers* multipliers : {&b_, &lambda_, &looked_lambda_}) size(*multipliers, structure_.multipliers());
  for (Numbers* velocities : {&g_, &v_dot_, &looked_v_dot_, &none_}) size(*velocities, velocity_size * n);
  for (Numbers* one : {&power_, &potential_, &largest_, &stage_t_, &velocity_gains_, &position_gains_}) size(*one, 1);
  ones_.assign(width_, 1.0);
  for (Numbers* state : {&y_, &before_, &stage_}) size(*state, structure_.y_size());
  k_.assign(tableau_.b.size(), y_);
  size(weights_, tableau_.b.size());
  state_.resize(structure_.y_size());
  rows_.resize(m);
  rates_.resize(m);
}

void LaneStepper::allocate_parameters() {
  size(gravity_, 3);
  size(mass_, 10l * structure_.bodies);
  for (const LaneStructure::Joints& joints : structure_.joints) {
    const std::ptrdiff_t count = std::ssize(joints.joint);
    size(attachments_.emplace_back(), 24 * count);
    size(parameters_.emplace_back(), 3 * count * std::ssize(joint_kinds()[joints.kind].info.parameters));
  }
}

const Dynamics& LaneStepper::mechanism(int l) const { return *mechanisms_[std::min(l, count() - 1)]; }

void LaneStepper::take(const Numbers& numbers, int l, std::ptrdiff_t first, MutableVector out) const {
  const double* from = numbers.data() + first * width_ + l;
  for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = from[k * width_];
}

void LaneStepper::give(const double* from, std::ptrdiff_t count, int l, Numbers& to, std::ptrdiff_t first) const {
  double* place = to.data() + first * width_ + l;
  for (std::ptrdiff_t k = 0; k < count; ++k) place[k * width_] = from[k];
}

template <class Action>
void LaneStepper::each_lane(const LaneGuard& guard, Action action) {
  for (int l = 0; l < count(); ++l)
    if (guard.steps(l)) action(l);
}

void LaneStepper::replace(int l, Dynamics& mechanism) {
  mechanisms_[l] = &mechanism;
  rest_ = rest_ || mechanism.system().has_rest();
  refinement_.replace(l, mechanism);
  user_forces_.replace(l, mechanism);
  load(l, mechanism);
}

void LaneStepper::load(int l, const Dynamics& mechanism) {
  load_masses(l, mechanism);
  load_joints(l, mechanism.system().model());
  set_state(l, mechanism.initial_y());
}

void LaneStepper::load_masses(int l, const Dynamics& mechanism) {
  const System& system = mechanism.system();
  give(system.model().gravity().data(), 3, l, gravity_, 0);
  for (int body = 0; body < structure_.bodies; ++body) give(&system.mass_blocks()[body].m, 10, l, mass_, 10l * body);
  solver_.load(l, mechanism);
}

void LaneStepper::load_joints(int l, const Model& model) {
  for (std::size_t kind = 0; kind < structure_.joints.size(); ++kind) {
    const LaneStructure::Joints& joints = structure_.joints[kind];
    const std::ptrdiff_t parameters = std::ssize(joint_kinds()[joints.kind].info.parameters);
    for (std::ptrdiff_t k = 0; k < std::ssize(joints.joint); ++k) {
      const Element& joint = model.joints()[joints.joint[k]];
      give(joint.at.s_i.data(), 3, l, attachments_[kind], 24 * k);
      give(joint.at.s_j.data(), 3, l, attachments_[kind], 24 * k + 3);
      give(joint.at.C_i.data(), 9, l, attachments_[kind], 24 * k + 6);
      give(joint.at.C_j.data(), 9, l, attachments_[kind], 24 * k + 15);
      const auto first = static_cast<std::ptrdiff_t>(joint.first_parameter);
      for (std::ptrdiff_t p = 0; p < parameters; ++p) {
        const double constant[3] = {model.joint_parameters()[first + p].constant, 0.0, 0.0};
        give(constant, 3, l, parameters_[kind], 3 * (parameters * k + p));
      }
    }
  }
}

void LaneStepper::violations(int l, VectorXd& Phi, VectorXd& Phi_dot) const {
  take(Phi_, l, 0, Phi);
  take(Phi_dot_, l, 0, Phi_dot);
}

const double* LaneStepper::largest_number() {
  kernels_.largest(structure_.y_size(), y_.data(), largest_.data());
  return largest_.data();
}

const double* LaneStepper::largest_velocity() {
  const std::ptrdiff_t q_size = position_size * structure_.bodies;
  kernels_.largest(velocity_size * structure_.bodies, y_.data() + q_size * width_, largest_.data());
  return largest_.data();
}

void LaneStepper::normalize() { kernels_.normalize(structure_.bodies, y_.data()); }

void LaneStepper::evaluate_rates(const LaneSpans& spans, LaneGuard& guard) {
  evaluate(spans, guard);
  solve(spans.t, false, guard);
  find_rates(y_, k_.front(), guard);
}

VectorXd LaneStepper::accelerations(int l) const {
  VectorXd out(velocity_size * structure_.bodies);
  take(v_dot_, l, 0, out);
  return out;
}

// --- one step ---

void LaneStepper::hold(const LaneSpans& spans, const double* share) {
  if (!sampled() && !continuous()) return;
  const Options& options = mechanism(0).options();
  const double lag = tableau_.b.dot(tableau_.c);
  for (int l = 0; l < width_; ++l) {
    Gains gains = textbook_gains;
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
  kernels_.weigh(structure_.rows, velocity_gains_.data(), Phi_dot_.data(), position_gains_.data(), Phi_.data(),
                 u_.data());
}

/// y + h sum weights k.
void LaneStepper::combine(const LaneSpans& spans, const ConstVector& weights, Eigen::Index count, Numbers& out) {
  terms_.clear();
  for (Eigen::Index j = 0; j < count; ++j) {
    if (weights[j] == 0.0) continue;
    double* factors = weights_.data() + std::ssize(terms_) * width_;
    for (int l = 0; l < width_; ++l) factors[l] = spans.h[l] * weights[j];
    terms_.push_back(k_[j].data());
  }
  kernels_.combine(structure_.y_size(), y_.data(), static_cast<int>(terms_.size()), weights_.data(), terms_.data(),
                   out.data());
}

void LaneStepper::step(const LaneSpans& spans, LaneGuard& guard) {
  if (continuous()) correct();
  solve(spans.t, true, guard);
  find_rates(y_, k_[0], guard);
  later_stages(spans, guard);
  combine(spans, tableau_.b, tableau_.b.size(), before_);
  std::swap(y_, before_);
}

void LaneStepper::begin_stages(int l, const VectorXd& y, const ConstVector& rates, const VectorXd& held) {
  set_state(l, y);
  give(rates.data(), rates.size(), l, k_[0], 0);
  if (sampled()) give(held.data(), held.size(), l, u_, 0);
}

void LaneStepper::later_stages(const LaneSpans& spans, LaneGuard& guard) {
  for (Eigen::Index i = 1; i < tableau_.b.size(); ++i) {
    for (int l = 0; l < width_; ++l)
      stage_t_[l] = std::clamp(spans.t[l] + tableau_.c[i] * spans.h[l], spans.earliest[l], spans.latest[l]);
    combine(spans, tableau_.A.row(i), i, stage_);
    evaluate(stage_t_, stage_, guard);
    if (continuous()) correct();
    solve(stage_t_, false, guard);
    find_rates(stage_, k_[i], guard);
  }
}

void LaneStepper::rates(int l, int stage, MutableVector out) const { take(k_[stage], l, 0, out); }

// --- one evaluation ---

void LaneStepper::evaluate(const Numbers& t, const Numbers& y, LaneGuard& guard) {
  kernels_.states(structure_.bodies, y.data(), states_.data());
  kernels_.body_forces(structure_.bodies, mass_.data(), gravity_.data(), y.data(), g_.data(), potential_.data());
  if (rest_) evaluate_rest(t, y, guard);
  evaluate_joints();
  leave_out_rows();
}

void LaneStepper::evaluate_constraints(const Numbers& t, LaneGuard& guard) {
  kernels_.states(structure_.bodies, y_.data(), states_.data());
  if (rest_)
    each_lane(guard, [&](int l) {
      evaluate_apart(l, t[l], y_, guard, [&](const System& system, auto q, auto v, const VectorXd& history, auto& at) {
        system.evaluate_rest_of_constraints(t[l], q, v, history, at);
      });
    });
  evaluate_joints();
  leave_out_rows();
}

template <class Evaluate>
void LaneStepper::evaluate_apart(int l, double t, const Numbers& y, LaneGuard& guard, Evaluate evaluate) {
  Dynamics& dynamics = *mechanisms_[l];
  const System& system = dynamics.system();
  const int nq = system.q_size(), nv = system.v_size();
  take(y, l, 0, state_);
  Evaluation& at = dynamics.begin_elsewhere(t, state_);
  bool there = true;
  do_apart([&] { evaluate(system, state_.head(nq), state_.segment(nq, nv), dynamics.history(), at); },
           [&](std::string why) {
             guard.leave(l, t, std::move(why));
             there = false;
           });
  if (!there) return;
  give_parameters(l, at);
  give_special_joints(l, at);
  give(at.D.data() + structure_.inerter_D, structure_.inerter_D_size, l, D_, structure_.inerter_D);
}

/// Functions of time, special joints, inerters, forces.
void LaneStepper::evaluate_rest(const Numbers& t, const Numbers& y, LaneGuard& guard) {
  each_lane(guard, [&](int l) { evaluate_rest(l, t[l], y, guard); });
  if (!user_forces_.none()) user_forces_.add(guard);
  each_lane(guard, [&](int l) {
    const Evaluation& found = mechanisms_[l]->evaluation();
    give(found.g.data(), mechanisms_[l]->system().v_size(), l, g_, 0);
    *lane(power_, 0, l) = found.power;
    *lane(potential_, 0, l) = found.potential;
  });
}

void LaneStepper::evaluate_rest(int l, double t, const Numbers& y, LaneGuard& guard) {
  evaluate_apart(l, t, y, guard, [&](const System& system, auto q, auto v, const VectorXd& history, Evaluation& at) {
    const double* g = g_.data() + l;
    for (int k = 0; k < system.v_size(); ++k) at.g[k] = g[static_cast<std::ptrdiff_t>(k) * width_];
    at.potential = *lane(potential_, 0, l);
    system.evaluate_rest(t, q, v, history, at);
    if (!user_forces_.none()) user_forces_.place(l) = {.t = t, .y = state_, .at = &at};
  });
}

/// Functions of time among the parameters of joints.
void LaneStepper::give_parameters(int l, const Evaluation& at) {
  const Model& model = mechanisms_[l]->system().model();
  for (std::size_t kind = 0; kind < structure_.joints.size(); ++kind) {
    const LaneStructure::Joints& joints = structure_.joints[kind];
    const auto count = static_cast<std::ptrdiff_t>(joint_kinds()[joints.kind].info.parameters.size());
    if (count == 0) continue;
    std::ptrdiff_t place = 0;
    for (const int joint : joints.joint) {
      const auto first = static_cast<std::ptrdiff_t>(model.joints()[joint].first_parameter);
      for (std::ptrdiff_t p = 0; p < count; ++p, place += 3) {
        const Parameter& parameter = model.joint_parameters()[first + p];
        if (parameter.signal < 0) continue;
        const Signal<double>& signal = at.signals[parameter.signal];
        const double numbers[3] = {signal.value, signal.rate, signal.acceleration};
        give(numbers, 3, l, parameters_[kind], place);
      }
    }
  }
}

void LaneStepper::give_special_joints(int l, const Evaluation& at) {
  const System& system = mechanisms_[l]->system();
  for (const int joint : structure_.special) {
    const int row = system.model().joint_rows()[joint], rows = system.model().joint_rows()[joint + 1] - row;
    give(at.Phi.data() + row, rows, l, Phi_, row);
    give(at.Phi_t.data() + row, rows, l, Phi_t_, row);
    give(at.Phi_dot.data() + row, rows, l, Phi_dot_, row);
    give(at.gamma.data() + row, rows, l, gamma_, row);
    for (const int index : system.joint_blocks(joint)) {
      const ConstraintBlock& block = system.blocks()[index];
      give(at.D.data() + block.offset, std::ptrdiff_t{velocity_size} * rows, l, D_, block.offset);
    }
  }
}

void LaneStepper::evaluate_joints() {
  const ConstraintArrays out{Phi_.data(), Phi_t_.data(), Phi_dot_.data(), gamma_.data(), D_.data()};
  for (std::size_t kind = 0; kind < structure_.joints.size(); ++kind) {
    const LaneStructure::Joints& joints = structure_.joints[kind];
    const JointKind& it = joint_kinds()[joints.kind];
    it.evaluate_lanes[level_](
        {static_cast<int>(joints.joint.size()), joints.body_i.data(), joints.body_j.data(), attachments_[kind].data(),
         parameters_[kind].data(), static_cast<int>(it.info.parameters.size()), joints.row.data(), joints.D.data(),
         states_.data()},
        out);
  }
}

void LaneStepper::leave_out_rows() {
  for (const std::ptrdiff_t D : structure_.dropped_D)
    std::fill_n(D_.begin() + D * width_, std::ptrdiff_t{velocity_size} * width_, 0.0);
}

void LaneStepper::solve(const Numbers& t, bool first, LaneGuard& guard) {
  if (!sampled() && !continuous()) std::copy(gamma_.begin(), gamma_.end(), b_.begin());
  else {
    const double* const u = u_.data();
    kernels_.combine(structure_.rows, gamma_.data(), 1, ones_.data(), &u, b_.data());
  }
  factorize_and_solve(g_, t, first, guard);
}

void LaneStepper::leave_out_b() {
  for (const int row : structure_.dropped) std::fill_n(b_.begin() + std::ptrdiff_t{row} * width_, width_, 0.0);
}

/// M x - D^T lambda = a, D x = b.
void LaneStepper::factorize_and_solve(const Numbers& a, const Numbers& t, bool first, LaneGuard& guard) {
  leave_out_b();
  solver_.factorize_and_solve(problem(D_, a));
  bool looked = false;
  each_lane(guard, [&](int l) {
    guard.note(l, t[l], solver_.smallest_pivot(l), first);
    looked = looked || (first && guard.looked(l));
  });
  if (looked) solve_as_looked(guard);
  if (refinement_.needed()) refinement_.refine(t.data(), mass_.data(), problem(D_, a), solver_, guard);
}

/// Lanes that were looked at ahead have factors already there, where a single run substitutes in another order.
void LaneStepper::solve_as_looked(const LaneGuard& guard) {
  solver_.solve({D_.data(), g_.data(), b_.data(), looked_v_dot_.data(), looked_lambda_.data()});
  each_lane(guard, [&](int l) {
    if (!guard.looked(l)) return;
    for (std::size_t k = l; k < v_dot_.size(); k += width_) v_dot_[k] = looked_v_dot_[k];
    for (std::size_t k = l; k < lambda_.size(); k += width_) lambda_[k] = looked_lambda_[k];
  });
}

void LaneStepper::factorize_and_correct(Violation of, const Numbers& t, LaneGuard& guard) {
  take_violation(of);
  factorize_and_solve(none_, t, false, guard);
  std::swap(D_, factorized_D_);
}

void LaneStepper::correct(Violation of, const Numbers& t, LaneGuard& guard) {
  take_violation(of);
  leave_out_b();
  solver_.solve(problem(factorized_D_, none_));
  if (refinement_.needed()) refinement_.refine(t.data(), mass_.data(), problem(factorized_D_, none_), solver_, guard);
}

void LaneStepper::take_violation(Violation of) {
  const Numbers& from = of == Violation::positions ? Phi_ : Phi_dot_;
  for (std::size_t k = 0; k < from.size(); ++k) b_[k] = -from[k];
}

/// With the power of forces and drivers last.
void LaneStepper::find_rates(const Numbers& y, Numbers& y_dot, const LaneGuard& guard) {
  kernels_.rates(structure_.bodies, y.data(), v_dot_.data(), y_dot.data());
  if (!rest_) return;
  each_lane(guard, [&](int l) {
    double power = power_[l];
    if (structure_.time_dependent) {
      take(lambda_, l, 0, rows_);
      take(Phi_t_, l, 0, rates_);
      power -= rows_.dot(rates_);
    }
    *lane(y_dot, structure_.y_size() - 1, l) = power;
  });
}

}  // namespace linkwork
