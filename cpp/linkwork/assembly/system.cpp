#include "linkwork/assembly/system.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "linkwork/math/error.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_parameters = 8;  // of a special joint
constexpr int chunk_of_forces = 1024;       // that a thread works on at a time

}  // namespace

VectorXd System::beginning_history(double t, const ConstVector& q, const ConstVector& v) const {
  if (history_size() == 0) return {};
  Evaluation at = make_evaluation();
  const VectorXd blank = blank_history();
  evaluate_constraints(t, q, v, blank, at);
  if (!force_kinds_in_use_.empty()) evaluate_elements(q, v, blank, at);
  for (std::size_t k = 0; k < model_.joint_forces().size(); ++k)
    if (const int place = joint_force_history_[k]; place >= 0) {
      const JointForce& force = model_.joint_forces()[k];
      Equation<double> row;
      force.coordinate->evaluate(force.at, moving(force.i, q, v), moving(force.j, q, v), row);
      at.history[place] = row.Phi;
    }
  return at.history;
}

bool System::begins_contact(const ConstVector& history_before, const ConstVector& history_after) const {
  return std::any_of(switches_.begin(), switches_.end(), [&](int contact) {
    return contact >= 0 && history_before[contact] == 0.0 && history_after[contact] != 0.0;
  });
}

bool System::shares_work() const {
  return body_count() > chunk || joint_count() > chunk || !body_wrench_begin_.empty();
}

// g = (m gravity, -omega x J omega) + force elements; potential of gravity -m gravity . r
void System::evaluate(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                      Evaluation& out) const {
  evaluate_signals(t, out);
  evaluate_chunks(q, v, true, out);
  out.potential = std::accumulate(out.potentials.begin(), out.potentials.end(), 0.0);
  evaluate_other_constraints(q, v, history, out);  // D and gamma of (12.2) are complete
  out.power = 0.0;
  evaluate_forces(t, q, v, history, out);  // g of (12.1)
  if (!model_.user_forces().empty()) evaluate_user_forces(t, q, v, out);
}

void System::evaluate_forces(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                             Evaluation& out) const {
  if (!force_kinds_in_use_.empty()) evaluate_elements(q, v, history, out);
  inerters_.add(
      out.D.data(),
      [&](std::size_t k) { return inerters_.inertance(k) * out.coordinate_gamma[static_cast<Eigen::Index>(k)]; },
      out.g.data());
  if (!model_.joint_forces().empty()) evaluate_joint_forces(t, q, v, history, out);
}

/// Joints, and bodies too: while the states of a chunk of bodies are in a cache, also the joints of the same number.
void System::evaluate_chunks(const ConstVector& q, const ConstVector& v, bool with_bodies, Evaluation& out) const {
  const int joints = static_cast<int>(joint_chunks_.size());
  const int bodies = with_bodies ? static_cast<int>(out.potentials.size()) : 0;
  const auto evaluate = [&](int part, int) {
    if (part < joints) evaluate_joints(joint_chunks_[part], q, v, out);
    if (part < bodies) evaluate_bodies(part, q, v, out);
  };
  const int parts = std::max(joints, bodies);
  if (threads_->threads() > 1) return threads_->run(parts, evaluate);
  for (int part = 0; part < parts; ++part) evaluate(part, 0);
}

void System::evaluate_joints(const JointChunk& of, const ConstVector& q, const ConstVector& v, Evaluation& out) const {
  of.kind->evaluate(of.joints, q.data(), v.data(), out.signals.data(),
                    {out.Phi.data(), out.Phi_t.data(), out.Phi_dot.data(), out.gamma.data(), out.D.data()});
}

void System::evaluate_bodies(int part, const ConstVector& q, const ConstVector& v, Evaluation& out) const {
  const std::ptrdiff_t first = std::ptrdiff_t{part} * chunk;
  const auto count = static_cast<int>(std::min<std::ptrdiff_t>(chunk, body_count() - first));
  out.potentials[part] =
      body_forces_(count, mass_.data() + first, model_.gravity().data(), q.data() + position_size * first,
                   v.data() + velocity_size * first, out.g.data() + velocity_size * first);
}

Wrenches<double> System::joint_force(std::size_t k, double t, const ConstVector& q, const ConstVector& v,
                                     HistoryVariable<double>& history) const {
  const JointForce& force = model_.joint_forces()[k];
  Wrenches<double> out;
  force.evaluate(t, moving(force.i, q, v), moving(force.j, q, v), history, out);
  return out;
}

void System::evaluate_joint_forces(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                                   Evaluation& out) const {
  for (std::size_t k = 0; k < model_.joint_forces().size(); ++k) {
    const JointForce& force = model_.joint_forces()[k];
    const int place = joint_force_history_[k];
    HistoryVariable<double> variable{place < 0 ? 0.0 : history[place]};
    const Wrenches<double> wrenches = joint_force(k, t, q, v, variable);
    if (place >= 0) {
      out.history[place] = variable.next;
      out.history_rate[place] = variable.rate;
    }
    const auto add = [&](int body, const Vec3<double>& F, const Vec3<double>& n) {
      if (body == ground) return;
      out.g.segment<3>(velocity_size * body) += F;
      out.g.segment<3>(velocity_size * body + 3) += n;
    };
    add(force.i, wrenches.force_i, wrenches.torque_i);
    add(force.j, wrenches.force_j, wrenches.torque_j);
    out.power += wrenches.power;
  }
}

void System::evaluate_user_forces(double t, const ConstVector& q, const ConstVector& v, Evaluation& out) const {
  for (const auto& force : model_.user_forces()) {
    out.user.setZero(v_size());
    force->add(t, body_count(), q.data(), v.data(), out.user.data());
    add_user_force(out.user, v, out);
  }
}

void System::add_user_force(const VectorXd& force, const ConstVector& v, Evaluation& out) const {
  out.g.head(v_size()) += force;
  out.power += force.dot(v);
}

void System::evaluate_switches(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                               Evaluation& out) const {
  evaluate_signals(t, out);
  if (!coordinates_.empty()) evaluate_coordinates(q, v, out);
  if (!force_kinds_in_use_.empty()) evaluate_elements(q, v, history, out);
}

void System::evaluate_signals(double t, std::vector<Signal<double>>& out) const {
  for (std::size_t s = 0; s < out.size(); ++s)
    if (model_.signals()[s]->of_time()) out[s] = model_.signals()[s]->evaluate(t);
  if (!model_.limited().empty()) check_limits(t, out);
}

void System::evaluate_constraints(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                                  Evaluation& out) const {
  evaluate_signals(t, out);
  evaluate_chunks(q, v, false, out);
  evaluate_other_constraints(q, v, history, out);
}

void System::evaluate_special_joints(const ConstVector& q, const ConstVector& v, const ConstVector& history,
                                     Evaluation& out) const {
  for (const CompiledSpecialJoint& it : special_joints_) evaluate_special_joint(it, q, v, history, out);
}

/// Those of special joints and of inerters, and other coordinates of elements.
void System::evaluate_other_constraints(const ConstVector& q, const ConstVector& v, const ConstVector& history,
                                        Evaluation& out) const {
  evaluate_special_joints(q, v, history, out);
  if (!coordinates_.empty()) evaluate_coordinates(q, v, out);
}

void System::evaluate_coordinates(const ConstVector& q, const ConstVector& v, Evaluation& out) const {
  coordinates_.evaluate(q.data(), v.data(), out.D.data(), out.coordinate_gamma.data(), out.coordinates.data(),
                        out.coordinate_rates.data(), *threads_);
}

/// OptionError: a function of time is where no value of its parameter can be.
void System::check_limits(double t, const std::vector<Signal<double>>& signals) const {
  for (const Limited& it : model_.limited()) {
    const double value = current(it.value, signals.data()).value, least = current(it.least, signals.data()).value;
    if (!(value < least)) continue;
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, " is %.6g at t = %.6g s, and must not be below %.6g", value, t, least);
    throw OptionError("out_of_bounds", it.what + numbers + (it.than.empty() ? "" : ", which is " + it.than));
  }
}

void System::evaluate_special_joint(const CompiledSpecialJoint& it, const ConstVector& q, const ConstVector& v,
                                    const ConstVector& history, Evaluation& out) const {
  const Element& element = model_.joints()[it.joint];
  std::array<Signal<double>, most_parameters> parameters{};
  const std::size_t count = joint_info(element.kind).parameters.size();
  for (std::size_t p = 0; p < count; ++p)
    parameters[p] = current(model_.joint_parameters()[element.first_parameter + p], out.signals.data());
  const std::vector<int>& bodies = it.special->bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) out.special[k] = moving(bodies[k], q, v);

  const auto rows = [&](VectorXd& all) { return all.segment(it.row, it.rows); };
  double* D = out.D.data() + it.D;
  std::fill_n(D, velocity_size * it.rows * static_cast<int>(bodies.size()), 0.0);
  for (VectorXd* x : {&out.Phi, &out.Phi_t, &out.gamma}) rows(*x).setZero();
  it.special->evaluate(
      out.special.data(), parameters.data(),
      {history.data() + it.history, out.history.data() + it.history, out.history_rate.data() + it.history},
      {rows(out.Phi).data(), rows(out.Phi_t).data(), rows(out.gamma).data(), D});
  rows(out.Phi_dot) = rows(out.Phi_t);
  for (const int index : joint_blocks(it.joint)) {
    const ConstraintBlock& block = blocks_[index];
    rows(out.Phi_dot).noalias() += block_of(out, block) * v.segment<velocity_size>(velocity_size * block.body);
  }
}

void System::pose_bodies(const ConstVector& q, const ConstVector& v, Evaluation& out) const {
  threads_->in_chunks(static_cast<int>(posed_bodies_.size()), chunk, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      const int body = posed_bodies_[k];
      out.bodies[body] = moving(body, q, v);
    }
  });
}

void System::evaluate_elements(const ConstVector& q, const ConstVector& v, const ConstVector& history,
                               Evaluation& out) const {
  if (!posed_bodies_.empty()) pose_bodies(q, v, out);
  const ForceArrays arrays{out.g.data(),        history.data(), out.history.data(), out.history_rate.data(),
                           out.switches.data(), &out.potential, &out.power};
  if (threads_->threads() > 1 && !out.wrenches.empty()) return evaluate_many_elements(q, v, arrays, out);
  for (const std::size_t kind : force_kinds_in_use_)
    evaluate_elements_of(kind, 0, static_cast<int>(force_batches_[kind].size()), q, v, out, arrays);
}

void System::evaluate_elements_of(std::size_t kind, int first, int last, const ConstVector& q, const ConstVector& v,
                                  const Evaluation& at, const ForceArrays& out) const {
  const ForceBatch& batch = force_batches_[kind];
  if (!batch.row.empty())
    return force_kinds()[kind].laws[force_levels_[kind]](
        batch.laws(first, last), {at.coordinates.data(), at.coordinate_rates.data(), at.D.data()}, at.signals.data(),
        out);
  force_kinds()[kind].evaluate(force_levels_[kind], batch, first, last,
                               {q.data(), v.data(), at.bodies.data(), at.signals.data(), model_.signals().data()}, out);
}

/// Each leaves what it does, for the sums of all to be made in the order that one thread makes them in.
void System::evaluate_many_elements(const ConstVector& q, const ConstVector& v, const ForceArrays& arrays,
                                    Evaluation& out) const {
  double* wrenches = out.wrenches.data();
  for (const std::size_t kind : force_kinds_in_use_) {
    const auto count = static_cast<int>(force_batches_[kind].size());
    const auto evaluate = [&](int first, int last) {
      ForceArrays own = arrays;
      own.wrenches = wrenches + wrench_size * static_cast<std::size_t>(first);
      evaluate_elements_of(kind, first, last, q, v, out, own);
    };
    if (called_alone_[kind]) evaluate(0, count);
    else threads_->in_chunks(count, chunk_of_forces, evaluate);
    wrenches += wrench_size * static_cast<std::size_t>(count);
  }
  add_wrenches(arrays, out);
}

void System::add_wrenches(const ForceArrays& arrays, Evaluation& out) const {
  using Vec6 = Eigen::Matrix<double, velocity_size, 1>;
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {
    for (int body = first; body < last; ++body)
      for (int k = body_wrench_begin_[body]; k < body_wrench_begin_[body + 1]; ++k) {
        const int wrench = body_wrench_list_[k];
        const double* from = out.wrenches.data() + wrench_size * (wrench / 2) + velocity_size * (wrench % 2);
        Eigen::Map<Vec6>(arrays.g + velocity_size * std::ptrdiff_t{body}) += Eigen::Map<const Vec6>(from);
      }
  });
  for (std::size_t k = 0; k < out.wrenches.size(); k += wrench_size) {
    *arrays.potential += out.wrenches[k + 12];
    *arrays.power += out.wrenches[k + 13];
  }
}

BodyState<double> System::pose(int body, const ConstVector& q) const {
  BodyState<double> state = BodyState<double>::ground();
  if (body == ground) return state;
  state.r = q.segment<3>(position_size * body);
  state.A = rotation_matrix<double>(q.segment<4>(position_size * body + 3));
  return state;
}

BodyState<double> System::moving(int body, const ConstVector& q, const ConstVector& v) const {
  BodyState<double> state = pose(body, q);
  if (body == ground) return state;
  state.r_dot = v.segment<3>(velocity_size * body);
  state.omega = v.segment<3>(velocity_size * body + 3);
  return state;
}

}  // namespace linkwork
