#pragma once

#include <vector>

#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/constraints/loop_core.hpp"
#include "linkwork/constraints/metric_solver.hpp"

namespace linkwork {

/// Rows of the core as places in its list.
using Places = std::vector<int>;

/// Rows of A that depend on the others, ascending.
Places dependent_rows(const SparseRows& A, double tolerance);

/// The core at one pose: D, and the rows that depend on the others.
struct CorePose {
  CorePose(const System& system, const LoopCore& core, const VectorXd& q, double tolerance, double t = 0.0);
  Evaluation at;
  SparseRows D;  ///< rows of unit length
  Places dependent;
};

/// The rows to leave out because they are dependent at the assembled and at the perturbed pose, ascending. There is a
/// choice: rows of joints that close loops come first, and among these the ones that leave the others best conditioned
/// at both poses. Without `prefer_closing` the best conditioned are chosen whatever their joints.
Places redundant_rows(MetricSolver& solver, const LoopCore& core, const CorePose& assembled, const CorePose& perturbed,
                      const PerturbedPose& found, double tolerance, bool prefer_closing = true);

}  // namespace linkwork
