#pragma once

#include "linkwork/constraints/constrained_solver.hpp"
#include "linkwork/constraints/dropped_rows.hpp"

namespace linkwork {

/// The multipliers of redundant constraints. Joint forces determine them up to ker D^T; of all that give the same
/// D^T lambda this takes those of least
///   sum_i w_i lambda_i^2,   w_i = the Delassus diagonal (D M^-1 D^T)_ii as in `mean_delassus_diagonal`,
/// the norm of the multipliers of rows scaled to a unit Delassus diagonal: it does not depend on units, on the
/// directions of axes or on which rows were dropped, and equal joints side by side share their load equally.
class MinimumNorm {
 public:
  MinimumNorm() = default;
  MinimumNorm(const System& system, const VectorXd& delassus, const DroppedRows& dropped);

  /// Replaces `lambda`, a solution with zeros for the dropped rows, at the state that `solver` has factorized.
  void distribute(const DroppedRows& dropped, ConstrainedSolver& solver, MutableVector lambda);

 private:
  void multiply_N(const DroppedRows& dropped, ConstrainedSolver& solver, const ConstVector& omega);
  void multiply_N_transposed(const DroppedRows& dropped, ConstrainedSolver& solver, const ConstVector& u);

  VectorXd root_;                           ///< w^1/2 of all rows
  VectorXd scale_;                          ///< w^-1/2 of the dropped ones
  VectorXd a_, b_, x_, lambda_;             ///< of the equations
  VectorXd omega_, r_, p_, u_d_, product_;  ///< of the conjugate gradients, over the dropped rows
};

}  // namespace linkwork
