#include "linkwork/constraints/consistent_pose.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "linkwork/constraints/conjugate_residuals.hpp"
#include "linkwork/constraints/length_scale.hpp"

namespace linkwork {
namespace {

// What the singular values of unit rows are compared with: roundoff in Phi is magnified by less than 1 / (2 sqrt(e)).
constexpr double epsilon = 1e-10;
constexpr double yielding = 1e20;
constexpr double converged = 1e-10;  // last step [rad, or m relative to the size of the component]
constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();
constexpr double few_roundings = 4 * std::numeric_limits<double>::epsilon();
constexpr int most_steps = 20;
constexpr double longest_step = 0.5;
constexpr double immobile = 1e-5;  // part of a random velocity that the constraints allow
constexpr double steps[] = {0.1, 0.01, 0.001};
constexpr double unchanged = 1e-10;  // of a velocity, by a step that corrects it
constexpr int most_corrections = 300;
constexpr double moved_part = 0.1;  // of a step: less, and the pose fell back to where it was

/// The connected components of the loops and the sizes of their motions. Bodies outside belong to none.
class Components {
 public:
  Components(const System& system, const ClosedLoops& loops) : system_(system), loops_(loops) {
    measure_lengths();
    measure_reach();
  }

  /// Size of a step that can be the last: far from the origin that of the roundoff of positions.
  double last_step(std::size_t c) const { return std::max(converged, roundoff * reach_[c] / length_[c]); }

  /// Whether all rows of each component are satisfied, but for a few roundings of its positions.
  std::vector<char> satisfied(const VectorXd& Phi, const VectorXd& row_lengths) const {
    std::vector<char> out(count(), 1);
    for (int place = 0; place < loops_.row_count(); ++place) {
      const auto c = static_cast<std::size_t>(loops_.component_of_row(place));
      const int row = loops_.rows()[place];
      const double least = few_roundings * std::max(1.0, reach_[c] / length_[c]);
      if (!(std::abs(Phi[row]) <= least * row_lengths[row])) out[c] = 0;
    }
    return out;
  }

  std::size_t count() const { return static_cast<std::size_t>(loops_.component_count()); }

  /// Largest |omega| and |r_dot| / length of the bodies of each component.
  std::vector<double> sizes(const VectorXd& velocity) const {
    std::vector<double> out(count(), 0.0);
    for_each_body([&](int body, std::size_t c) {
      const auto v = velocity.segment<6>(6 * body);
      out[c] = std::max({out[c], v.head<3>().norm() / length_[c], v.tail<3>().norm()});
    });
    return out;
  }

  /// The same for the way between two poses.
  std::vector<double> distances(const VectorXd& from, const VectorXd& to) const {
    std::vector<double> out(count(), 0.0);
    for_each_body([&](int body, std::size_t c) {
      const VectorXd way = to.segment<7>(7 * body) - from.segment<7>(7 * body);
      out[c] = std::max({out[c], way.head<3>().norm() / length_[c], 2.0 * way.tail<4>().norm()});
    });
    return out;
  }

  void multiply(const std::vector<double>& factors, VectorXd& velocity) const {
    for_each_body([&](int body, std::size_t c) { velocity.segment<6>(6 * body) *= factors[c]; });
  }

  /// Copies the poses of the bodies in the chosen components.
  void copy(const std::vector<char>& chosen, const VectorXd& from, VectorXd& to) const {
    for_each_body([&](int body, std::size_t c) {
      if (chosen[c]) to.segment<7>(7 * body) = from.segment<7>(7 * body);
    });
  }

 private:
  template <class Visit>
  void for_each_body(Visit visit) const {
    for (int body = 0; body < system_.body_count(); ++body)
      if (const int c = loops_.component_of_body(body); c >= 0) visit(body, static_cast<std::size_t>(c));
  }

  void measure_lengths() {
    const VectorXd& lengths = characteristic_lengths(system_);
    length_.assign(count(), 1.0);
    for_each_body([&](int body, std::size_t c) { length_[c] = lengths[body]; });
  }

  void measure_reach() {
    reach_.assign(count(), 0.0);
    for_each_body([&](int body, std::size_t c) {
      reach_[c] = std::max(reach_[c], system_.model().bodies()[body].position.norm());
    });
  }

  const System& system_;
  const ClosedLoops& loops_;
  std::vector<double> length_, reach_;
};

void move(const System& system, const VectorXd& velocity, VectorXd& q) {
  VectorXd rates(system.q_size());
  system.position_rates(q, velocity, rates);
  q += rates;
  system.normalize(q);
}

/// Rows of the open branches, which follow the loops, yield to everything.
VectorXd compliance(const System& system, const ClosedLoops& loops, const Evaluation& at) {
  VectorXd delassus = system.delassus_diagonal(at);
  delassus = (delassus.array() > 0.0).select(delassus, 1.0);
  VectorXd e = yielding * delassus;
  for (const int row : loops.rows()) e[row] = epsilon * delassus[row];
  return e;
}

bool all(const std::vector<char>& of_components) {
  return std::find(of_components.begin(), of_components.end(), 0) == of_components.end();
}

/// Of rows at a pose near by.
struct RowScales {
  VectorXd compliance, lengths;
};

/// With scales a pose that satisfies its constraints is good enough, though the last step was long: along motions that
/// the constraints hardly resist, of which long rows of loops have many, steps only shrink by a part.
ConsistentPose project_positions(MassWeightedLeastSquares& solver, const ClosedLoops& loops,
                                 const Components& components, const TimedPose& pose, Evaluation& at,
                                 const RowScales* scales = nullptr) {
  const System& system = solver.system();
  VectorXd q = pose.q;
  const VectorXd rest = VectorXd::Zero(system.v_size());
  VectorXd step(system.v_size()), lambda(system.row_count()), e;
  ConsistentPose out{q, std::vector<char>(components.count(), 0)};
  for (int k = 0; k < most_steps && !all(out.reached); ++k) {
    system.evaluate_constraints(pose.t, q, rest, pose.history, at);
    if (scales) out.reached = components.satisfied(at.Phi, scales->lengths);
    if (scales && all(out.reached)) break;
    if (!scales) e = compliance(system, loops, at);
    if (!solver.factorize_and_solve(at, scales ? scales->compliance : e, rest, -at.Phi, step, lambda)) break;
    if (!step.allFinite()) break;
    std::vector<double> factors = components.sizes(step);
    for (std::size_t c = 0; c < factors.size(); ++c) {
      out.reached[c] = (scales && out.reached[c]) || factors[c] <= components.last_step(c);
      factors[c] = std::min(1.0, longest_step / std::max(factors[c], longest_step));
    }
    components.multiply(factors, step);
    move(system, step, q);
  }
  components.copy(out.reached, q, out.q);
  return out;
}

/// A random velocity less its part that the constraints resist; three times, for epsilon.
VectorXd allowed_velocity(MassWeightedLeastSquares& solver, const VectorXd& e, const Evaluation& at,
                          VectorXd velocity) {
  const System& system = solver.system();
  const VectorXd none = VectorXd::Zero(system.row_count());
  VectorXd momentum(system.v_size()), lambda(system.row_count());
  system.multiply_mass(at, velocity, momentum);
  if (!solver.factorize_and_solve(at, e, momentum, none, velocity, lambda)) return VectorXd::Zero(system.v_size());
  for (int k = 0; k < 2; ++k) {
    system.multiply_mass(at, velocity, momentum);
    solver.solve(momentum, none, velocity, lambda);
  }
  return velocity;
}

/// The same without what the constraints resist by less than epsilon, such as a long loop out of its plane.
VectorXd exactly_allowed(MassWeightedLeastSquares& solver, const VectorXd& e, const Evaluation& at, VectorXd velocity) {
  const System& system = solver.system();
  const VectorXd none = VectorXd::Zero(system.row_count());
  VectorXd momentum(system.v_size()), lambda = none;
  if (!solver.factorize(at, e)) return velocity;
  system.multiply_mass(at, velocity, momentum);
  ConjugateResiduals residuals(system);
  residuals.measure_rows(at);
  const auto nearby = [&](const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector multipliers) {
    solver.solve(a, b, x, multipliers);
  };
  residuals.solve(at, momentum, none, velocity, lambda, nearby, unchanged, most_corrections);
  return velocity;
}

VectorXd random_velocity(const System& system, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  VectorXd random(system.v_size());
  for (double& x : random) x = static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0;
  random.array() *= velocity_scale(system).array();
  return random;
}

}  // namespace

VectorXd random_allowed_velocity(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const Evaluation& at,
                                 std::uint64_t seed) {
  const System& system = solver.system();
  return allowed_velocity(solver, compliance(system, loops, at), at, random_velocity(system, seed));
}

ConsistentPose project_positions(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const TimedPose& pose) {
  Evaluation at = solver.system().make_evaluation();
  return project_positions(solver, loops, pose, at);
}

ConsistentPose project_positions(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const TimedPose& pose,
                                 Evaluation& scratch) {
  return project_positions(solver, loops, Components(solver.system(), loops), pose, scratch);
}

namespace {

/// Components that are mobile, and have not got anywhere yet, to a pose near q along a velocity.
void move_along(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const Components& components,
                const VectorXd& q, VectorXd velocity, const RowScales& scales, Evaluation& at, PerturbedPose& out) {
  const System& system = solver.system();
  std::vector<double> unit = components.sizes(velocity);
  for (std::size_t c = 0; c < unit.size(); ++c)
    unit[c] = out.mobile[c] && !out.reached[c] && unit[c] > 0.0 ? 1.0 / unit[c] : 0.0;
  components.multiply(unit, velocity);
  for (const double step : steps) {
    VectorXd moved = q;
    move(system, step * velocity, moved);
    const TimedPose near = {0.0, moved, system.initial_history()};
    const ConsistentPose found = project_positions(solver, loops, components, near, at, &scales);
    const std::vector<double> way = components.distances(q, found.q);
    std::vector<char> news(components.count());
    for (std::size_t c = 0; c < news.size(); ++c)
      news[c] = found.reached[c] && out.mobile[c] && !out.reached[c] && way[c] > moved_part * step;
    components.copy(news, found.q, out.q);
    for (std::size_t c = 0; c < news.size(); ++c) out.reached[c] |= news[c];
    if (out.reached == out.mobile) break;
  }
}

}  // namespace

PerturbedPose perturb(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const VectorXd& q,
                      const std::vector<int>& freedoms, Evaluation& at) {
  const System& system = solver.system();
  const Components components(system, loops);
  system.evaluate_constraints(0.0, q, VectorXd::Zero(system.v_size()), system.initial_history(), at);
  const RowScales scales = {compliance(system, loops, at), row_lengths(system, at)};
  const VectorXd random = random_velocity(system, 1);
  VectorXd velocity = allowed_velocity(solver, scales.compliance, at, random);

  PerturbedPose out{{q, std::vector<char>(components.count(), 0)}, std::vector<char>(components.count(), 0)};
  const std::vector<double> unit = components.sizes(velocity), all = components.sizes(random);
  for (std::size_t c = 0; c < components.count(); ++c) out.mobile[c] = freedoms[c] > 0 && unit[c] > immobile * all[c];
  move_along(solver, loops, components, q, velocity, scales, at, out);
  if (out.reached == out.mobile) return out;
  system.evaluate_constraints(0.0, q, VectorXd::Zero(system.v_size()), system.initial_history(), at);
  velocity = exactly_allowed(solver, scales.compliance, at, velocity);
  move_along(solver, loops, components, q, velocity, scales, at, out);
  return out;
}

}  // namespace linkwork
