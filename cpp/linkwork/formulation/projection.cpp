#include "linkwork/formulation/projection.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// Of changes: roundoff; where one that no longer shrinks counts as roundoff.
constexpr double exact = 1e-14, roundoff = 1e-9, shrinking = 0.5;
// Of the violation, likewise relative: near a singular pose nothing is to be made of noise, and where nothing moves
// against it a small one is left.
constexpr double noise = 1e-14, impossible = 1e-4;
constexpr int most_iterations = 30;

}  // namespace

ProjectionProgress::State ProjectionProgress::judge(double change) {
  iterations_ += 1;
  if (change <= exact || (change <= roundoff && change > shrinking * last_)) return State::converged;
  if (!(change <= last_) || iterations_ == most_iterations) return State::diverged;
  last_ = change;
  return State::going_on;
}

/// The farthest body counts, in its length.
double projection_reach(const NaturalSize& size, const System& system, const VectorXd& y) {
  double farthest = 0.0;
  for (int body = 0; body < system.body_count(); ++body)
    farthest = std::max(farthest, y.segment<3>(position_size * body).norm() / size.length(body));
  return 1.0 + farthest;
}

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
  using State = ProjectionProgress::State;
  ProjectionProgress progress;
  State state = State::going_on;
  while (state == State::going_on) {
    system.evaluate_constraints(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()),
                                dynamics_.history(), at_);
    b_ = -violation(at_);
    const bool singular = dynamics_.watch().open();
    if (singular && relative_violation(scale) <= noise) return;
    dynamics_.solve(none_, b_, x_, lambda_);
    state = progress.judge(move());
    if (state == State::converged && (!dynamics_.formulation().fallback() || relative_violation(scale) <= impossible))
      return;
    if (state == State::diverged && singular && relative_violation(scale) <= 1e2 * noise) return;
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
  const double reach = projection_reach(size_, system, y);
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

void Projection::stabilize(double t, VectorXd& y) {
  const StabilizationKind kind = dynamics_.stabilization();
  if (!projects_positions(kind) && !projects_velocities(kind)) return;
  dynamics_.evaluate(t, y);
  if (projects_positions(kind)) positions(t, y);
  if (projects_velocities(kind)) velocities(t, y);
}

}  // namespace linkwork
