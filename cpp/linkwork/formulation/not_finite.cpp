#include "linkwork/formulation/not_finite.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double diverged = 1e50;  // velocities of which nothing else is to blame for what follows

/// The first joint with an equation that is not finite, or -1.
int joint_not_finite(const System& system, const Evaluation& at) {
  for (int row = 0; row < system.row_count(); ++row)
    if (!std::isfinite(at.Phi[row]) || !std::isfinite(at.Phi_dot[row]) || !std::isfinite(at.gamma[row]))
      return system.model().joint_of_row(row);
  return -1;
}

/// The bodies of one force element and nothing else, as a model with that force; their numbers in the whole.
Model alone(const Model& model, const Element& force, std::vector<int>& bodies) {
  Model out(Vec3<double>::Zero());
  const auto place = [&](int body) {
    if (body == ground) return ground;
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    if (found != bodies.end()) return static_cast<int>(found - bodies.begin());
    bodies.push_back(body);
    return out.add_body(model.body_name(body), model.bodies()[body]);
  };
  const int i = place(force.i), j = place(force.j);
  for (const TimeFunctionPtr& signal : model.signals()) out.add_signal(signal);
  const KindInfo& info = force_kinds()[force.kind].info;
  const auto first = model.force_parameters().begin() + static_cast<std::ptrdiff_t>(force.first_parameter);
  out.add_force(info.name, "force", i, j, force.at,
                {first, first + static_cast<std::ptrdiff_t>(info.parameters.size())});
  return out;
}

/// The first of the user's own forces that is not finite, or -1.
int user_force_not_finite(const System& system, double t, const VectorXd& y) {
  const auto& forces = system.model().user_forces();
  for (std::size_t k = 0; k < forces.size(); ++k) {
    VectorXd g = VectorXd::Zero(system.v_size());
    forces[k]->add(t, system.body_count(), y.data(), y.data() + system.q_size(), g.data());
    if (!g.allFinite()) return static_cast<int>(k);
  }
  return -1;
}

/// The first of the user's own laws along coordinates that is not finite, or -1.
int joint_force_not_finite(const System& system, double t, const VectorXd& y) {
  const auto q = y.head(system.q_size()), v = y.segment(system.q_size(), system.v_size());
  for (std::size_t k = 0; k < system.model().joint_forces().size(); ++k) {
    HistoryVariable<double> variable;
    if (!std::isfinite(system.joint_force(k, t, q, v, variable).power)) return static_cast<int>(k);
  }
  return -1;
}

/// The first force element that gives something not finite, or -1.
int force_not_finite(const System& system, double t, const VectorXd& y) {
  for (std::size_t k = 0; k < system.model().forces().size(); ++k) {
    std::vector<int> bodies;
    const System one(alone(system.model(), system.model().forces()[k], bodies));
    VectorXd q(one.q_size()), v(one.v_size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto place = static_cast<Eigen::Index>(b);
      q.segment<7>(7 * place) = y.segment<7>(7 * bodies[b]);
      v.segment<6>(6 * place) = y.segment<6>(system.q_size() + 6 * bodies[b]);
    }
    Evaluation at = one.make_evaluation();
    one.evaluate(t, q, v, one.initial_history(), at);
    if (!at.g.head(one.v_size()).allFinite() || !std::isfinite(at.power)) return static_cast<int>(k);
  }
  return -1;
}

/// Empty where all are finite.
std::string name_of_force_not_finite(const System& system, double t, const VectorXd& y) {
  const Model& model = system.model();
  if (const int force = force_not_finite(system, t, y); force >= 0) return model.force_names().name(force);
  if (const int force = user_force_not_finite(system, t, y); force >= 0) return model.user_force_name(force);
  if (const int force = joint_force_not_finite(system, t, y); force >= 0) return model.joint_forces()[force].name;
  return "";
}

}  // namespace

void throw_not_finite(const System& system, const VectorXd& y, double t, int stage) {
  const Model& model = system.model();
  ErrorDetails details;
  details.time = t;
  details.stage = stage;
  for (int body = 0; body < system.body_count() && details.bodies.empty(); ++body)
    if (!y.segment<7>(7 * body).allFinite() || !y.segment<6>(system.q_size() + 6 * body).allFinite())
      details.bodies = {model.body_name(body)};
  const std::string when = stage > 1 ? " in stage " + std::to_string(stage) + " of a step" : "";
  Eigen::Index fastest = 0;
  const double speed = y.segment(system.q_size(), system.v_size()).cwiseAbs().maxCoeff(&fastest);
  if (details.bodies.empty() && speed < diverged) {
    Evaluation at = system.make_evaluation();
    system.evaluate(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()), system.initial_history(),
                    at);
    if (const int joint = joint_not_finite(system, at); joint >= 0) {
      details.joints = {model.joint_name(joint)};
      throw NotFiniteError("not_finite",
                           "joint '" + details.joints.front() + "': its equations became infinite or undefined" + when +
                               "; see what drives it, or use a smaller step",
                           details);
    }
    if (const std::string force = name_of_force_not_finite(system, t, y); !force.empty()) {
      details.forces = {force};
      throw NotFiniteError("not_finite",
                           "force '" + details.forces.front() + "' became infinite or undefined" + when +
                               "; see its parameters and its functions of time, or use a smaller step",
                           details);
    }
  }
  if (details.bodies.empty()) details.bodies = {model.body_name(static_cast<int>(fastest / velocity_size))};
  throw NotFiniteError("not_finite",
                       "body '" + details.bodies.front() + "' became infinite or undefined" + when +
                           ": the run diverged; use a smaller step, or see whether the mechanism locks in this pose",
                       details);
}

}  // namespace linkwork
