#pragma once

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"
#include "linkwork/constraints/refinement.hpp"

namespace linkwork {

/// ker D^T of the rows in loops at an evaluation, by its values at dependent rows d: with the others, k, independent,
///   n_k = -(D_k M^-1 D_k^T)^-1 D_k M^-1 D_d^T n_d.
/// Vectors are over these rows and refer to rows of unit length in the metric M^-1.
class ConstraintKernel {
 public:
  /// `dependent` are constraint rows in loops: their D is out of the evaluation while there is the kernel. One kernel at
  /// a time may use a solver.
  ConstraintKernel(MassWeightedLeastSquares& solver, const ClosedLoops& loops, Evaluation& at,
                   const std::vector<int>& dependent);
  ~ConstraintKernel() { dropped_.put_back(at_); }
  ConstraintKernel(const ConstraintKernel&) = delete;
  ConstraintKernel& operator=(const ConstraintKernel&) = delete;

  int size() const { return dropped_.count(); }
  const std::vector<int>& dependent() const { return dropped_.rows(); }  ///< ascending
  /// Whether the other rows are independent, without which there are no vectors.
  bool regular() const { return regular_; }

  /// The vector with these values for the dependent rows, in their order.
  VectorXd vector(const VectorXd& n_d);

  /// Part of the largest entry above which an entry is none of roundoff.
  static constexpr double member = 1e-7;
  /// Marks the rows of a random vector of the kernel that do not vanish: those of any basis that do not.
  void mark_members(std::vector<char>& marks);

 private:
  int row(int place) const { return loops_.rows()[place]; }

  MassWeightedLeastSquares& solver_;
  const ClosedLoops& loops_;
  Evaluation& at_;
  VectorXd scale_, a_, b_, x_, lambda_;
  DroppedRows dropped_;
  Refinement refinement_;
  bool regular_ = false;
};

}  // namespace linkwork
