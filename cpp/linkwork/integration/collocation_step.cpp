#include "linkwork/integration/collocation_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/integration/growing_multipliers.hpp"
#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr int most_sweeps = 40;
constexpr double converged = 1e-13, roundoff = 1e-7, shrinking = 0.5;
// From a pose that is left slowly the first nodes are near to it; what is made of it has to be fair.
constexpr double roundoff_departing = 1e-5;
constexpr int slow_from = 10, looked_back = 5;  // sweeps
constexpr double tolerance = 1e-10;             // of the energy over a step
constexpr double resolved = 1e-10;              // of velocities inside; at the end about the square of it counts
constexpr double end_part = 1e-2;               // of that, at most
constexpr double fair_tolerance = 1e-7;         // of all three, where nothing better is found
constexpr double fair_departing = 1e-5;         // the same where usual steps are worse
constexpr double of_projection = 4.0;           // energy of velocities that constraints correct, relative to these
constexpr double foreseen = 1e-9;               // of velocities that forces between the nodes give
constexpr double consistent = 1e-8;             // correction of the nodes: more, and the branches do not quite meet
constexpr double farthest_off = 1e-6;           // of a start that is not taken to the constraints, which the nodes are

// Positions of bodies far from the origin are known to their roundoff, blur. A node on the constraints is off its branch
// by blur / s, s the distance to the pose [rad], its velocities by blur / s^2 and its accelerations by blur / s^3. Forces
// of constraints, which all of this is, do no work: the motion is much less off than that.
constexpr double beside = 0.01;        // s of the nodes that are next to a pose
constexpr double not_resolved = 0.06;  // part of the accelerations of a node in the last of eight polynomials

constexpr double few_digits = 0.03;    // of the step: nodes that are nearer to a pose tell little of what is there
constexpr double nearest_pole = 1e-6;  // of the step: nearer to a pose nobody knows on which side of it a state is

double of_positions(double blur) { return blur / beside; }
double of_velocities(double blur) { return blur / (beside * beside); }
double of_accelerations(double blur) { return blur / (beside * beside * beside); }

/// Whether the sweeps that are left do not suffice at the rate of the last ones: in large mechanisms each is long.
bool hopeless(const double (&changes)[most_sweeps], int sweep, double noise) {
  if (sweep < slow_from) return false;
  const double rate = changes[sweep] / changes[sweep - looked_back];
  const double left = static_cast<double>(most_sweeps - sweep) / looked_back;
  return elementary::logarithm(changes[sweep] / noise) + left * elementary::logarithm(rate) > 0.0;
}

}  // namespace

bool CollocationStep::Quality::good() const {
  return converged && correction <= std::max(consistent, of_positions(blur)) &&
         resolution <= std::max(resolved, not_resolved * of_accelerations(blur)) && energy <= tolerance &&
         unseen <= std::max(foreseen, of_velocities(blur));
}

bool CollocationStep::Quality::fair() const {
  const double projected = off > 0.0 ? of_projection * jump : 0.0;
  const double blurred = not_resolved * of_accelerations(blur), tolerated = departs ? fair_departing : fair_tolerance;
  return converged && correction <= std::max({consistent, 2.0 * off, of_positions(blur)}) &&
         resolution <= std::max(tolerated, blurred) &&
         std::max(energy, unseen) <= std::max({tolerated, projected, of_velocities(blur)});
}

double CollocationStep::Quality::error() const { return std::max({end_part * resolution, energy, unseen, roundoff}); }

double CollocationStep::rate(int body, const ConstVector& velocities) const {
  const auto axis = rotors_.col(body);
  const Vec3<double> omega = velocities.segment<3>(6 * body + 3);
  return std::max(velocities.segment<3>(6 * body).norm() / length_, (omega - axis * axis.dot(omega)).norm());
}

double CollocationStep::size(const ConstVector& velocities) const {
  double largest = 0.0;
  for (int body = 0; body < dynamics_.system().body_count(); ++body)
    largest = std::max(largest, rate(body, velocities));
  return largest;
}

void CollocationStep::begin_in_pose(double t, const VectorXd& y, double off, const VectorXd& v_dot) {
  allocate(t, y);
  off_ = off;
  note_energy(y);
  dynamics_.rates(rates_before_);
  departs_ = off == 0.0;
  if (v_dot.size() > 0) rates_before_.segment(dynamics_.system().q_size(), v_dot.size()) = v_dot;
  step_.axes.see_rates(0.0, step_.y, rates_before_);
  v_dot_before_ = rates_before_.segment(dynamics_.system().q_size(), v_dot_.size());
}

void CollocationStep::allocate(double t, const VectorXd& y) {
  start_.reset();
  departs_ = false;
  const System& system = dynamics_.system();
  blur_ = std::numeric_limits<double>::epsilon() * farthest_position(system, y.head(system.q_size()));
  const SpinningAxes axes = SpinningAxes::at_start(rotors_, y.segment(system.q_size(), system.v_size()));
  step_ = {t, 0.0, 0.0, y, {}, axes, MatrixXd(y.size(), stages), MatrixXd::Zero(system.row_count(), stages)};
  v_dot_.resize(system.v_size());
  g_.resize(system.v_size(), stages);
  for (VectorXd* rates : {&rates_, &rates_before_}) rates->resize(y.size());
}

bool CollocationStep::begin(double t, const VectorXd& y, bool on_constraints) {
  allocate(t, y);
  VectorXd projected = y;
  if (!can_project(t, projected) && on_constraints) return false;
  off_ = on_constraints ? 0.0 : std::min(displacement(y, projected), farthest_off);
  if (on_constraints) step_.y = std::move(projected);
  const System& system = dynamics_.system();
  step_.axes = SpinningAxes::at_start(rotors_, step_.y.segment(system.q_size(), system.v_size()));
  dynamics_.evaluate(t, step_.y);
  note_energy(step_.y);
  Forces forces{VectorXd(v_dot_.size()), VectorXd(system.row_count())};
  dynamics_.refined_accelerations(forces.v_dot, forces.lambda);
  dynamics_.rates(forces.v_dot, forces.lambda, rates_before_);
  step_.axes.see_rates(0.0, step_.y, rates_before_);
  v_dot_before_ = rates_before_.segment(system.q_size(), v_dot_.size());
  if (on_constraints) start_ = std::move(forces);
  return true;
}

void CollocationStep::project(double t, VectorXd& y) {
  dynamics_.evaluate(t, y);
  projection_.positions(t, y);
  projection_.velocities(t, y);
}

/// Not in a singular pose, nor too near to it, nor far from the constraints.
bool CollocationStep::can_project(double t, VectorXd& y) {
  try {
    project(t, y);
  } catch (const NotConvergedError&) {
    return false;
  } catch (const SingularSystemError&) {
    return false;
  }
  return true;
}

CollocationStep::Quality CollocationStep::attempt(double h, int left_out) {
  Quality quality;
  left_out_ = left_out;
  step_.h = step_.followed = h;
  guess();
  try {
    quality.converged = iterate();
    if (quality.converged) finish(quality);
  } catch (const OptionError&) {
    throw;
  } catch (const Error&) {
    return {};
  }
  return quality;
}

/// Rates to begin with. A node that is nearer to a pose than to the branch would be taken to another one: where the
/// velocities in the pose are slow, accelerations tell where the nodes are.
void CollocationStep::guess() {
  step_.k = rates_before_.replicate(1, stages);
  least_speed_ = fastest_ = 0.0;
  if (!departs_ || !step_.axes.Omega.isZero(0.0)) return;
  const System& system = dynamics_.system();
  const VectorXd v = step_.y.segment(system.q_size(), system.v_size());
  least_speed_ = size(v + step_.h * v_dot_before_);
  for (int i = 0; i < stages; ++i) {
    const double time = gauss_.c[i] * step_.h;
    y_ = step_.y;
    displace(system, time * v + 0.5 * time * time * v_dot_before_, y_);
    system.position_rates(y_.head(system.q_size()), v + time * v_dot_before_, step_.k.col(i).head(system.q_size()));
  }
}

double CollocationStep::way(double from, double to) const {
  const System& system = dynamics_.system();
  return std::abs(to - from) *
         size(step_.y.segment(system.q_size(), system.v_size()) + 0.5 * (from + to) * v_dot_before_);
}

double CollocationStep::growth_to(double time) {
  if (!step_.axes.Omega.isZero(0.0)) return 0.0;
  const System& system = dynamics_.system();
  const VectorXd way = time * step_.y.segment(system.q_size(), system.v_size()) + 0.5 * time * time * v_dot_before_;
  y_ = step_.y;
  displace(system, way, y_);
  y_.segment(system.q_size(), system.v_size()) += time * v_dot_before_;
  if (!can_project(step_.t + time, y_)) return 0.0;
  dynamics_.evaluate(step_.t + time, y_);
  VectorXd lambda(system.row_count());
  dynamics_.refined_accelerations(v_dot_, lambda);
  return std::sqrt(size(v_dot_ - v_dot_before_) / size(way));
}

/// Fixed-point iteration, node after node: it converges like (h L)^k / k!.
bool CollocationStep::iterate() {
  const double noise = std::max(departs_ ? roundoff_departing : roundoff, of_accelerations(blur_));
  double last = INFINITY, changes[most_sweeps];
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0.0;
    correction_ = jump_ = 0.0;
    for (int i = 0; i < stages; ++i) change = std::max(change, i == left_out_ ? extrapolated_node(i) : node(i));
    if (!std::isfinite(change)) return false;
    if (departs_) least_speed_ = std::exchange(fastest_, 0.0);
    if (change <= converged || (change <= noise && change > shrinking * last)) return true;
    if (sweep > 3 && change > 2.0 * last) return change <= noise;
    changes[sweep] = last = change;
    if (hopeless(changes, sweep, noise)) return false;
  }
  return false;
}

/// Of the body that is moved most [rad, or relative to the length].
double CollocationStep::displacement(const VectorXd& from, const VectorXd& to) const {
  double largest = 0.0;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const double shift = (to.segment<3>(7 * body) - from.segment<3>(7 * body)).norm() / length_;
    const double turn = 2.0 * (to.segment<4>(7 * body + 3) - from.segment<4>(7 * body + 3)).norm();
    largest = std::max({largest, shift, turn});
  }
  return largest;
}

/// k_i at the state that the polynomials give, on the constraints; how much it changed, as a velocity relative to all.
double CollocationStep::node(int i) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  const double time = gauss_.c[i] * step_.h, t = step_.t + time;
  y_ = step_.y;
  y_.noalias() += step_.h * (step_.k * gauss_.A.row(i).transpose());
  system.normalize(y_.head(nq));
  step_.axes.carry(time, y_);
  rates_ = y_;
  project(t, y_);
  correction_ = std::max(correction_, displacement(rates_, y_));
  const double speed = size(y_.segment(nq, nv)), before = size(rates_.segment(nq, nv));
  if (before > 0.0) jump_ = std::max(jump_, size(y_.segment(nq, nv) - rates_.segment(nq, nv)) / before);
  fastest_ = std::max(fastest_, speed);
  dynamics_.evaluate(t, y_);
  g_.col(i) = dynamics_.evaluation().g.head(nv);
  step_.axes.see_forces(time, g_.col(i));
  dynamics_.refined_accelerations(v_dot_, step_.lambda.col(i));
  dynamics_.rates(v_dot_, step_.lambda.col(i), rates_);
  step_.axes.see_rates(time, y_, rates_);
  return changed(i, speed);
}

double CollocationStep::extrapolated_node(int i) {
  const System& system = dynamics_.system();
  const GaussCollocation::Weights weights = gauss_.from_others(i);
  rates_ = step_.k * weights;
  step_.lambda.col(i) = step_.lambda * weights;
  g_.col(i) = g_ * weights;
  return changed(i, size(step_.y.segment(system.q_size(), system.v_size())));
}

/// Takes the rates at a node; how much they changed, as velocities relative to a speed.
double CollocationStep::changed(int i, double speed) {
  const System& system = dynamics_.system();
  speed = std::max(speed, least_speed_);
  const auto of_velocities = [&](const auto& rates) { return rates.segment(system.q_size(), system.v_size()); };
  const double change = step_.h * size(of_velocities(rates_) - of_velocities(step_.k.col(i)));
  step_.k.col(i) = rates_;
  return speed > 0.0 ? change / speed : change;
}

double CollocationStep::kinetic_energy(const VectorXd& y) const {
  const System& system = dynamics_.system();
  return system.kinetic_energy(dynamics_.evaluation(), y.segment(system.q_size(), system.v_size()));
}

double CollocationStep::energy(const VectorXd& y) const {
  return kinetic_energy(y) + dynamics_.evaluation().potential - y[y.size() - 1];
}

void CollocationStep::note_energy(const VectorXd& y) {
  energy_before_ = energy(y);
  kinetic_before_ = kinetic_energy(y);
}

void CollocationStep::finish(Quality& quality) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  const VectorXd rest = step_.k * (left_out_ == none ? gauss_.last_coefficient() : gauss_.last_but_one());
  state_at(step_.h, step_.y_new);
  const auto v = step_.y.segment(nq, nv), v_new = step_.y_new.segment(nq, nv);
  quality.departs = departs_;
  quality.correction = correction_;
  quality.off = off_;
  quality.blur = blur_;
  quality.jump = jump_;
  quality.resolution = step_.h * size(rest.segment(nq, nv)) / (2.0 * stages * std::max(size(v), size(v_new)));
  rates_ = step_.y_new;
  if (can_project(step_.end(), rates_)) step_.y_new = rates_;
  note_missing_energy(quality);
}

double CollocationStep::unseen(double interval) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  Evaluation start = system.make_evaluation();  // with the rows that repeat others
  system.evaluate_constraints(step_.t, step_.y.head(nq), step_.y.segment(nq, nv), dynamics_.history(), start);
  const VectorXd lengths = row_lengths(system, start);
  VectorXd rest(nv);
  double sum = 0.0, violation = 0.0;
  const int count = static_cast<int>(step_.h / interval);
  for (int k = 1; k <= count; ++k) {
    const double time = k * interval;
    state_at(time, y_);
    dynamics_.evaluate(step_.t + time, y_);
    rest = dynamics_.evaluation().g.head(nv);
    step_.axes.see_forces(time, rest);
    rest -= g_ * gauss_.values(time / step_.h);
    system.multiply_inverse_mass(rest, v_dot_);
    sum += size(v_dot_);
    violation = std::max(violation, dynamics_.evaluation().Phi_dot.cwiseQuotient(lengths).cwiseAbs().maxCoeff());
  }
  const double speed = std::max(size(step_.y.segment(nq, nv)), size(step_.y_new.segment(nq, nv)));
  return std::max(interval * sum, violation) / speed;
}

void CollocationStep::end_as_it_is(Quality& quality) {
  state_at(step_.h, step_.y_new);
  note_missing_energy(quality);
}

void CollocationStep::note_missing_energy(Quality& quality) {
  dynamics_.evaluate(step_.end(), step_.y_new);
  const double kinetic = std::max(kinetic_before_, kinetic_energy(step_.y_new));
  quality.energy = std::abs(energy(step_.y_new) - energy_before_) / kinetic;
}

void CollocationStep::state_at(double time, VectorXd& y) const {
  const System& system = dynamics_.system();
  y = step_.y;
  y.noalias() += step_.h * (step_.k * gauss_.integrals(time / step_.h));
  system.normalize(y.head(system.q_size()));
  step_.axes.carry(time, y);
}

void CollocationStep::accelerations_at(double time, MutableVector v_dot, MutableVector lambda) const {
  const System& system = dynamics_.system();
  v_dot = (step_.k * gauss_.values(time / step_.h)).segment(system.q_size(), system.v_size());
  lambda = multipliers_at(time);
  if (step_.axes.Omega.isZero(0.0)) return;
  VectorXd y;
  state_at(time, y);
  step_.axes.carry_accelerations(time, y, v_dot);
  hold_rotors(time, y, v_dot, lambda);
}

VectorXd CollocationStep::multipliers_at(double time) const {
  std::vector<double> places, poses;
  std::vector<VectorXd> multipliers;
  for (const double pose : step_.poses) poses.push_back(pose / step_.h);
  for (const int node : nodes_beside_poses()) {
    places.push_back(gauss_.c[node]);
    multipliers.emplace_back(step_.lambda.col(node));
  }
  if (auto found = growing_multipliers(places, multipliers, poses, nearest_pole, time / step_.h)) return *found;
  return step_.lambda * gauss_.values(time / step_.h);
}

/// Those that are not so near to a pose that they tell little of how multipliers grow there; the nearest first.
std::vector<int> CollocationStep::nodes_beside_poses() const {
  const auto distance = [&](int node) {
    double least = INFINITY;
    for (const double pose : step_.poses) least = std::min(least, std::abs(gauss_.c[node] - pose / step_.h));
    return least;
  };
  std::vector<int> nodes;
  for (int node = 0; node < stages; ++node)
    if (distance(node) >= few_digits) nodes.push_back(node);
  std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) { return distance(a) < distance(b); });
  return nodes;
}

/// Equations of hinges along axes of a rotor turn with it: their multipliers are none that the polynomials know.
void CollocationStep::hold_rotors(double time, const VectorXd& y, const VectorXd& v_dot, MutableVector lambda) const {
  const System& system = dynamics_.system();
  Evaluation at = system.make_evaluation();
  system.evaluate(step_.t + time, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()),
                  dynamics_.history(), at);
  for (int body = 0; body < system.body_count(); ++body)
    if (!step_.axes.Omega.col(body).isZero(0.0)) hold_rotor(system, at, body, v_dot, lambda);
}

}  // namespace linkwork
