#pragma once

#include <cstdint>
#include <vector>

#include "linkwork/constraints/loop_core.hpp"
#include "linkwork/constraints/metric_solver.hpp"

namespace linkwork {

/// A pose on the constraints of the loops at some time; components that could not be brought there keep the pose they
/// had.
struct ConsistentPose {
  VectorXd q;
  std::vector<char> reached;  ///< per component of the core
};

/// Where bodies are at some time [s], and the history of their joints.
struct TimedPose {
  double t;
  const VectorXd& q;
  const VectorXd& history;
};

/// Pulls a pose onto the constraints, which may be redundant: Gauss-Newton steps in the solver's metric M,
///   dq = -M^-1 D^T (D M^-1 D^T + E)^-1 Phi,   E a tiny part of the diagonal.
ConsistentPose pull_back(MetricSolver& solver, const LoopCore& core, const TimedPose& pose);

/// A random pose near the pose `q`, consistent at t = 0, the same in every run: a step along a random velocity that the
/// constraints allow, pulled back onto them. Components without such a velocity are not `mobile` and stay: they have no
/// `freedoms` (6 per body less the rank), or too small a part of a velocity is allowed.
struct PerturbedPose : ConsistentPose {
  std::vector<char> mobile;
};
PerturbedPose perturb(MetricSolver& solver, const LoopCore& core, const VectorXd& q, const std::vector<int>& freedoms);

/// A random velocity that the constraints allow at an evaluation, the same for the same seed.
VectorXd random_allowed_velocity(MetricSolver& solver, const LoopCore& core, const Evaluation& at, std::uint64_t seed);

}  // namespace linkwork
