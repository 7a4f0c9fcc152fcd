#pragma once

#include <cstdint>
#include <vector>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"

namespace linkwork {

/// A pose on the constraints of the loops at some time, or, of loops that cannot close, where the squares of their
/// residuals are least: Phi there says which. Components that came to no rest keep the pose they had.
struct ConsistentPose {
  VectorXd q;
  std::vector<char> reached;  ///< per component of the loops: whether it came to rest, closed or not
};

/// Where bodies are at some time [s], and the history of their joints.
struct TimedPose {
  double t;
  const VectorXd& q;
  const VectorXd& history;
};

/// Projects positions onto the constraints, which may be redundant: Gauss-Newton steps in the metric of the masses,
///   dq = -M^-1 D^T (D M^-1 D^T + E)^-1 Phi,   E a tiny part of the diagonal.
ConsistentPose project_positions(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const TimedPose& pose);
/// The same with an evaluation of the solver's system, whatever it holds, as scratch memory.
ConsistentPose project_positions(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const TimedPose& pose,
                                 Evaluation& scratch);

/// A random pose near the pose `q`, consistent at t = 0, the same in every run: a step along a random velocity that the
/// constraints allow, projected onto them. Components without such a velocity are not `mobile` and stay: they have no
/// `freedoms` (6 per body less the rank), or too small a part of a velocity is allowed.
struct PerturbedPose : ConsistentPose {
  std::vector<char> mobile;
};
PerturbedPose perturb(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const VectorXd& q,
                      const std::vector<int>& freedoms, Evaluation& scratch);

/// A random velocity that the constraints allow at an evaluation, the same for the same seed.
VectorXd random_allowed_velocity(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const Evaluation& at,
                                 std::uint64_t seed);

}  // namespace linkwork
