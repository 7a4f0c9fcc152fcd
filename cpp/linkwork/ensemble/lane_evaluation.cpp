#include "linkwork/ensemble/lane_evaluation.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/ensemble/row_forms.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

EvaluateForceLanes lanes_of(int kind, int level) { return force_kinds()[kind].lanes[level]; }

}  // namespace

LaneEvaluation::LaneEvaluation(const LaneStructure& structure, const InstructionSet& instructions,
                               const std::vector<Dynamics*>& mechanisms)
    : structure_(structure),
      kernels_(lane_kernels(instructions)),
      layout_{kernels_.width},
      level_(instructions.level),
      mechanisms_(mechanisms),
      user_forces_(mechanisms),
      driven_(layout_.width),
      signals_(layout_.width) {
  list_posed_bodies();
  allocate();
  for (int l = 0; l < layout_.width; ++l) load(l, mechanism(l));
}

const Dynamics& LaneEvaluation::mechanism(int l) const {
  return *mechanisms_[std::min(l, static_cast<int>(mechanisms_.size()) - 1)];
}

void LaneEvaluation::replace(int l, Dynamics& mechanism) {
  mechanisms_[l] = &mechanism;
  user_forces_.replace(l, mechanism);
  load(l, mechanism);
}

// --- what does not change ---

void LaneEvaluation::list_posed_bodies() {
  for (const LaneStructure::Forces& it : structure_.forces) {
    if (lanes_of(it.kind, level_)) continue;
    for (const std::vector<int>* bodies : {&it.body_i, &it.body_j})
      std::copy_if(bodies->begin(), bodies->end(), std::back_inserter(posed_),
                   [&](int body) { return body != structure_.bodies; });
  }
  std::sort(posed_.begin(), posed_.end());
  posed_.erase(std::unique(posed_.begin(), posed_.end()), posed_.end());
}

void LaneEvaluation::allocate() {
  const int n = structure_.bodies;
  size_D(at_.D);
  for (Numbers* rows : {&at_.Phi, &at_.Phi_t, &at_.Phi_dot, &at_.gamma}) layout_.size(*rows, structure_.rows);
  layout_.size(at_.g, velocity_size * (n + 1));
  for (Numbers* one : {&at_.potential, &at_.power}) layout_.size(*one, 1);
  layout_.size(gravity_, 3);
  layout_.size(mass_, 10l * n);
  layout_.size(states_, 18 * (n + 1));
  layout_.size(inertance_, structure_.inerters);
  for (Numbers* rows : {&coordinate_values_, &coordinate_Phi_t_, &coordinate_rates_, &coordinate_gamma_})
    layout_.size(*rows, structure_.coordinates);
  for (Numbers* variables : {&last_, &next_, &rate_}) layout_.size(*variables, structure_.history_size);
  layout_.size(switches_, structure_.switch_count);
  switches_of_lane_.setZero(structure_.switch_count);
  for (const LaneStructure::Joints& it : structure_.joints)
    allocate(joints_.emplace_back(), std::ssize(it.joint), joint_kinds()[it.kind].info.parameters.size());
  for (const LaneStructure::CoordinateRows& it : structure_.coordinate_rows) {
    allocate(coordinates_.emplace_back(), std::ssize(it.row), 0);
    coordinate_rows_.push_back(coordinate_rows(it.kind, it.valued).evaluate_lanes[level_]);
  }
  for (const LaneStructure::Forces& it : structure_.forces)
    allocate(forces_.emplace_back(), std::ssize(it.body_i), force_kinds()[it.kind].info.parameters.size());
}

void LaneEvaluation::size_D(Numbers& D) const {
  layout_.size(D, structure_.D_size);
  for (const LaneStructure::Joints& it : structure_.joints)
    for (const std::ptrdiff_t first : it.D) put_constant_D(joint_kinds()[it.kind], layout_, D, first);
}

void LaneEvaluation::allocate(Elements& elements, std::ptrdiff_t count, std::size_t parameter_count) const {
  elements.parameter_count = static_cast<int>(parameter_count);
  layout_.size(elements.attachments, attachment_size * count);
  layout_.size(elements.parameters, 3 * count * elements.parameter_count);
}

void LaneEvaluation::load(int l, const Dynamics& mechanism) {
  const System& system = mechanism.system();
  apart_ = apart_ || needs_lane_by_lane(system);
  driven_[l].clear();
  signals_[l].resize(system.model().signals().size());
  driven_at_all_ = driven_at_all_ || !signals_[l].empty();
  layout_.give(system.model().gravity().data(), 3, l, gravity_, 0);
  for (int body = 0; body < structure_.bodies; ++body)
    layout_.give(&system.mass_blocks()[body].m, 10, l, mass_, 10l * body);
  load_joints(l, system.model());
  load_coordinates(l, system);
  load_forces(l, system);
}

bool LaneEvaluation::needs_lane_by_lane(const System& system) const {
  const Model& model = system.model();
  return !posed_.empty() || !structure_.special.empty() || structure_.history_size > 0 ||
         !model.joint_forces().empty() || !model.user_forces().empty();
}

void LaneEvaluation::load_joints(int l, const Model& model) {
  for (std::size_t kind = 0; kind < joints_.size(); ++kind) {
    Elements& to = joints_[kind];
    const std::vector<int>& joints = structure_.joints[kind].joint;
    for (std::ptrdiff_t k = 0; k < std::ssize(joints); ++k) {
      const Element& joint = model.joints()[joints[k]];
      layout_.give(joint.at.s_i.data(), attachment_size, l, to.attachments, attachment_size * k);
      const Parameter* given = model.joint_parameters().data() + joint.first_parameter;
      for (int p = 0; p < to.parameter_count; ++p) load_parameter(l, given[p], to, to.parameter_count * k + p);
    }
  }
}

void LaneEvaluation::load_coordinates(int l, const System& system) {
  for (std::size_t kind = 0; kind < coordinates_.size(); ++kind) {
    const std::vector<int>& forces = structure_.coordinate_rows[kind].force;
    for (std::ptrdiff_t k = 0; k < std::ssize(forces); ++k)
      layout_.give(system.model().forces()[forces[k]].at.s_i.data(), attachment_size, l, coordinates_[kind].attachments,
                   attachment_size * k);
  }
  for (int k = 0; k < structure_.inerters; ++k)
    *layout_.place(inertance_, k, l) = system.inerters().inertance(static_cast<std::size_t>(k));
}

void LaneEvaluation::load_forces(int l, const System& system) {
  for (std::size_t kind = 0; kind < forces_.size(); ++kind) {
    Elements& to = forces_[kind];
    const ForceBatch& batch = system.force_batches()[structure_.forces[kind].kind];
    for (std::ptrdiff_t k = 0; k < std::ssize(batch.number); ++k) {
      const Element& force = system.model().forces()[batch.number[k]];
      layout_.give(force.at.s_i.data(), attachment_size, l, to.attachments, attachment_size * k);
      for (std::ptrdiff_t p = k * to.parameter_count; p < (k + 1) * to.parameter_count; ++p)
        load_parameter(l, batch.parameters[p], to, p);
    }
  }
}

void LaneEvaluation::load_parameter(int l, const Parameter& parameter, Elements& to, std::ptrdiff_t place) {
  const double constant[3] = {parameter.constant, 0.0, 0.0};
  layout_.give(constant, 3, l, to.parameters, 3 * place);
  if (parameter.signal >= 0) driven_[l].push_back({parameter.signal, layout_.place(to.parameters, 3 * place, l)});
}

// --- at states ---

template <class Action>
void LaneEvaluation::each_lane(const LaneGuard& guard, Action action) {
  for (int l = 0; l < static_cast<int>(mechanisms_.size()); ++l)
    if (guard.steps(l)) action(l);
}

/// `action(system, q, v, history, evaluation)` of one lane, at the state where it was begun.
template <class Action>
void LaneEvaluation::apart(int l, LaneGuard& guard, Action action) {
  const LaneUserForces::Place& here = user_forces_.place(l);
  const System& system = mechanisms_[l]->system();
  do_apart(
      [&] {
        action(system, here.y.head(system.q_size()), here.y.segment(system.q_size(), system.v_size()),
               mechanisms_[l]->history(), *here.at);
      },
      [&](std::string why) { guard.leave(l, here.t, std::move(why)); });
}

void LaneEvaluation::evaluate(const Numbers& t, const Numbers& y, LaneGuard& guard) {
  kernels_.states(structure_.bodies, y.data(), states_.data());
  kernels_.body_forces(structure_.bodies, mass_.data(), gravity_.data(), y.data(), at_.g.data(), at_.potential.data());
  layout_.clear(at_.g, std::ptrdiff_t{velocity_size} * structure_.bodies, velocity_size);
  layout_.clear(at_.power, 0, 1);
  evaluate_signals(t, guard);
  if (apart_) begin_apart(t, y, guard);
  evaluate_rows();
  evaluate_forces(guard);
}

void LaneEvaluation::evaluate_constraints(const Numbers& t, const Numbers& y, LaneGuard& guard) {
  kernels_.states(structure_.bodies, y.data(), states_.data());
  evaluate_signals(t, guard);
  if (apart_) begin_apart(t, y, guard);
  evaluate_rows();
}

void LaneEvaluation::evaluate_signals(const Numbers& t, LaneGuard& guard) {
  if (!driven_at_all_) return;
  each_lane(guard, [&](int l) {
    if (signals_[l].empty()) return;
    do_apart([&] { mechanisms_[l]->system().evaluate_signals(t[l], signals_[l]); },
             [&](std::string why) { guard.leave(l, t[l], std::move(why)); });
    give_signals(l, signals_[l]);
  });
}

void LaneEvaluation::begin_apart(const Numbers& t, const Numbers& y, LaneGuard& guard) {
  each_lane(guard, [&](int l) {
    LaneUserForces::Place& here = user_forces_.place(l);
    here.t = t[l];
    here.y.resize(structure_.y_size());
    layout_.take(y, l, 0, here.y);
    here.at = &mechanisms_[l]->begin_elsewhere(here.t, here.y);
    apart(l, guard, [&](const System& system, auto q, auto v, const VectorXd& history, Evaluation& at) {
      at.signals = signals_[l];
      system.evaluate_special_joints(q, v, history, at);
    });
    if (!guard.steps(l)) return;
    give_special_joints(l, *here.at);
    layout_.give(mechanisms_[l]->history().data(), structure_.history_size, l, last_, 0);
  });
}

/// Functions of time among the parameters.
void LaneEvaluation::give_signals(int l, const std::vector<Signal<double>>& signals) {
  for (const Driven& it : driven_[l]) {
    const Signal<double>& signal = signals[it.signal];
    it.to[0] = signal.value;
    it.to[layout_.width] = signal.rate;
    it.to[2l * layout_.width] = signal.acceleration;
  }
}

void LaneEvaluation::give_special_joints(int l, const Evaluation& at) {
  const System& system = mechanisms_[l]->system();
  for (const int joint : structure_.special) {
    const int row = system.model().joint_rows()[joint], rows = system.model().joint_rows()[joint + 1] - row;
    layout_.give(at.Phi.data() + row, rows, l, at_.Phi, row);
    layout_.give(at.Phi_t.data() + row, rows, l, at_.Phi_t, row);
    layout_.give(at.Phi_dot.data() + row, rows, l, at_.Phi_dot, row);
    layout_.give(at.gamma.data() + row, rows, l, at_.gamma, row);
    for (const int index : system.joint_blocks(joint)) {
      const ConstraintBlock& block = system.blocks()[index];
      layout_.give(at.D.data() + block.offset, std::ptrdiff_t{velocity_size} * rows, l, at_.D, block.offset);
    }
  }
}

/// Joints and coordinates.
void LaneEvaluation::evaluate_rows() {
  const ConstraintArrays out{at_.Phi.data(), at_.Phi_t.data(), at_.Phi_dot.data(), at_.gamma.data(), at_.D.data()};
  for (std::size_t kind = 0; kind < joints_.size(); ++kind) {
    const LaneStructure::Joints& joints = structure_.joints[kind];
    const Elements& numbers = joints_[kind];
    joint_kinds()[joints.kind].evaluate_lanes[level_](
        {static_cast<int>(joints.joint.size()), joints.body_i.data(), joints.body_j.data(), numbers.attachments.data(),
         numbers.parameters.data(), numbers.parameter_count, joints.row.data(), joints.D.data(), states_.data()},
        out);
  }
  for (std::size_t kind = 0; kind < coordinates_.size(); ++kind) {
    const LaneStructure::CoordinateRows& rows = structure_.coordinate_rows[kind];
    coordinate_rows_[kind](
        {static_cast<int>(rows.row.size()), rows.body_i.data(), rows.body_j.data(),
         coordinates_[kind].attachments.data(), nullptr, 0, rows.row.data(), rows.D.data(), states_.data()},
        {coordinate_values_.data(), coordinate_Phi_t_.data(), coordinate_rates_.data(), coordinate_gamma_.data(),
         at_.D.data()});
  }
  for (const std::ptrdiff_t D : structure_.dropped_D) layout_.clear(at_.D, D, velocity_size);
}

void LaneEvaluation::take_inerters(int l, Evaluation& out) const {
  layout_.take(at_.D, l, structure_.inerter_D,
               Eigen::Map<VectorXd>(out.D.data() + structure_.inerter_D, structure_.inerter_D_size));
}

// --- forces, in the order of System::evaluate ---

void LaneEvaluation::evaluate_forces(LaneGuard& guard) {
  const ForceArrays out{at_.g.data(),     last_.data(),         next_.data(),     rate_.data(),
                        switches_.data(), at_.potential.data(), at_.power.data(), nullptr};
  const CoordinateValues coordinates{coordinate_values_.data(), coordinate_rates_.data(), at_.D.data()};
  if (!posed_.empty()) each_lane(guard, [&](int l) { pose_bodies(l, *user_forces_.place(l).at); });
  for (std::size_t k = 0; k < forces_.size(); ++k) {
    const LaneStructure::Forces& of = structure_.forces[k];
    const ForceLanes elements{static_cast<int>(of.body_i.size()),
                              of.body_i.data(),
                              of.body_j.data(),
                              forces_[k].attachments.data(),
                              forces_[k].parameters.data(),
                              forces_[k].parameter_count,
                              of.history.data(),
                              of.switches.data(),
                              states_.data()};
    if (!of.row.empty())
      force_kinds()[of.kind].law_lanes[level_]({elements, of.row.data(), of.D.data()}, coordinates, out);
    else if (const EvaluateForceLanes evaluate = lanes_of(of.kind, level_)) evaluate(elements, out);
    else evaluate_lane_by_lane(of.kind, guard);
  }
  if (structure_.history_size > 0) each_lane(guard, [&](int l) { take_history(l, *user_forces_.place(l).at); });
  if (structure_.switch_count > 0)
    each_lane(guard, [&](int l) {
      if (mechanisms_[l]->looks_for_switches()) mechanisms_[l]->look_for_switches(switches(l));
    });
  kernels_.inertia_forces(structure_.blocks.data() + structure_.joint_blocks,
                          std::ssize(structure_.blocks) - structure_.joint_blocks, structure_.rows, inertance_.data(),
                          coordinate_gamma_.data(), at_.D.data(), at_.g.data());
  if (apart_) evaluate_other_forces(guard);
}

/// For force elements that are evaluated one by one.
void LaneEvaluation::pose_bodies(int l, Evaluation& at) const {
  constexpr std::ptrdiff_t size = sizeof(BodyState<double>) / sizeof(double);
  for (const int body : posed_)
    layout_.take(states_, l, size * body, Eigen::Map<VectorXd>(at.bodies[body].r.data(), size));
}

void LaneEvaluation::evaluate_lane_by_lane(int kind, LaneGuard& guard) {
  each_lane(guard, [&](int l) {
    apart(l, guard, [&](const System& system, auto q, auto v, const VectorXd& history, Evaluation& at) {
      take_forces(l, at);
      const auto all = static_cast<std::size_t>(kind);
      system.evaluate_elements_of(all, 0, static_cast<int>(system.force_batches()[all].size()), q, v, at,
                                  {at.g.data(), history.data(), at.history.data(), at.history_rate.data(),
                                   at.switches.data(), &at.potential, &at.power});
      give_forces(l, at);
    });
  });
}

/// Of force elements that are evaluated in lanes.
void LaneEvaluation::take_history(int l, Evaluation& at) const {
  for (const LaneStructure::Forces& of : structure_.forces) {
    if (force_kinds()[of.kind].history == HistoryKind::none || !lanes_of(of.kind, level_)) continue;
    for (const std::ptrdiff_t variable : of.history) {
      at.history[variable] = next_[variable * layout_.width + l];
      at.history_rate[variable] = rate_[variable * layout_.width + l];
    }
  }
}

const VectorXd& LaneEvaluation::switches(int l) {
  if (apart_) switches_of_lane_ = user_forces_.place(l).at->switches;
  for (const LaneStructure::Forces& of : structure_.forces) {
    if (!lanes_of(of.kind, level_)) continue;
    for (const std::ptrdiff_t first : of.switches)
      layout_.take(switches_, l, first, switches_of_lane_.segment(first, force_kinds()[of.kind].switches));
  }
  return switches_of_lane_;
}

/// The user's own.
void LaneEvaluation::evaluate_other_forces(LaneGuard& guard) {
  const auto has_any = [](const Dynamics* it) {
    return !it->system().model().joint_forces().empty() || !it->system().model().user_forces().empty();
  };
  if (std::none_of(mechanisms_.begin(), mechanisms_.end(), has_any)) return;
  each_lane(guard, [&](int l) {
    apart(l, guard, [&](const System& system, auto q, auto v, const VectorXd& history, Evaluation& at) {
      take_forces(l, at);
      system.evaluate_joint_forces(user_forces_.place(l).t, q, v, history, at);
    });
  });
  if (!user_forces_.none()) user_forces_.add(guard);
  each_lane(guard, [&](int l) { give_forces(l, *user_forces_.place(l).at); });
}

void LaneEvaluation::take_forces(int l, Evaluation& at) const {
  layout_.take(at_.g, l, 0, at.g);
  at.potential = at_.potential[l];
  at.power = at_.power[l];
}

void LaneEvaluation::give_forces(int l, const Evaluation& at) {
  layout_.give(at.g.data(), velocity_size * structure_.bodies, l, at_.g, 0);
  at_.potential[l] = at.potential;
  at_.power[l] = at.power;
}

}  // namespace linkwork
