#include "linkwork/formulation/projection.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// Relative to the size of the mechanism and its distance from the origin, or to its rate: where a change is roundoff;
// where one that no longer shrinks counts as roundoff, and one that does so as no convergence.
constexpr double exact = 1e-14, roundoff = 1e-9, shrinking = 0.5;
// Of the violation, likewise relative: near a singular pose nothing is to be made of noise, and where nothing moves
// against it a small one is left.
constexpr double noise = 1e-14, impossible = 1e-4;
constexpr int most_iterations = 30;

}  // namespace

Projection::Projection(Dynamics& dynamics)
    : dynamics_(dynamics),
      at_(dynamics.system().make_evaluation()),
      size_(dynamics.system()),
      none_(VectorXd::Zero(dynamics.system().v_size())),
      b_(dynamics.system().row_count()),
      x_(dynamics.system().v_size()),
      lambda_(dynamics.system().row_count()) {}

double Projection::relative_violation(double scale) const {
  return b_.cwiseQuotient(row_lengths(dynamics_.system(), at_)).cwiseAbs().maxCoeff() / scale;
}

template <class Violation, class Move>
void Projection::iterate(double t, VectorXd& y, double scale, Violation violation, Move move) {
  const System& system = dynamics_.system();
  if (system.row_count() == 0) return;
  double last = INFINITY;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    system.evaluate_constraints(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()),
                                dynamics_.history(), at_);
    b_ = -violation(at_);
    const bool singular = dynamics_.watch().open();
    if (singular && relative_violation(scale) <= noise) return;
    dynamics_.solve(none_, b_, x_, lambda_);
    const double change = move();
    if (change <= exact || (change <= roundoff && change > shrinking * last)) {
      if (!dynamics_.formulation().fallback() || relative_violation(scale) <= impossible) return;
      break;
    }
    if (!(change <= last)) {
      if (singular && relative_violation(scale) <= 1e2 * noise) return;
      break;
    }
    last = change;
  }
  Eigen::Index row = 0;
  const double worst = b_.cwiseAbs().maxCoeff(&row);
  const Model& model = system.model();
  ErrorDetails details;
  details.joints = {model.joint_name(model.joint_of_row(static_cast<int>(row)))};
  details.residuals = {{details.joints.front(), worst}};
  throw NotConvergedError("projection",
                          "projection: the state is too far from the constraints to be taken back, most of all " +
                              model.describe_row(static_cast<int>(row)) +
                              "; use a smaller step, or see whether the mechanism locks in this pose",
                          details);
}

void Projection::positions(double t, VectorXd& y) {
  const System& system = dynamics_.system();
  const double reach = 1.0 + farthest(y);
  const auto violation = [](const Evaluation& at) -> const VectorXd& { return at.Phi; };
  iterate(t, y, 1.0, violation, [&] {
    displace(system, x_, y);
    return size_.of(x_) / reach;
  });
}

void Projection::velocities(double t, VectorXd& y) {
  const System& system = dynamics_.system();
  auto v = y.segment(system.q_size(), system.v_size());
  const double by_forces = std::sqrt(size_.of_free_motion(dynamics_.evaluation().g.head(system.v_size())));
  double rate = std::max(size_.of(v), by_forces);
  const auto violation = [](const Evaluation& at) -> const VectorXd& { return at.Phi_dot; };
  iterate(t, y, rate > 0.0 ? rate : 1.0, violation, [&] {
    v += x_;
    rate = std::max(rate, size_.of(v));
    return NaturalSize::ratio(size_.of(x_), rate);
  });
}

/// Of the bodies from the origin, in their lengths.
double Projection::farthest(const VectorXd& y) const {
  double out = 0.0;
  for (int body = 0; body < dynamics_.system().body_count(); ++body)
    out = std::max(out, y.segment<3>(position_size * body).norm() / size_.length(body));
  return out;
}

void Projection::stabilize(double t, VectorXd& y) {
  const StabilizationKind kind = dynamics_.stabilization();
  if (!projects_positions(kind) && !projects_velocities(kind)) return;
  dynamics_.evaluate(t, y);
  if (projects_positions(kind)) positions(t, y);
  if (projects_velocities(kind)) velocities(t, y);
}

}  // namespace linkwork
