#include "linkwork/integration/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/loop_core.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double reach = 0.2;           // of a leap [rad]: what the fastest body of the loops turns
constexpr double fastest = 0.8;         // the same for any body
constexpr double least_part = 0.1;      // of that, for leaps over a motion that varies more
constexpr double near = 0.3;            // of the usual root of the smallest pivot: farther, nothing is due
constexpr double steps_before = 4.0;    // so many steps before the pose a usual step is no longer taken
constexpr double margin = 0.06;         // least distance of nodes from the pose, relative to the leap
constexpr double falling = 0.3;         // part of the root of a pivot that is left where a pose is foreseen
constexpr int most_sweeps = 40, most_attempts = 8;
constexpr double converged = 1e-13, roundoff = 1e-9, shrinking = 0.5;
constexpr double at_pose = 0.03;        // root of the pivot in the pose, part of that at the nodes around it
constexpr double tolerance = 1e-10;     // of what a leap leaves unresolved, and of its energy
constexpr double fair_tolerance = 1e-7; // where nothing better is found
constexpr double consistent = 1e-8;     // correction of the nodes: more, and the branches do not quite meet

}  // namespace

bool Crossing::Quality::good() const {
  return converged && correction <= consistent && resolution <= tolerance && energy <= tolerance;
}

bool Crossing::Quality::fair() const {
  return converged && correction <= consistent && resolution <= fair_tolerance && energy <= fair_tolerance;
}

double Crossing::Quality::badness() const { return std::max(resolution, energy); }

Crossing::Crossing(Dynamics& dynamics) : dynamics_(dynamics), projection_(dynamics) {
  const System& system = dynamics.system();
  if (!dynamics.watches()) return;
  const LoopCore core(system, dynamics.evaluation(), 1e-9);
  in_loops_.resize(static_cast<std::size_t>(system.body_count()));
  bool any = false;
  for (int body = 0; body < system.body_count(); ++body) {
    in_loops_[static_cast<std::size_t>(body)] = core.component_of_body(body) >= 0;
    any = any || core.component_of_body(body) >= 0;
  }
  if (!any) return;
  double arm = 0.0;
  for (const Element& joint : system.model().joints()) {
    if (joint.i != ground) arm = std::max(arm, joint.at.s_i.norm());
    if (joint.j != ground) arm = std::max(arm, joint.at.s_j.norm());
  }
  if (arm > 0.0) length_ = arm;
  prepared_ = true;
}

double Crossing::size(const ConstVector& velocities) const {
  double largest = 0.0;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const auto v = velocities.segment<6>(6 * body);
    largest = std::max({largest, v.head<3>().norm() / length_, v.tail<3>().norm()});
  }
  return largest;
}

/// Time until the pose by the trend of the pivots, infinite where they do not fall.
double Crossing::foreseen(double t) const {
  const auto trend = dynamics_.watch().trend();
  if (!trend || trend->last.root > near * dynamics_.watch().root_of_level()) return INFINITY;
  const double rate = (trend->last.root - trend->other.root) / (trend->last.t - trend->other.t);
  if (!(rate * (trend->last.t - trend->other.t) < 0.0)) return INFINITY;
  return trend->last.t + trend->last.root / std::abs(rate) - t;
}

/// Time in which the mechanism moves by `reach`.
double Crossing::longest(const VectorXd& y) const {
  const System& system = dynamics_.system();
  double loops = 0.0, all = 0.0;
  for (int body = 0; body < system.body_count(); ++body) {
    const auto v = y.segment<6>(system.q_size() + 6 * body);
    const double rate = std::max(v.head<3>().norm() / length_, v.tail<3>().norm());
    all = std::max(all, rate);
    if (in_loops_[static_cast<std::size_t>(body)]) loops = std::max(loops, rate);
  }
  return std::min(reach / loops, fastest / all);
}

bool Crossing::due(double t, double h, const VectorXd& y) {
  if (!prepared_) return false;
  const double tau = foreseen(t);
  if (!(tau < INFINITY)) return false;
  const double root = dynamics_.watch().trend()->last.root;
  if (declined_ > 0.0 && root > 0.5 * declined_ && root < 2.0 * declined_) return false;
  declined_ = 0.0;
  if (!(tau < std::max(0.5 * longest(y), steps_before * h) + h) || tau < -h) return false;
  dynamics_.watch_evaluations(false);
  bool found = false;
  try {
    found = falls_at(t, tau, y);
  } catch (const OptionError&) {
    dynamics_.watch_evaluations(true);
    throw;
  } catch (const Error&) {
    found = true;  // the matrix is singular there
  }
  dynamics_.watch_evaluations(true);
  if (found) return true;
  declined_ = root;
  dynamics_.evaluate(t, y);
  return false;
}

/// Whether the pivot is smaller where the pose is foreseen.
bool Crossing::falls_at(double t, double tau, const VectorXd& y) {
  const double root = dynamics_.watch().trend()->last.root;
  rates_.resize(y.size());
  dynamics_.rates(rates_);
  y_ = y + tau * rates_;
  const int nq = dynamics_.system().q_size(), nv = dynamics_.system().v_size();
  VectorXd bend(nq);
  dynamics_.system().position_rates(y.head(nq), rates_.segment(nq, nv), bend);
  y_.head(nq) += 0.5 * tau * tau * bend;
  dynamics_.evaluate(t + tau, y_);
  dynamics_.factorize();
  return dynamics_.root_of_pivot() < falling * root;
}

/// The length among the allowed ones with which the nodes stay farthest from the pose; of equals the shortest.
double Crossing::best_length(double pose, double grid, double least, double most) const {
  double best = 0.0, distance = -1.0;
  const auto consider = [&](double h) {
    double nearest = 1.0;
    for (const double c : gauss_.c) nearest = std::min(nearest, std::abs(c - pose / h));
    if (nearest > distance + 1e-3) {
      best = h;
      distance = nearest;
    }
  };
  if (most <= least) return most;
  if (grid > 0.0) {
    const double first = std::max(1.0, std::ceil(least / grid)), last = std::max(first, std::ceil(2.0 * least / grid));
    const double by = std::max(1.0, std::floor((last - first) / 40.0));
    for (double k = first; k <= last; k += by) consider(std::min(k * grid, most));
  } else {
    for (double factor = 1.0; factor <= 2.0; factor += 0.025) consider(std::min(factor * least, most));
  }
  return best;
}

bool Crossing::leap(double t, double h, double grid, double most, const VectorXd& y) {
  dynamics_.watch_evaluations(false);
  bool done = false;
  const auto attempted = [&](double length) {
    try {
      return attempt(t, length, y);
    } catch (const OptionError&) {
      dynamics_.watch_evaluations(true);
      throw;
    } catch (const Error&) {
      return Quality{};
    }
  };
  double pose = foreseen(t), least = std::max({longest(y), 2.0 * pose, h});
  Leap best;
  double badness = INFINITY;
  GaussCollocation::Weights root;
  for (int k = 0; k < most_attempts && !done; ++k) {
    const double length = best_length(pose, grid, least, most);
    const Quality quality = attempted(length);
    done = quality.good();
    if (quality.converged) {
      pose = place_of_pose() * length;
      double nearest = 1.0;
      for (const double c : gauss_.c) nearest = std::min(nearest, std::abs(c - pose / length));
      done = done && nearest >= margin;
    }
    if (done || (quality.fair() && quality.badness() < badness)) {
      best = leap_;
      root = root_;
      badness = quality.badness();
    }
    if (done) break;
    if (!quality.good()) least = std::max(least * 0.6, least_part * longest(y));
  }
  dynamics_.watch_evaluations(true);
  if (badness == INFINITY) {
    declined_ = dynamics_.watch().trend()->last.root;
    return false;
  }
  leap_ = std::move(best);
  root_ = root;
  dynamics_.forget_trend();
  report();
  return true;
}

Crossing::Quality Crossing::attempt(double t, double h, const VectorXd& y) {
  const System& system = dynamics_.system();
  leap_ = {t, h, y, {}, MatrixXd(y.size(), stages), MatrixXd::Zero(system.row_count(), stages)};
  dynamics_.evaluate(t, leap_.y);
  projection_.positions(t, leap_.y);
  projection_.velocities(t, leap_.y);
  dynamics_.evaluate(t, leap_.y);
  energy_before_ = energy(leap_.y);
  v_dot_.resize(system.v_size());
  rates_.resize(y.size());
  VectorXd lambda(system.row_count());
  dynamics_.refined_accelerations(v_dot_, lambda);
  dynamics_.rates(v_dot_, lambda, rates_);
  leap_.k = rates_.replicate(1, stages);
  Quality quality;
  quality.converged = iterate();
  if (quality.converged) finish(quality);
  return quality;
}

/// Fixed-point iteration, node after node: it converges like (h L)^k / k!.
bool Crossing::iterate() {
  double last = INFINITY;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double change = 0.0;
    correction_ = 0.0;
    for (int i = 0; i < stages; ++i) change = std::max(change, node(i));
    if (!std::isfinite(change)) return false;
    if (change <= converged || (change <= roundoff && change > shrinking * last)) return true;
    if (sweep > 3 && change > 2.0 * last) return false;
    last = change;
  }
  return false;
}

/// k_i at the state that the polynomials give, on the constraints; how much it changed, as a velocity relative to all.
double Crossing::node(int i) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  const double t = leap_.t + gauss_.c[i] * leap_.h;
  y_ = leap_.y;
  y_.noalias() += leap_.h * (leap_.k * gauss_.A.row(i).transpose());
  system.normalize(y_.head(nq));
  rates_ = y_;
  dynamics_.evaluate(t, y_);
  projection_.positions(t, y_);
  projection_.velocities(t, y_);
  for (int body = 0; body < system.body_count(); ++body) {
    const double shift = (y_.segment<3>(7 * body) - rates_.segment<3>(7 * body)).norm() / length_;
    const double turn = 2.0 * (y_.segment<4>(7 * body + 3) - rates_.segment<4>(7 * body + 3)).norm();
    correction_ = std::max({correction_, shift, turn});
  }
  dynamics_.evaluate(t, y_);
  dynamics_.refined_accelerations(v_dot_, leap_.lambda.col(i));
  root_[i] = dynamics_.root_of_pivot();
  dynamics_.rates(v_dot_, leap_.lambda.col(i), rates_);
  const double change = leap_.h * size(rates_.segment(nq, nv) - leap_.k.col(i).segment(nq, nv));
  leap_.k.col(i) = rates_;
  const double speed = size(y_.segment(nq, nv));
  return speed > 0.0 ? change / speed : change;
}

double Crossing::energy(const VectorXd& y) const {
  const System& system = dynamics_.system();
  return system.kinetic_energy(y.segment(system.q_size(), system.v_size())) + dynamics_.evaluation().potential -
         y[y.size() - 1];
}

void Crossing::finish(Quality& quality) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  leap_.y_new = leap_.y + leap_.h * (leap_.k * gauss_.b);
  system.normalize(leap_.y_new.head(nq));
  dynamics_.evaluate(leap_.end(), leap_.y_new);
  projection_.positions(leap_.end(), leap_.y_new);
  projection_.velocities(leap_.end(), leap_.y_new);
  dynamics_.evaluate(leap_.end(), leap_.y_new);
  const VectorXd rest = leap_.k * gauss_.last_coefficient();
  const double speed = std::max(size(leap_.y.segment(nq, nv)), size(leap_.y_new.segment(nq, nv)));
  const double kinetic = std::max(system.kinetic_energy(leap_.y.segment(nq, nv)),
                                  system.kinetic_energy(leap_.y_new.segment(nq, nv)));
  quality.correction = correction_;
  quality.resolution = leap_.h * size(rest.segment(nq, nv)) / (2.0 * stages * speed);
  quality.energy = std::abs(energy(leap_.y_new) - energy_before_) / kinetic;
}

/// Where the roots of the pivots, with the sign of the side, pass through zero, relative to the leap: between the nodes
/// around the smallest of them.
double Crossing::place_of_pose() const {
  double place = 0.5, least = INFINITY;
  for (int i = 0; i + 1 < stages; ++i) {
    const double a = root_[i], b = root_[i + 1];
    const double slope = (a + b) / (gauss_.c[i + 1] - gauss_.c[i]);
    // The sides must continue what the neighbors show.
    double misfit = 0.0;
    if (i > 0) misfit += std::abs(root_[i - 1] - a - slope * (gauss_.c[i] - gauss_.c[i - 1]));
    if (i + 2 < stages) misfit += std::abs(root_[i + 2] - b - slope * (gauss_.c[i + 2] - gauss_.c[i + 1]));
    misfit /= (i > 0 && i + 2 < stages ? 2.0 : 1.0) * slope;
    if (misfit < least) {
      least = misfit;
      place = gauss_.c[i] + a / slope;
    }
  }
  return place;
}

/// Lists the pose where there was one.
bool Crossing::report() {
  const System& system = dynamics_.system();
  const double place = place_of_pose(), t = leap_.t + place * leap_.h;
  if (place < 0.0 || place > 1.0) return false;
  double root = root_.minCoeff();
  interpolate(t, y_);
  const double around = root;
  dynamics_.watch_evaluations(false);
  try {
    dynamics_.evaluate(t, y_);
    dynamics_.factorize();
    root = dynamics_.root_of_pivot();
  } catch (const SingularSystemError&) {
    root = 0.0;
  }
  dynamics_.watch_evaluations(true);
  return root <= at_pose * around && dynamics_.cross(t, y_.head(system.q_size()), root * root);
}

void Crossing::interpolate(double t, VectorXd& y) const {
  y = leap_.y;
  y.noalias() += leap_.h * (leap_.k * gauss_.integrals((t - leap_.t) / leap_.h));
  dynamics_.system().normalize(y.head(dynamics_.system().q_size()));
}

void Crossing::interpolate(double t, MutableVector v_dot, MutableVector lambda) const {
  const System& system = dynamics_.system();
  const GaussCollocation::Weights l = gauss_.values((t - leap_.t) / leap_.h);
  v_dot = (leap_.k * l).segment(system.q_size(), system.v_size());
  lambda = leap_.lambda * l;
}

}  // namespace linkwork
