#pragma once

#include <vector>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"
#include "linkwork/linear/column_rank.hpp"

namespace linkwork {

/// Rows of the loops as places in their list.
using Places = std::vector<int>;

/// Rows of A, some of the loops' rows, that depend on the others, ascending.
Places dependent_rows(const ClosedLoops& loops, const SparseRows& A, double tolerance);

/// The loops at one pose: D, and the rows that depend on the others.
struct LoopPose {
  LoopPose(const System& system, const ClosedLoops& loops, const TimedPose& pose, double tolerance);
  /// With the evaluation of the constraints there.
  LoopPose(const ClosedLoops& loops, Evaluation at, double tolerance);
  Evaluation at;
  SparseRows D;  ///< rows of unit length
  Places dependent;
  std::vector<ColumnRank::Weak> weak;  ///< of the places that are kept, see ColumnRank
};

/// The rows to leave out because they are dependent at both poses.
struct RedundantRows {
  Places rows;  ///< ascending
  std::vector<char>
      independent;  ///< per component: whether the others are known to be independent at the assembled pose
};

/// Of rows that are dependent at the assembled and at the perturbed pose. There is a choice: rows of joints that close
/// loops come first, and among these the ones that leave the others best conditioned at both poses. Without
/// `prefer_closing` the best conditioned are chosen whatever their joints.
RedundantRows redundant_rows(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& assembled,
                             LoopPose& perturbed, const PerturbedPose& found, double tolerance,
                             bool prefer_closing = true);

}  // namespace linkwork
