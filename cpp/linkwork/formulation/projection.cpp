#include "linkwork/formulation/projection.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/displacement.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// Relative to 1 + |r| and 1 rad, or to 1 + |v|: where a change is roundoff; where one that no longer shrinks counts as
// roundoff, and one that does so as no convergence.
constexpr double exact = 1e-14, roundoff = 1e-9, shrinking = 0.5;
constexpr double noise = 1e-14;      // of the violation; near a singular pose nothing is to be made of it
constexpr double impossible = 1e-4;  // violation that is left in a singular pose, where nothing moves against it
constexpr int most_iterations = 30;

double accelerate(const System& system, const VectorXd& x, VectorXd& y) {
  auto v = y.segment(system.q_size(), system.v_size());
  const double size = v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0;
  v += x;
  return x.size() > 0 ? x.cwiseAbs().maxCoeff() / (1.0 + size) : 0.0;
}

}  // namespace

Projection::Projection(Dynamics& dynamics)
    : dynamics_(dynamics),
      at_(dynamics.system().make_evaluation()),
      none_(VectorXd::Zero(dynamics.system().v_size())),
      b_(dynamics.system().row_count()),
      x_(dynamics.system().v_size()),
      lambda_(dynamics.system().row_count()) {}

template <class Violation, class Move>
void Projection::iterate(double t, VectorXd& y, Violation violation, Move move) {
  const System& system = dynamics_.system();
  if (system.row_count() == 0) return;
  double last = INFINITY;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    system.evaluate_constraints(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()),
                                dynamics_.history(), at_);
    b_ = -violation(at_);
    const bool singular = dynamics_.watch().open();
    if (singular && b_.cwiseAbs().maxCoeff() <= noise) return;
    dynamics_.solve(none_, b_, x_, lambda_);
    const double change = move(system, x_, y);
    if (change <= exact || (change <= roundoff && change > shrinking * last)) {
      if (!dynamics_.taken_over() || b_.cwiseAbs().maxCoeff() <= impossible) return;
      break;
    }
    if (!(change <= last)) {
      if (singular && b_.cwiseAbs().maxCoeff() <= 1e2 * noise) return;
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
  iterate(t, y, [](const Evaluation& at) -> const VectorXd& { return at.Phi; }, displace);
}

void Projection::velocities(double t, VectorXd& y) {
  iterate(t, y, [](const Evaluation& at) -> const VectorXd& { return at.Phi_dot; }, accelerate);
}

void Projection::stabilize(double t, VectorXd& y) {
  const StabilizationKind kind = dynamics_.stabilization();
  if (!projects_positions(kind) && !projects_velocities(kind)) return;
  dynamics_.evaluate(t, y);
  if (projects_positions(kind)) positions(t, y);
  if (projects_velocities(kind)) velocities(t, y);
}

}  // namespace linkwork
