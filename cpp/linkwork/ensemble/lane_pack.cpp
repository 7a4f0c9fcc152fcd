#include "linkwork/ensemble/lane_pack.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "linkwork/linear/block/block_solver.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr double restless = 1.0;  // way or angle of a step in which a lane is looked at more closely

}  // namespace

LanePack::LanePack(const LaneStructure& structure, const InstructionSet& instructions, std::vector<Lane*> lanes,
                   const ButcherTableau& tableau, const FixedSteps& steps)
    : structure_(structure),
      kernels_(lane_kernels(instructions)),
      elimination_(lane_elimination(instructions)),
      level_(instructions.level),
      width_(kernels_.width),
      lanes_(std::move(lanes)),
      tableau_(tableau),
      steps_(steps),
      refinement_(structure, kernels_, lanes_) {
  for (const Lane* it : lanes_) {
    watches_ = watches_ || it->watches();
    judged_ = judged_ || it->judged();
  }
  for (Lane* it : lanes_) rest_ = rest_ || it->dynamics().system().has_rest();
  const auto size = [&](Numbers& numbers, std::ptrdiff_t count) { numbers.assign(count * width_, 0.0); };
  const auto& symbolic = structure.symbolic;
  const int n = structure.bodies, m = structure.rows;
  size(states_, 18 * (n + 1));
  size(D_, structure.D_size);
  for (Numbers* rows : {&Phi_, &Phi_t_, &Phi_dot_, &gamma_, &b_, &u_, &lambda_, &looked_lambda_}) size(*rows, m);
  for (Numbers* velocities : {&g_, &v_dot_, &looked_v_dot_}) size(*velocities, velocity_size * n);
  for (Numbers* one : {&smallest_, &power_, &potential_, &largest_}) size(*one, 1);
  size(factors_, symbolic.factor_size);
  size(articulated_inertias_, block::articulated_inertia_size * symbolic.articulated_inertia_count);
  size(panels_, symbolic.panel_size);
  size(contributions_, symbolic.contribution_size);
  int most_rows = 0;
  for (const block::CoreBody& body : symbolic.bodies) most_rows = std::max(most_rows, body.rows);
  size(scratch_, std::max(12 * most_rows, 8 * symbolic.highest_front + symbolic.widest_front));
  for (Numbers* state : {&y_, &before_, &stage_}) size(*state, structure.y_size());
  k_.assign(tableau.b.size(), y_);
  load_numbers();
}

void LanePack::take(const Numbers& numbers, int l, std::ptrdiff_t first, VectorXd& out) const {
  const double* from = numbers.data() + first * width_ + l;
  for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = from[k * width_];
}

void LanePack::give(const double* from, std::ptrdiff_t count, int l, Numbers& to, std::ptrdiff_t first) const {
  double* place = to.data() + first * width_ + l;
  for (std::ptrdiff_t k = 0; k < count; ++k) place[k * width_] = from[k];
}

template <class Action>
void LanePack::each_lane(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->alive()) action(l, *lanes_[l]);
}

/// But for those that leap, or wait.
template <class Action>
void LanePack::each_stepping(Action action) {
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (lanes_[l]->stepping()) action(l, *lanes_[l]);
}

bool LanePack::any_lane() const {
  return std::any_of(lanes_.begin(), lanes_.end(), [](const Lane* lane) { return lane->alive(); });
}

/// Lanes that are not used hold the numbers of the last one.
void LanePack::load_numbers() {
  state_.resize(structure_.y_size());
  new_state_.resize(structure_.y_size());
  rows_.resize(structure_.rows);
  rates_.resize(structure_.rows);
  load_masses();
  load_joints();
  for (int l = 0; l < width_; ++l) {
    const VectorXd y = lanes_[std::min<std::size_t>(l, lanes_.size() - 1)]->dynamics().initial_y();
    give(y.data(), y.size(), l, y_, 0);
  }
}

void LanePack::load_masses() {
  gravity_.assign(3 * width_, 0.0);
  for (Numbers* all : {&mass_, &nearby_mass_}) all->assign(std::ptrdiff_t{10} * structure_.bodies * width_, 0.0);
  mass_factors_.assign(std::ptrdiff_t{9} * structure_.symbolic.mass_factor_count * width_, 0.0);
  for (int l = 0; l < width_; ++l) {
    const Dynamics& dynamics = lanes_[std::min<std::size_t>(l, lanes_.size() - 1)]->dynamics();
    const System &system = dynamics.system(), &nearby = dynamics.formulation().inertia().system();
    give(system.model().gravity().data(), 3, l, gravity_, 0);
    for (int body = 0; body < structure_.bodies; ++body) {
      give(&system.mass_blocks()[body].m, 10, l, mass_, 10l * body);
      give(&nearby.mass_blocks()[body].m, 10, l, nearby_mass_, 10l * body);
    }
    for (const block::CoreBody& body : structure_.symbolic.bodies) {
      if (body.mass_factor < 0) continue;
      const block::MassFactor factor = block::mass_factor(nearby, body.body);
      give(&factor.L43, 9, l, mass_factors_, 9l * body.mass_factor);
    }
  }
}

void LanePack::load_joints() {
  for (const LaneStructure::Joints& joints : structure_.joints) {
    const auto count = static_cast<std::ptrdiff_t>(joints.joint.size());
    const auto parameters = static_cast<std::ptrdiff_t>(joint_kinds()[joints.kind].info.parameters.size());
    attachments_.emplace_back(24 * count * width_, 0.0);
    parameters_.emplace_back(3 * parameters * count * width_, 0.0);
    for (int l = 0; l < width_; ++l) {
      const Model& model = lanes_[std::min<std::size_t>(l, lanes_.size() - 1)]->dynamics().system().model();
      for (std::ptrdiff_t k = 0; k < count; ++k) {
        const Attachment<double>& at = model.joints()[joints.joint[k]].at;
        give(at.s_i.data(), 3, l, attachments_.back(), 24 * k);
        give(at.s_j.data(), 3, l, attachments_.back(), 24 * k + 3);
        give(at.C_i.data(), 9, l, attachments_.back(), 24 * k + 6);
        give(at.C_j.data(), 9, l, attachments_.back(), 24 * k + 15);
        const auto first = static_cast<std::ptrdiff_t>(model.joints()[joints.joint[k]].first_parameter);
        for (std::ptrdiff_t p = 0; p < parameters; ++p)
          *lane(parameters_.back(), 3 * (parameters * k + p), l) = model.joint_parameters()[first + p].constant;
      }
    }
  }
}

LaneData LanePack::data() {
  const block::SymbolicFactorization& s = structure_.symbolic;
  return {.steps = s.steps.data(),
          .step_count = std::ssize(s.steps),
          .fronts = s.fronts.data(),
          .front_count = std::ssize(s.fronts),
          .relative_indices = s.relative_indices.data(),
          .bodies = s.bodies.data(),
          .rows = s.rows.data(),
          .row_positions = structure_.row_positions.data(),
          .unknowns = s.unknowns.data(),
          .compliance = structure_.compliance.data(),
          .mass = nearby_mass_.data(),
          .mass_factors = mass_factors_.data(),
          .D = D_.data(),
          .factors = factors_.data(),
          .articulated_inertias = articulated_inertias_.data(),
          .panels = panels_.data(),
          .contributions = contributions_.data(),
          .scratch = scratch_.data()};
}

void LanePack::run(const std::function<void()>& look) {
  for (std::int64_t step = first_step(); any_lane(); ++step) {
    begin_step(step);
    if (step == steps_.count()) break;
    take_step(step);
    finish_step(step);
    look();
  }
}

std::int64_t LanePack::first_step() const {
  const auto starts = [](const Lane* lane) { return std::max<std::int64_t>(lane->joins_at(), 0); };
  std::int64_t first = starts(lanes_.front());
  for (const Lane* lane : lanes_) first = std::min(first, starts(lane));
  return first;
}

void LanePack::evaluate_start(int times) {
  for (int k = 0; k < times; ++k) {
    evaluate(0.0, y_);
    solve(0.0, false);
    find_rates(y_, k_.front());
  }
}

VectorXd LanePack::accelerations(int l) {
  VectorXd out(velocity_size * structure_.bodies);
  take(v_dot_, l, 0, out);
  return out;
}

// --- one step ---

void LanePack::begin_step(std::int64_t step) {
  const double t = steps_.time(step);
  each_lane([&](int l, Lane&) { continue_lane(l, step); });
  evaluate(t, y_);
  const bool records = steps_.records(step),
             needs_state = records || watches_ || judged_ || !structure_.dropped.empty();
  each_lane([&](int l, Lane& lane) {
    if (lane.waits() || lane.joins_at() == step) return;
    lane.accept(t, step > 0 ? steps_.size(step - 1) : 0.0);
    if (needs_state && lane.alive()) begin_lane(l, step);
  });
}

/// Those that join, or leap, have a state that is not the pack's.
void LanePack::continue_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  if (lane.waits()) {
    if (lane.joins_at() != step) return;
    lane.join();
    state_ = lane.joining_state();
  } else {
    lane.expect_nothing();
    if (!lane.leaping()) return;
    lane.follow_leap(steps_.frame_time(step), steps_.step(), state_);
  }
  give(state_.data(), state_.size(), l, y_, 0);
}

void LanePack::begin_lane(int l, std::int64_t step) {
  Lane& lane = *lanes_[l];
  const double t = steps_.time(step);
  const bool last = step == steps_.count();
  take(y_, l, 0, state_);
  if (!structure_.dropped.empty() && !lane.leaping()) {
    Evaluation& at = lane.begin(t, state_);
    take(Phi_, l, 0, at.Phi);
    take(Phi_dot_, l, 0, at.Phi_dot);
    lane.watch_redundant_rows(t, state_);
  }
  if (lane.alive() && steps_.records(step)) lane.record(t, steps_.frame_time(step), state_, last);
  if (!lane.stepping()) return;
  const double potential = *this->lane(potential_, 0, l);
  if (last) {
    lane.sample(steps_.t_end(), state_, potential);
    if (lane.watches()) lane.end(steps_.t_end(), state_);
    return;
  }
  if (lane.watches()) lane.look_ahead(step, steps_, state_);
  lane.finish_record(t);
  if (lane.stepping() || (lane.moves() && !lane.leaping())) lane.sample(t, state_, potential);
  if (lane.moves()) lane.move(step, state_);
}

void LanePack::take_step(std::int64_t step) {
  const double t = steps_.time(step), h = steps_.size(step);
  Lane& any = *lanes_.front();
  const Options& options = any.dynamics().options();
  const StabilizationKind kind = any.dynamics().stabilization();
  Gains gains = textbook_gains;
  if (kind == StabilizationKind::sampled_baumgarte) gains = deadbeat_gains(tableau_.b.dot(tableau_.c), h);
  gains_ = {options.baumgarte_alpha.value_or(gains.alpha), options.baumgarte_beta.value_or(gains.beta)};
  const auto correct = [&] {
    kernels_.weigh(structure_.rows, -2.0 * gains_.alpha, Phi_dot_.data(), -(gains_.beta * gains_.beta), Phi_.data(),
                   u_.data());
  };
  if (kind == StabilizationKind::sampled_baumgarte) correct();
  std::vector<double> factors;
  std::vector<const double*> terms;
  const auto combine = [&](const auto& weights, Eigen::Index count, Numbers& out) {
    factors.clear();
    terms.clear();
    for (Eigen::Index j = 0; j < count; ++j)
      if (weights[j] != 0.0) {
        factors.push_back(h * weights[j]);
        terms.push_back(k_[j].data());
      }
    kernels_.combine(structure_.y_size(), y_.data(), static_cast<int>(terms.size()), factors.data(), terms.data(),
                     out.data());
  };
  for (Eigen::Index i = 0; i < tableau_.b.size(); ++i) {
    const double stage_t = i == 0 ? t : t + tableau_.c[i] * h;
    if (i > 0) {
      combine(tableau_.A.row(i), i, stage_);
      evaluate(stage_t, stage_);
    }
    if (kind == StabilizationKind::baumgarte) correct();
    solve(stage_t, i == 0);
    find_rates(i == 0 ? y_ : stage_, k_[i]);
  }
  combine(tableau_.b, tableau_.b.size(), before_);
  std::swap(y_, before_);
}

void LanePack::finish_step(std::int64_t step) {
  check_size(step);
  kernels_.normalize(structure_.bodies, y_.data());
  if (!watches_ && !judged_) return;
  const double t = steps_.time(step), h = steps_.size(step);
  each_stepping([&](int l, Lane& lane) {
    take(before_, l, 0, state_);
    if (lane.judged()) {
      take(y_, l, 0, new_state_);
      lane.sample_step(t, h, state_, new_state_);
    }
    if (lane.watches()) lane.look_back(t, h, state_);
  });
}

/// Lanes that diverge, or whose numbers are none, leave, and stay where they are no burden.
void LanePack::check_size(std::int64_t step) {
  const double t = steps_.time(step + 1), h = steps_.size(step);
  const int q_size = position_size * structure_.bodies;
  kernels_.largest(structure_.y_size(), y_.data(), largest_.data());
  each_stepping([&](int l, Lane& lane) {
    if (!std::isfinite(*this->lane(largest_, 0, l))) lane.leave(t, "a number is not finite");
  });
  kernels_.largest(velocity_size * structure_.bodies, y_.data() + q_size * width_, largest_.data());
  each_stepping([&](int l, Lane& lane) {
    if (*this->lane(largest_, 0, l) * h < restless) return;
    take(y_, l, 0, state_);
    lane.check(t, h, state_);
  });
  for (int l = 0; l < static_cast<int>(lanes_.size()); ++l)
    if (!lanes_[l]->alive()) {
      const VectorXd y = lanes_[l]->dynamics().initial_y();
      give(y.data(), y.size(), l, y_, 0);
    }
}

// --- one evaluation ---

void LanePack::evaluate(double t, const Numbers& y) {
  kernels_.states(structure_.bodies, y.data(), states_.data());
  kernels_.body_forces(structure_.bodies, mass_.data(), gravity_.data(), y.data(), g_.data(), potential_.data());
  if (rest_) each_stepping([&](int l, Lane&) { evaluate_rest(l, t, y); });
  evaluate_joints();
  leave_out_rows();
}

/// Functions of time, special joints, forces.
void LanePack::evaluate_rest(int l, double t, const Numbers& y) {
  Dynamics& dynamics = lanes_[l]->dynamics();
  const System& system = dynamics.system();
  take(y, l, 0, state_);
  Evaluation& at = dynamics.begin_elsewhere(t, state_);
  const int nq = system.q_size(), nv = system.v_size();
  const double* g = g_.data() + l;
  for (int k = 0; k < nv; ++k) at.g[k] = g[static_cast<std::ptrdiff_t>(k) * width_];
  at.potential = *lane(potential_, 0, l);
  try {
    system.evaluate_rest(t, state_.head(nq), state_.segment(nq, nv), dynamics.history(), at);
  } catch (const Error& error) {
    return lanes_[l]->leave(t, error.what());
  }
  give(at.g.data(), nv, l, g_, 0);
  *lane(power_, 0, l) = at.power;
  *lane(potential_, 0, l) = at.potential;
  give_parameters(l, at);
  give_special_joints(l, at);
}

/// Functions of time among the parameters of joints.
void LanePack::give_parameters(int l, const Evaluation& at) {
  const Model& model = lanes_[l]->dynamics().system().model();
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

void LanePack::give_special_joints(int l, const Evaluation& at) {
  const System& system = lanes_[l]->dynamics().system();
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

void LanePack::evaluate_joints() {
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

void LanePack::leave_out_rows() {
  for (const std::ptrdiff_t D : structure_.dropped_D)
    std::fill_n(D_.begin() + D * width_, std::ptrdiff_t{velocity_size} * width_, 0.0);
}

void LanePack::solve(double t, bool first) {
  const StabilizationKind kind = lanes_.front()->dynamics().stabilization();
  if (kind == StabilizationKind::none) std::copy(gamma_.begin(), gamma_.end(), b_.begin());
  else {
    const double one = 1.0;
    const double* const u = u_.data();
    kernels_.combine(structure_.rows, gamma_.data(), 1, &one, &u, b_.data());
  }
  for (const int row : structure_.dropped) std::fill_n(b_.begin() + std::ptrdiff_t{row} * width_, width_, 0.0);
  const LaneData at = data();
  elimination_.factor(at, g_.data(), b_.data(), smallest_.data());
  for (const int row : structure_.dropped) std::fill_n(lambda_.begin() + std::ptrdiff_t{row} * width_, width_, 0.0);
  elimination_.backward(at, g_.data(), v_dot_.data(), lambda_.data());
  bool looked = false;
  each_stepping([&](int l, Lane& lane) {
    lane.note(t, *this->lane(smallest_, 0, l), first);
    looked = looked || (first && lane.looked());
  });
  if (looked) solve_as_looked();
  if (refinement_.needed())
    refinement_.refine({t, mass_.data(), D_.data(), g_.data(), b_.data(), v_dot_.data(), lambda_.data()}, elimination_,
                       at);
}

/// Lanes that were looked at ahead have factors already there, where a single run substitutes in another order.
void LanePack::solve_as_looked() {
  const LaneData at = data();
  elimination_.forward(at, g_.data(), b_.data());
  for (const int row : structure_.dropped)
    std::fill_n(looked_lambda_.begin() + std::ptrdiff_t{row} * width_, width_, 0.0);
  elimination_.backward(at, g_.data(), looked_v_dot_.data(), looked_lambda_.data());
  each_stepping([&](int l, Lane& lane) {
    if (!lane.looked()) return;
    for (std::size_t k = l; k < v_dot_.size(); k += width_) v_dot_[k] = looked_v_dot_[k];
    for (std::size_t k = l; k < lambda_.size(); k += width_) lambda_[k] = looked_lambda_[k];
  });
}

/// With the power of forces and drivers last.
void LanePack::find_rates(const Numbers& y, Numbers& y_dot) {
  kernels_.rates(structure_.bodies, y.data(), v_dot_.data(), y_dot.data());
  if (!rest_) return;
  each_stepping([&](int l, Lane&) {
    double power = *lane(power_, 0, l);
    if (structure_.time_dependent) {
      take(lambda_, l, 0, rows_);
      take(Phi_t_, l, 0, rates_);
      power -= rows_.dot(rates_);
    }
    *lane(y_dot, structure_.y_size() - 1, l) = power;
  });
}

}  // namespace linkwork
