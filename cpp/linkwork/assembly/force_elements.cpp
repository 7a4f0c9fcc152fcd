#include "linkwork/assembly/force_elements.hpp"

#include <array>
#include <utility>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

using Position = Eigen::Matrix<double, position_size, 1>;
using Velocity = Eigen::Matrix<double, velocity_size, 1>;

Position position_of(int body, const ConstVector& q) {
  if (body == ground) return Position::Unit(3);
  return q.segment<position_size>(position_size * body);
}

Velocity velocity_of(int body, const ConstVector& v) {
  if (body == ground) return Velocity::Zero();
  return v.segment<velocity_size>(velocity_size * body);
}

BodyState<double> state_of(int body, const ConstVector& q, const ConstVector& v) {
  return {q.segment<3>(7 * body), rotation_matrix<double>(q.segment<4>(7 * body + 3)), v.segment<3>(6 * body),
          v.segment<3>(6 * body + 3)};
}

/// Of a force element; -1: it has none.
int history_variable(const System& system, int element) {
  for (int k = 0; k < system.history_size(); ++k)
    if (const HistoryOwner& owner = system.history_owners()[k]; !owner.joint && owner.element == element) return k;
  return -1;
}

}  // namespace

ForceElement::ForceElement(const System& system, int element)
    : ForceElement(system, element, history_variable(system, element)) {}

ForceElement::ForceElement(const System& system, int element, int history)
    : system_(system), element_(system.model().forces()[element]), history_(history) {
  const Model& model = system.model();
  const std::size_t count = force_kinds()[element_.kind].info.parameters.size();
  batch_.reserve(1, count, instruction_set(0).width);
  batch_.append(element, 0, 1, model.force_parameters().data() + element_.first_parameter, count);
  batch_.attach(element_.at);
  for (Parameter& parameter : batch_.parameters) {
    if (parameter.signal < 0) continue;
    functions_.push_back(model.signals()[static_cast<std::size_t>(parameter.signal)]);
    parameter.signal = static_cast<int>(functions_.size()) - 1;
  }
  signals_.resize(functions_.size());
  batch_.fill_up();
  batch_.attachment = {element_.at};
  batch_.history = batch_.switches = {0};
}

void ForceElement::replace(std::size_t parameter, TimeFunctionPtr function) {
  functions_[static_cast<std::size_t>(batch_.parameters[parameter].signal)] = std::move(function);
}

ForceElement::Said ForceElement::ask(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history) {
  for (std::size_t k = 0; k < functions_.size(); ++k)
    if (functions_[k]->of_time()) signals_[k] = functions_[k]->evaluate(t);
  Eigen::Matrix<double, 2 * position_size, 1> its_q;
  Eigen::Matrix<double, 2 * velocity_size, 1> its_v;
  its_q << position_of(element_.i, q), position_of(element_.j, q);
  its_v << velocity_of(element_.i, v), velocity_of(element_.j, v);
  Said out{{state_of(0, its_q, its_v), state_of(1, its_q, its_v)}};
  const double last = history_ < 0 ? 0.0 : history[history_];
  double rate = 0.0;
  force_kinds()[element_.kind].evaluate(
      0, batch_, 0, 1, {its_q.data(), its_v.data(), out.bodies.data(), signals_.data(), functions_.data()},
      {out.g.data(), &last, &out.history, &rate, out.switches.data(), &out.potential, &out.power});
  return out;
}

std::array<double, 2> ForceElement::switches(double t, const ConstVector& q, const ConstVector& v,
                                             const ConstVector& history) {
  return ask(t, q, v, history).switches;
}

std::array<double, 2 * velocity_size> ForceElement::forces(double t, const ConstVector& q, const ConstVector& v,
                                                           const ConstVector& history) {
  return ask(t, q, v, history).g;
}

double ForceElement::potential(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history) {
  return ask(t, q, v, history).potential;
}

ForceElement::Energy ForceElement::energy(double t, const ConstVector& q, const ConstVector& v,
                                          const ConstVector& history) {
  const Said said = ask(t, q, v, history);
  return {said.potential, said.power};
}

ForceOnBody ForceElement::evaluate(double t, const ConstVector& q, const ConstVector& v, const ConstVector& v_dot,
                                   const ConstVector& history) {
  Said said = ask(t, q, v, history);
  ForceOnBody out;
  out.potential = said.potential;
  out.history = said.history;
  if (force_kinds()[element_.kind].inertia) add_inertia(said.bodies.data(), v_dot, said.g.data());
  for (std::size_t k = 0; k < said.bodies.size(); ++k) {
    const BodyState<double>& body = said.bodies[k];
    const Eigen::Map<const Vec3<double>> force(said.g.data() + 6 * k), torque(said.g.data() + 6 * k + 3);
    out.power += force.dot(body.r_dot) + torque.dot(body.omega);
    if (k == 0) continue;
    out.force = force;
    out.torque = body.A * (torque - element_.at.s_j.cross(Vec3<double>(body.A.transpose() * force)));
  }
  return out;
}

/// -b x_ddot along the coordinate x of an inerter.
void ForceElement::add_inertia(const BodyState<double>* bodies, const ConstVector& v_dot, double* g) const {
  Equation<double> row;
  force_kinds()[element_.kind].inertia(element_.at, bodies[0], bodies[1], row);
  using Row = Eigen::Map<const Eigen::Matrix<double, velocity_size, 1>>;
  const Row D_i(row.D_i), D_j(row.D_j);
  double acceleration = -row.gamma;
  if (element_.i != ground) acceleration += D_i.dot(v_dot.segment<velocity_size>(velocity_size * element_.i));
  if (element_.j != ground) acceleration += D_j.dot(v_dot.segment<velocity_size>(velocity_size * element_.j));
  const double force = -batch_.parameters.front().constant * acceleration;
  Eigen::Map<Eigen::Matrix<double, velocity_size, 1>> on_i(g), on_j(g + velocity_size);
  on_i += force * D_i;
  on_j += force * D_j;
}

std::vector<SwitchOwner> owners_of_switches(const Model& model) {
  std::vector<SwitchOwner> out;
  for (std::size_t k = 0; k < model.forces().size(); ++k) {
    const ForceKind& kind = force_kinds()[model.forces()[k].kind];
    for (int s = 0; s < (kind.inertia ? 0 : kind.switches); ++s) out.push_back({static_cast<int>(k), s});
  }
  return out;
}

}  // namespace linkwork
