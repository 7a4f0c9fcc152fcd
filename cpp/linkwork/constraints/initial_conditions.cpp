#include "linkwork/constraints/initial_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/constraints/rank.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

constexpr double exact = 1e-15, roundoff = 1e-12;  // violations, relative to the size of the mechanism
constexpr double by_digits = rank_tolerance;       // as much is left of equations that repeat others but for that
constexpr double least_damping = 1e-10, most_damping = 1e8;
constexpr double stationary = 1e-9;                            // part of the violation that a step should take away
constexpr double longest_step = 0.5;                           // relative to the extent of the mechanism, or rad
constexpr double sufficient_decrease = 1e-4;                   // part of the expected one (Armijo's condition)
constexpr double least_factor = 1e-3, less = 4.0, more = 8.0;  // of the damping against the violation
constexpr double least_delassus = 1e-2;                        // of a row of rotations, of its usual one
constexpr double nearest = 1e-11;                              // displacement that is none
constexpr double shortest_part = 1e-4;                         // of a step along the constraints
constexpr double nudge = 0.05;  // [rad, or relative to the length of a body], off a saddle
constexpr int most_descents = 300, most_approaches = 100, most_nudges = 4, most_refinements = 40;
constexpr double most_velocity_damping = 1e-8, least_velocity_damping = 1e-13, least_conjugate_damping = 1e-12;
constexpr int most_conjugate = 300, patience = 20;
constexpr std::size_t most_directions = 30;
constexpr double progress = 0.9, new_part = 1e-8;  // of residuals; of a direction, beside those before
constexpr double useful = 1e-3;                    // cosine of a direction and the residuals
constexpr double unresisted = 1e-11;               // residuals that a velocity makes, relative to it: roundoff of none
constexpr double most_growth = 1e6;  // of velocities near singular poses, that counts in the roundoff of residuals

double largest(const VectorXd& x) { return x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0.0; }

/// The longest side of the box around the centers of mass, or the longest length of a body.
double extent_of(const System& system, const VectorXd& lengths) {
  const VectorXd q = system.model().initial_q();
  const auto positions = q.reshaped(position_size, system.body_count()).topRows<3>();
  return std::max((positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).maxCoeff(), lengths.maxCoeff());
}

/// integral rho rho^T dm over a body, rho from the center of mass in body axes: tr(J)/2 I - J.
Mat3<double> second_moments(const System& system, int body) {
  const Mat3<double> J = system.inertia(body);
  return 0.5 * J.trace() * Mat3<double>::Identity() - J;
}

Mat3<double> orientation(const VectorXd& q, int body) {
  return rotation_matrix<double>(q.segment<4>(position_size * body + 3));
}

/// Largest displacement, relative to the extent of the mechanism, or [rad].
double size_of(const VectorXd& x, double extent) {
  double out = 0.0;
  for (Eigen::Index k = 0; k < x.size(); k += velocity_size)
    out = std::max({out, x.segment<3>(k).norm() / extent, x.segment<3>(k + 3).norm()});
  return out;
}

}  // namespace

InitialConditions::InitialConditions(const System& system, const VectorXd& weights, std::vector<int> held)
    : solver_(system, weights),
      held_(std::move(held)),
      at_(this->system().make_evaluation()),
      rest_(VectorXd::Zero(system.v_size())),
      x_(system.v_size()),
      lambda_(system.row_count()),
      lengths_(characteristic_lengths(system)),
      extent_(extent_of(system, lengths_)),
      rounding_(std::max(1.0, farthest_position(system, system.model().initial_q()))) {
  history_ = this->system().initial_history();
  this->system().evaluate_constraints(0.0, this->system().model().initial_q(), rest_, history_, at_);
  row_lengths_ = row_lengths(system, at_);
  delassus_ = this->system().delassus_diagonal(at_);
  const std::vector<char> rotations = rows_of_rotations(system, at_);
  VectorXd usual = VectorXd::Zero(system.row_count());  // of rows of rotations, which may have none in one pose only
  for (const ConstraintBlock& block : this->system().blocks())
    usual.segment(block.row, block.rows).array() += this->system().inverse_inertia(block.body).trace() / 3.0;
  for (int row = 0; row < system.row_count(); ++row) {
    if (rotations[row]) delassus_[row] = std::max(delassus_[row], least_delassus * usual[row]);
    if (!(delassus_[row] > 0.0)) delassus_[row] = 1.0;
  }
}

void InitialConditions::evaluate(const VectorXd& q, const VectorXd& v) {
  system().evaluate_constraints(0.0, q, v, history_, at_);
  history_ = at_.history;  // on the way to the constraints angles may turn far
  for (const int body : held_)
    for (const int place : system().body_blocks(body)) {
      const ConstraintBlock& block = system().blocks()[place];
      std::fill_n(at_.D.begin() + block.offset, 6 * block.rows, 0.0);
    }
}

/// M x - D^T lambda = a, D x + damping diag(w) lambda = b.
bool InitialConditions::solve(const VectorXd& a, const VectorXd& b, double damping) {
  ++iterations_;
  if (!solver_.factorize(at_, damping * delassus_)) return false;
  solver_.solve(a, b, x_, lambda_);
  return x_.allFinite() && lambda_.allFinite();
}

/// Largest, relative to the size of the mechanism and the roundoff of its positions.
double InitialConditions::relative(const VectorXd& residuals) const {
  return largest(residuals.cwiseQuotient(row_lengths_)) / rounding_;
}

/// Of residuals relative to roundoff: those far from the origin are no larger for digits that rank does not see.
double InitialConditions::nearly_met() const { return std::max(roundoff, by_digits / rounding_); }

double InitialConditions::merit() const { return (at_.Phi.array().square() / delassus_.array()).sum(); }

// Levenberg and Marquardt's method for min f = Phi^T W^-1 Phi, W the diagonal of the Delassus matrix:
//   dq = -M^-1 D^T (D M^-1 D^T + mu W)^-1 Phi,   Phi + D dq = -mu W lambda.
// Off the constraints, rows that repeat others are not quite dependent, and Newton's steps would follow the difference
// far away; mu = c |Phi| keeps the way short there, and leaves Newton's steps near the end (J. Fan, Y. Yuan, On the
// quadratic convergence of the Levenberg-Marquardt method, Computing 74, 2005).
bool InitialConditions::descend(VectorXd& q) {
  double c = 1.0, last = INFINITY;
  for (int k = 0; k < most_descents; ++k) {
    evaluate(q, rest_);
    const double now = relative(at_.Phi), f = merit();
    if (now <= exact || (now <= roundoff && now > 0.5 * last)) return true;
    last = now;
    for (;; c *= more) {
      const double mu = std::max(least_damping, c * now);
      if (mu > most_damping || !solve(rest_, -at_.Phi, mu)) return now <= nearly_met();
      const double expected = f - mu * mu * (lambda_.array().square() * delassus_.array()).sum();
      if (!(expected > stationary * f) && mu <= 1.0) return now <= nearly_met();
      const double size = size_of(x_, extent_), part = std::min(1.0, longest_step / std::max(size, longest_step));
      VectorXd next = q;
      displace(system(), part * x_, next);
      evaluate(next, rest_);
      if (merit() < f - sufficient_decrease * part * expected || now <= roundoff) {
        q = next;
        c = std::max(least_factor, c / less);
        break;
      }
      evaluate(q, rest_);
    }
  }
  return false;
}

double InitialConditions::distance(const VectorXd& given, const VectorXd& q) const {
  double sum = 0.0;
  for (int body = 0; body < system().body_count(); ++body) {
    const Mat3<double> change = orientation(q, body) - orientation(given, body);
    sum += system().mass(body) * (q.segment<3>(7 * body) - given.segment<3>(7 * body)).squaredNorm() +
           (change * second_moments(system(), body) * change.transpose()).trace();
  }
  return sum;
}

// Half the descent of the distance, along displacements: m (r_given - r), and with P = integral rho rho^T dm
//   integral rho x A^T (A_given rho) dm = vect(G),   G = A^T A_given P,   vect(G)_i = eps_ijk G_kj
VectorXd InitialConditions::pull(const VectorXd& given, const VectorXd& q) const {
  VectorXd out(system().v_size());
  for (int body = 0; body < system().body_count(); ++body) {
    const Mat3<double> G = orientation(q, body).transpose() * orientation(given, body) * second_moments(system(), body);
    out.segment<3>(6 * body) = system().mass(body) * (given.segment<3>(7 * body) - q.segment<3>(7 * body));
    out.segment<3>(6 * body + 3) = Vec3<double>(G(2, 1) - G(1, 2), G(0, 2) - G(2, 0), G(1, 0) - G(0, 1));
  }
  for (const int body : held_) out.segment<6>(6 * body).setZero();
  return out;
}

// Steps M x - D^T lambda = pull, D x = -Phi along the constraints, each followed by a way back to them, shorter where
// the pose would not come nearer.
void InitialConditions::approach(const VectorXd& given, VectorXd& q) {
  double part = 1.0, least = distance(given, q);
  for (int k = 0; k < most_approaches && part > shortest_part; ++k) {
    evaluate(q, rest_);
    if (!solve(pull(given, q), -at_.Phi, least_damping)) return;
    const double size = size_of(x_, extent_);
    if (size <= nearest) return;
    VectorXd next = q;
    displace(system(), std::min(part, longest_step / size) * x_, next);
    const double found = descend(next) ? distance(given, next) : INFINITY;
    if (found < least) {
      q = next;
      least = found;
      part = std::min(1.0, 2.0 * part);
    } else {
      part *= 0.25;
    }
  }
}

bool InitialConditions::positions(const VectorXd& given, VectorXd& q) {
  if (system().row_count() == 0) return true;
  VectorXd best = q;
  bool reached = descend(best);
  evaluate(best, rest_);
  double least = merit();
  std::mt19937_64 engine(1);
  for (int k = 0; k < most_nudges && !reached; ++k) {  // the way may have ended in a saddle, such as a half turn
    VectorXd next = best, random(system().v_size());
    for (double& x : random) x = nudge * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0);
    random.array() *= velocity_scale(system()).array();
    for (const int body : held_) random.segment<6>(6 * body).setZero();
    displace(system(), random, next);
    reached = descend(next);
    evaluate(next, rest_);
    if (merit() < least) {
      best = next;
      least = merit();
    }
    if (reached) best = next;
  }
  q = best;
  if (reached) approach(given, q);
  return reached;
}

/// Of velocities [1/s].
double InitialConditions::rate_of_motion(const VectorXd& v) const {
  double out = 0.0;
  for (int body = 0; body < system().body_count(); ++body)
    out = std::max({out, v.segment<3>(6 * body).norm() / lengths_[body], v.segment<3>(6 * body + 3).norm()});
  return out;
}

/// Of velocities and drivers [1/s].
double InitialConditions::rate(const VectorXd& v) const {
  return std::max(rate_of_motion(v), largest(at_.Phi_t.cwiseQuotient(row_lengths_)));
}

// dv = -M^-1 D^T (D M^-1 D^T + mu W)^-1 (D v + Phi_t), again for what mu left; long chains need a smaller one.
bool InitialConditions::velocities(const VectorXd& q, VectorXd& v) {
  if (system().row_count() == 0) return true;
  evaluate(q, v);
  const double given = rate(v);
  VectorXd found = v;
  double least = INFINITY, mu = most_velocity_damping;
  for (int k = 0; k < most_refinements; ++k) {
    evaluate(q, found);
    const double now = given > 0.0 ? relative(at_.Phi_dot) / given : 0.0;
    const bool shrinking = now < 0.5 * least;
    if (now < least) {
      v = found;
      least = now;
    }
    if (now <= exact || (!shrinking && is_roundoff(now, found, given))) break;
    if (!shrinking && (mu *= 0.01) < least_velocity_damping) break;
    if (!solve(rest_, -at_.Phi_dot, mu)) break;
    found += x_;
  }
  return is_roundoff(least, v, given) || conjugate_velocities(q, v, given, least);
}

// Residuals are relative to the rate of what is given: were it that of v, velocities that diverge, as they do where
// joints contradict each other, would make roundoff of whatever is left. Near singular poses velocities are large
// indeed, and so is their roundoff: as much as that counts, and never a part of what is given that would be seen.
bool InitialConditions::is_roundoff(double residual, const VectorXd& v, double given) const {
  return residual == 0.0 || residual <= roundoff * std::clamp(rate(v) / given, 1.0, most_growth);
}

/// Residuals of velocities, relative to the rows.
VectorXd InitialConditions::velocity_residuals(const VectorXd& q, const VectorXd& v) {
  evaluate(q, v);
  return at_.Phi_dot.cwiseQuotient(row_lengths_);
}

// What mu leaves of a weak direction of S = D M^-1 D^T, of which sigma < mu, shrinks by mu / (sigma + mu) only: a chain
// of n driven joints has sigma of 1 / n^4. So the steps above are made conjugate, D x orthogonal to those before, and
// as long as leaves the least residual (Orthomin: P. K. W. Vinsome, An iterative method for solving sparse sets of
// simultaneous linear equations, SPE 5729, 1976). Where joints contradict each other the residual stays what it is, and
// so do the velocities: nothing of it is in the range of D, and a direction that D does not resist but for roundoff is
// no direction.
bool InitialConditions::conjugate_velocities(const VectorXd& q, VectorXd& v, double given, double least) {
  struct Direction {
    VectorXd x, change;  // the velocity, and its part of the residuals
  };
  std::deque<Direction> before;
  VectorXd found = v, drift = velocity_residuals(q, rest_);
  for (int k = 0, idle = 0; k < most_conjugate && idle < patience; ++k) {
    const VectorXd residuals = velocity_residuals(q, found);
    const double now = largest(residuals) / rounding_ / given;
    idle = now < progress * least ? 0 : idle + 1;
    if (now < least) {
      v = found;
      least = now;
    }
    if (now <= exact || (idle > 0 && is_roundoff(least, v, given))) break;
    if (!solve(rest_, -at_.Phi_dot, least_conjugate_damping)) break;
    Direction next{x_, velocity_residuals(q, x_) - drift};
    const double whole = next.change.norm();
    for (const Direction& it : before) {
      const double share = it.change.dot(next.change) / it.change.squaredNorm();
      next.x -= share * it.x;
      next.change -= share * it.change;
    }
    const double change = next.change.norm(), aligned = residuals.dot(next.change) / change;
    if (!(change > new_part * whole) || !(change > unresisted * rate_of_motion(next.x))) break;
    if (!(std::abs(aligned) > useful * residuals.norm())) break;
    found -= (aligned / change) * next.x;
    before.push_back(std::move(next));
    if (before.size() > most_directions) before.pop_front();
  }
  return is_roundoff(least, v, given) || least <= nearly_met();
}

}  // namespace linkwork
