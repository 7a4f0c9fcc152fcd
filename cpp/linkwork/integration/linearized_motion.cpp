#include "linkwork/integration/linearized_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/integration/energies_made.hpp"
#include "linkwork/integration/state_difference.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr double least = 1e-250;   // error that is one at all
constexpr double of_whole = 0.25;  // of an error: at least so much counts as what the joints allow of it
constexpr double small = 1e-7;     // of lengths and speeds: perturbations that stand for a derivative
constexpr double forgotten = 0.7;  // of the rate of an error, from one step to the next
constexpr double fast = 0.02;      // share of the largest kinetic energy so far
constexpr double at_all = 1e-12;   // of that of the largest speed: below, differences of energies are rounding

Eigen::Index r_of(int body) { return position_size * static_cast<Eigen::Index>(body); }
Eigen::Index v_of(int body) { return velocity_size * static_cast<Eigen::Index>(body); }

bool all_holonomic(const Model& model) {
  for (int k = 0; k < static_cast<int>(model.joints().size()); ++k)
    if (!model.special_joint(k) && joint_kinds()[model.joints()[k].kind].info.velocity_rows() > 0) return false;
  return true;
}

bool all_may_conserve(const System& system) {
  const std::vector<bool> parts = may_conserve(system, true);
  return system.inerters().empty() && std::all_of(parts.begin(), parts.end(), [](bool it) { return it; });
}

}  // namespace

LinearizedMotion::LinearizedMotion(Dynamics& dynamics, const VectorXd& lengths, const VectorXd& speeds)
    : dynamics_(dynamics),
      system_(dynamics.system()),
      connected_(ConnectedParts::of(system_)),
      lengths_(lengths),
      speeds_(speeds),
      conservative_(all_may_conserve(system_)),
      holonomic_(all_holonomic(system_.model())),
      other_v_dot_(system_.v_size()),
      lambda_(VectorXd::Zero(system_.row_count())),
      most_change_(VectorXd::Zero(lengths.size())) {
  for (int body = 0; body < system_.body_count(); ++body) {
    const int part = connected_.of_body(body);
    most_change_[part] += at_all / fast * system_.mass(body) * speeds[part] * speeds[part];
  }
}

bool LinearizedMotion::go_to(double t, const VectorXd& y, const VectorXd& history) {
  look_for_interruption();
  here_.state.t = t;
  here_.state.y = y;
  dynamics_.set_history(history);
  here_.state.v_dot.resize(system_.v_size());
  if (!accelerate(here_.state.y, here_.state.v_dot)) return false;
  here_.violations = dynamics_.evaluation().Phi;
  here_.rates = dynamics_.evaluation().Phi_dot;
  here_.forces = dynamics_.evaluation().g.head(system_.v_size());
  here_.switches = dynamics_.evaluation().switches;
  conservative_ = conservative_ && dynamics_.evaluation().power == 0.0;
  return true;
}

bool LinearizedMotion::accelerate(const VectorXd& y, VectorXd& v_dot) {
  evaluations_ += 1;
  dynamics_.evaluate(here_.state.t, y);
  dynamics_.accelerations(v_dot, lambda_);
  return evaluations_ <= most_ && v_dot.allFinite();
}

bool LinearizedMotion::take_sides_of(const Place& place) {
  const std::vector<bool> before = std::exchange(here_.sides, std::vector<bool>());
  for (const double it : place.switches) here_.sides.push_back(it > 0.0);
  return here_.sides != before;
}

bool LinearizedMotion::on_its_side(const VectorXd& switches) const {
  for (std::size_t k = 0; k < here_.sides.size(); ++k)
    if ((switches[static_cast<Eigen::Index>(k)] > 0.0) != here_.sides[k]) return false;
  return true;
}

VectorXd LinearizedMotion::size(const VectorXd& way, const VectorXd& velocity) const {
  VectorXd out = VectorXd::Zero(lengths_.size());
  for (int body = 0; body < system_.body_count(); ++body) {
    const int part = connected_.of_body(body);
    const double L = lengths_[part], V = speeds_[part];
    const Eigen::Index v = v_of(body);
    if (!(V > 0.0)) continue;
    out[part] = std::max({out[part], way.segment<3>(v).norm() / L, way.segment<3>(v + 3).norm(),
                          velocity.segment<3>(v).norm() / V, velocity.segment<3>(v + 3).norm() * L / V});
  }
  return out;
}

bool LinearizedMotion::is_some(const VectorXd& size) { return size.maxCoeff() > least && size.allFinite(); }

/// The state, moved along by so much.
VectorXd LinearizedMotion::moved(const VectorXd& way, const VectorXd& velocity, double by) const {
  VectorXd y = here_.state.y;
  for (int body = 0; body < system_.body_count(); ++body) {
    y.segment<3>(r_of(body)) += by * way.segment<3>(v_of(body));
    const Vec3<double> half = 0.5 * by * way.segment<3>(v_of(body) + 3);
    y.segment<4>(r_of(body) + 3) +=
        quaternion_product<double>({0.0, half[0], half[1], half[2]}, here_.state.y.segment<4>(r_of(body) + 3));
  }
  system_.normalize(y.head(system_.q_size()));
  y.segment(system_.q_size(), system_.v_size()) += by * velocity;
  return y;
}

/// What of `twist` the joints allow: nearest in the metric of the masses, so that D x = b.
VectorXd LinearizedMotion::allowed(const VectorXd& twist, const VectorXd& b) {
  VectorXd momenta(system_.v_size()), out(system_.v_size());
  system_.multiply_mass(dynamics_.evaluation(), twist, momenta);
  dynamics_.solve(momenta, b, out, lambda_);
  return out;
}

void LinearizedMotion::turn(VectorXd& twist) const {
  for (int body = 0; body < system_.body_count(); ++body) {
    const auto rotation = twist.segment<3>(v_of(body) + 3);
    twist.segment<3>(v_of(body) + 3) =
        (rotation_matrix<double>(here_.state.y.segment<4>(r_of(body) + 3)) * rotation).eval();
  }
}

std::optional<Perturbation> LinearizedMotion::error(const StepDifference& step) {
  const Eigen::Index q_size = system_.q_size(), v_size = system_.v_size();
  Perturbation it;
  it.way.resize(v_size);
  it.velocity = step.run.segment(q_size, v_size) - step.exact.segment(q_size, v_size);
  for (int body = 0; body < system_.body_count(); ++body) {
    it.way.segment<3>(v_of(body)) = step.run.segment<3>(r_of(body)) - step.exact.segment<3>(r_of(body));
    it.way.segment<3>(v_of(body) + 3) =
        StateDifference::turn(step.run.segment<4>(r_of(body) + 3), step.exact.segment<4>(r_of(body) + 3));
  }
  const VectorXd whole = size(it);
  take_violations_back(it);
  it.first = size(it);
  if (!is_some(it.first)) return {};
  it.first = it.first.cwiseMax(of_whole * whole);
  it.energy = energies(it);
  if (evaluations_ > most_ || !find_acceleration(it)) return {};
  return it;
}

/// Of the error, which stabilization does. Rows of velocities alone, of wheels that roll, say nothing of poses.
void LinearizedMotion::take_violations_back(Perturbation& it) {
  if (system_.row_count() == 0) return turn(it.way);
  evaluations_ += 3;
  dynamics_.evaluate(here_.state.t, here_.state.y);
  const VectorXd rates = dynamics_.evaluation().Phi_dot;
  if (holonomic_) it.way = allowed(it.way, VectorXd::Zero(system_.row_count()));
  turn(it.way);
  const double by = small / std::max(size(it.way, it.velocity).maxCoeff(), least);
  dynamics_.evaluate(here_.state.t, moved(it.way, VectorXd::Zero(system_.v_size()), by));
  const VectorXd b = (rates - dynamics_.evaluation().Phi_dot) / by;
  dynamics_.evaluate(here_.state.t, here_.state.y);
  it.velocity = allowed(it.velocity, b);
}

bool LinearizedMotion::find_acceleration(Perturbation& it) {
  by_ = small / size(it.way, it.velocity).maxCoeff();
  const auto look = [&] { return accelerate(moved(it.way, it.velocity, by_), other_v_dot_); };
  if (!look()) return false;
  if (!on_its_side(dynamics_.evaluation().switches)) {
    by_ = -by_;
    if (!look()) return false;
  }
  it.acceleration = (other_v_dot_ - here_.state.v_dot) / by_;
  if (!on_its_side(here_.switches)) {  // where steps end at a touch they are next to it, on either side
    const VectorXd nearer = other_v_dot_;
    by_ *= 2.0;
    if (!look()) return false;
    it.acceleration = (other_v_dot_ - nearer) / (0.5 * by_);
  }
  const double a = weighed(it.acceleration), v = weighed(it.velocity), x = weighed(it.way);
  const double rate = a > 0.0 ? a / std::sqrt(v * v + a * x) : 0.0;
  it.rate = std::max(rate, forgotten * it.rate);
  return true;
}

void LinearizedMotion::take_back(Perturbation& it) {
  if (system_.row_count() > 0) go_back_to_constraints(it);
  go_back_to_energies(it);
}

/// What steps of this length leave of the equations of the joints, which else grows with the square of time.
void LinearizedMotion::go_back_to_constraints(Perturbation& it) {
  const VectorXd violations = (here_.violations - dynamics_.evaluation().Phi) / by_;
  const VectorXd rates = (here_.rates - dynamics_.evaluation().Phi_dot) / by_;
  const VectorXd none = VectorXd::Zero(system_.v_size());
  VectorXd x(system_.v_size());
  dynamics_.solve(none, violations, x, lambda_);
  turn(x);
  it.way += x;
  dynamics_.solve(none, rates, x, lambda_);
  it.velocity += x;
}

/// By which the error changes those of the parts, to the first order: g has the torque - omega x J omega, which does
/// no work.
VectorXd LinearizedMotion::energies(const Perturbation& it) const {
  VectorXd out = VectorXd::Zero(lengths_.size());
  for (int body = 0; body < system_.body_count(); ++body)
    out[connected_.of_body(body)] += energy(body, it.way, it.velocity);
  return out;
}

double LinearizedMotion::energy(int body, const VectorXd& way, const VectorXd& velocity) const {
  const Eigen::Index v = v_of(body), q = r_of(body) + 3;
  const Vec3<double> omega = here_.state.y.segment<3>(system_.q_size() + v + 3), spin = system_.inertia(body) * omega;
  const Vec3<double> torque =
      rotation_matrix<double>(here_.state.y.segment<4>(q)) * (here_.forces.segment<3>(v + 3) - spin.cross(omega));
  return system_.mass(body) * here_.state.y.segment<3>(system_.q_size() + v).dot(velocity.segment<3>(v)) +
         spin.dot(velocity.segment<3>(v + 3)) - here_.forces.segment<3>(v).dot(way.segment<3>(v)) -
         torque.dot(way.segment<3>(v + 3));
}

/// Where energy is a constant of the motion, so is what an error changes of it: else what steps of this length leave
/// would become a motion out of time, again at each slow passage. By velocities along the motion, where it is fast.
void LinearizedMotion::go_back_to_energies(Perturbation& it) {
  if (!conservative_) return;
  const VectorXd velocity = here_.state.y.segment(system_.q_size(), system_.v_size());
  const VectorXd none = VectorXd::Zero(system_.v_size()), apart = it.energy - energies(it);
  VectorXd change = VectorXd::Zero(lengths_.size());
  for (int body = 0; body < system_.body_count(); ++body)
    change[connected_.of_body(body)] += energy(body, none, velocity);
  most_change_ = most_change_.cwiseMax(change);
  for (int body = 0; body < system_.body_count(); ++body) {
    const int part = connected_.of_body(body);
    if (change[part] > fast * most_change_[part])
      it.velocity.segment<6>(v_of(body)) += apart[part] / change[part] * velocity.segment<6>(v_of(body));
  }
}

double LinearizedMotion::weighed(const VectorXd& x) const {
  double sum = 0.0;
  for (int body = 0; body < system_.body_count(); ++body) {
    const double L = lengths_[connected_.of_body(body)];
    sum += x.segment<3>(v_of(body)).squaredNorm() + L * L * x.segment<3>(v_of(body) + 3).squaredNorm();
  }
  return std::sqrt(sum);
}

}  // namespace linkwork
