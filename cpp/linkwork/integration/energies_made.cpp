#include "linkwork/integration/energies_made.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/integration/state_difference.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

constexpr double rounding_of_energy = 1e-12;           // relative to it
constexpr double made_at_start = 2.0;                  // of an integral over time, relative to that of a drift
constexpr double stays = 1e-10, hardly_falls = 1e-12;  // of the size of a part in a run: it is at rest

/// Whether all its functions are of a coordinate, and tell what is stored.
bool may_conserve(const Model& model, const Element& force, bool touching) {
  const ForceKind& kind = force_kinds()[force.kind];
  if (kind.switches > 0 && !touching) return false;
  for (std::size_t p = 0; p < kind.info.parameters.size(); ++p) {
    const int signal = model.force_parameters()[force.first_parameter + p].signal;
    if (signal < 0) continue;
    const TimeFunctionPtr& function = model.signals()[static_cast<std::size_t>(signal)];
    if (function->of_time() || !function->integral()) return false;
  }
  return true;
}

/// Of all parts at once. Energies are tables of a column for each part, a row for each state, by time.
class EnergySearch {
 public:
  EnergySearch(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const VectorXd& lengths)
      : dynamics_(dynamics),
        system_(dynamics.system()),
        connected_(ConnectedParts::of(system_)),
        lengths_(lengths),
        conserves_(may_conserve(system_)) {
    for (const KeptStep* step : steps) {
      states_.push_back({step->t, &step->y, step});
      states_.push_back({step->t + step->h, &step->y_new, step});
    }
    std::stable_sort(states_.begin(), states_.end(), [](const State& a, const State& b) { return a.t < b.t; });
  }

  std::vector<std::optional<EnergyMade>> result() {
    std::vector<std::optional<EnergyMade>> out(conserves_.size());
    if (conserves_.size() < 2 || states_.empty() || !any()) return out;
    const auto rows = static_cast<Eigen::Index>(states_.size());
    for (MatrixXd* table : {&kinetic_, &in_inerters_, &potential_}) table->setZero(rows, connected_.count());
    mass_.setZero(connected_.count());
    for (int body = 0; body < system_.body_count(); ++body) mass_[connected_.of_body(body)] += system_.mass(body);
    add_bodies();
    if (!system_.inerters().empty()) add_inerters();
    add_forces();
    for (std::size_t part = 0; part < out.size(); ++part)
      if (conserves_[part]) out[part] = made(static_cast<Eigen::Index>(part));
    return out;
  }

 private:
  struct State {
    double t;
    const VectorXd* y;
    const KeptStep* step;
  };

  bool any() const { return std::find(conserves_.begin(), conserves_.end(), true) != conserves_.end(); }
  auto q(const VectorXd& y) const { return y.head(system_.q_size()); }
  auto v(const VectorXd& y) const { return y.segment(system_.q_size(), system_.v_size()); }

  void add_bodies() {
    const Vec3<double>& gravity = system_.model().gravity();
    for (std::size_t k = 0; k < states_.size(); ++k) {
      look_for_interruption();
      const VectorXd& y = *states_[k].y;
      for (int body = 0; body < system_.body_count(); ++body) {
        const auto row = static_cast<Eigen::Index>(k);
        const int part = connected_.of_body(body);
        const auto its_v = v(y).segment<velocity_size>(velocity_size * body);
        const double turning = its_v.tail<3>().dot(system_.inertia(body) * its_v.tail<3>());
        kinetic_(row, part) += 0.5 * (system_.mass(body) * its_v.head<3>().squaredNorm() + turning);
        potential_(row, part) -= system_.mass(body) * gravity.dot(y.segment<3>(position_size * body));
      }
    }
  }

  void add_inerters() {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      dynamics_.set_history(states_[k].step->history);
      dynamics_.evaluate(states_[k].step->t, *states_[k].y);  // tables may end where the step does
      const VectorXd its_v = v(*states_[k].y);
      in_inerters_.row(static_cast<Eigen::Index>(k)) = energies_in_inerters(system_, dynamics_.evaluation(), its_v);
    }
    kinetic_ += in_inerters_;
  }

  /// A part with one that does work in any of these states is none to look at.
  void add_forces() {
    const std::vector<Element>& forces = system_.model().forces();
    std::vector<int> history(forces.size(), -1);
    for (int k = 0; k < system_.history_size(); ++k)
      if (const HistoryOwner& owner = system_.history_owners()[k];
          !owner.joint && owner.element < static_cast<int>(forces.size()))
        history[owner.element] = k;
    for (std::size_t f = 0; f < forces.size(); ++f) {
      if (forces[f].i == ground && forces[f].j == ground) continue;
      const int part = connected_.of_bodies(forces[f].i, forces[f].j);
      if (!conserves_[part]) continue;
      look_for_interruption();
      ForceElement element(system_, static_cast<int>(f), history[f]);
      for (std::size_t k = 0; k < states_.size() && conserves_[part]; ++k) {
        const auto [t, y, step] = states_[k];
        const auto [stored, working] = element.energy(t, q(*y), v(*y), step->history);
        potential_(static_cast<Eigen::Index>(k), part) += stored;
        if (working != 0.0) conserves_[part] = false;
      }
    }
  }

  EnergyMade made(Eigen::Index part) const {
    EnergyMade out;
    const auto kinetic = kinetic_.col(part), potential = potential_.col(part);
    const VectorXd made = (kinetic + potential).array() - (kinetic[0] + potential[0]);
    double integral = 0.0, largest_integral = 0.0;
    for (Eigen::Index k = 1; k < made.size(); ++k) {
      integral += 0.5 * (made[k] + made[k - 1]) * (states_[k].t - states_[k - 1].t);
      largest_integral = std::max(largest_integral, std::abs(integral));
    }
    out.exchanged = potential.maxCoeff() - potential.minCoeff();
    out.in_inerters = in_inerters_.col(part).maxCoeff();
    out.amount = std::max(kinetic.maxCoeff(), potential.cwiseAbs().maxCoeff());
    const double seconds = states_.back().t - states_.front().t, speed = stays * lengths_[part] / seconds;
    out.rest = mass_[part] * (0.5 * speed * speed + system_.model().gravity().norm() * hardly_falls * lengths_[part]);
    const double most = made.cwiseAbs().maxCoeff(), drift = 0.5 * most * seconds;
    out.largest = std::max(most - rounding_of_energy * out.amount, 0.0);
    if (drift > 0.0) out.lasting = std::min(largest_integral / drift, made_at_start);
    return out;
  }

  Dynamics& dynamics_;
  const System& system_;
  const ConnectedParts& connected_;
  const VectorXd& lengths_;
  std::vector<bool> conserves_;
  std::vector<State> states_;
  MatrixXd kinetic_, in_inerters_, potential_;
  VectorXd mass_;  ///< of each part [kg]
};

}  // namespace

std::vector<bool> may_conserve(const System& system, bool touching) {
  const ConnectedParts& connected = ConnectedParts::of(system);
  const Model& model = system.model();
  std::vector<bool> out(static_cast<std::size_t>(connected.count()),
                        model.user_forces().empty());  // on whichever bodies
  const auto leave_out = [&](int i, int j) {
    if (i != ground || j != ground) out[connected.of_bodies(i, j)] = false;
  };
  for (const int row : system.driven_rows()) out[connected.of_row(row)] = false;
  for (const Element& force : model.forces())
    if (!may_conserve(model, force, touching)) leave_out(force.i, force.j);
  for (const JointForce& force : model.joint_forces()) leave_out(force.i, force.j);
  return out;
}

std::vector<std::optional<EnergyMade>> find_energies_made(Dynamics& dynamics, const std::vector<const KeptStep*>& steps,
                                                          const VectorXd& lengths) {
  return EnergySearch(dynamics, steps, lengths).result();
}

// b (d . v) (d . w) of each inerter
VectorXd products_of_inerters(const System& system, const Evaluation& at, const VectorXd& v, const VectorXd& w) {
  const Inerters& inerters = system.inerters();
  const ConnectedParts& connected = ConnectedParts::of(system);
  VectorXd out = VectorXd::Zero(connected.count());
  for (std::size_t i = 0; i < inerters.count(); ++i) {
    const auto [first, second] = inerters.bodies(i);
    const double* D = at.D.data();
    out[connected.of_bodies(first, second)] +=
        inerters.inertance(i) * inerters.rate(i, D, v.data()) * inerters.rate(i, D, w.data());
  }
  return out;
}

VectorXd energies_in_inerters(const System& system, const Evaluation& at, const VectorXd& v) {
  return 0.5 * products_of_inerters(system, at, v, v);
}

// omega in body axes, where g has the torque - omega x J omega, which does no work; and of inerters what d_dot asks for
VectorXd energies_apart(const System& system, const Evaluation& at, const VectorXd& y, const VectorXd& other) {
  const ConnectedParts& connected = ConnectedParts::of(system);
  const VectorXd its_v = y.segment(system.q_size(), system.v_size());
  VectorXd out = products_of_inerters(system, at, its_v, other.segment(system.q_size(), system.v_size()) - its_v);
  for (int body = 0; body < system.body_count(); ++body) {
    const int r = position_size * body, w = velocity_size * body, v = system.q_size() + w;
    const Vec3<double> turn = StateDifference::turn(other.segment<4>(r + 3), y.segment<4>(r + 3));
    const Vec3<double> omega = y.segment<3>(v + 3), spin = system.inertia(body) * omega;
    const Vec3<double> torque = at.g.segment<3>(w + 3) - spin.cross(omega);
    out[connected.of_body(body)] += system.mass(body) * y.segment<3>(v).dot(other.segment<3>(v) - y.segment<3>(v)) +
                                    spin.dot(other.segment<3>(v + 3) - omega) -
                                    at.g.segment<3>(w).dot(other.segment<3>(r) - y.segment<3>(r)) - torque.dot(turn);
  }
  return out;
}

VectorXd scales_of_energies(const System& system, const Evaluation& at, const VectorXd& y) {
  const ConnectedParts& connected = ConnectedParts::of(system);
  VectorXd out = VectorXd::Zero(connected.count());
  for (int body = 0; body < system.body_count(); ++body) {
    const int r = position_size * body, w = velocity_size * body, v = system.q_size() + w;
    out[connected.of_body(body)] += at.g.segment<3>(w).norm() * y.segment<3>(r).norm() + at.g.segment<3>(w + 3).norm() +
                                    system.mass(body) * y.segment<3>(v).squaredNorm();
  }
  return out;
}

}  // namespace linkwork
