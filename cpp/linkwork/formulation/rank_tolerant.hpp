#pragma once

#include <memory>

#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"
#include "linkwork/constraints/refinement.hpp"
#include "linkwork/formulation/formulation.hpp"

namespace linkwork {

/// Lagrange multipliers at and near singular poses, in place of a formulation whose matrix has become (nearly)
/// singular. Rows of loops that depend on the others, by a rank-revealing factorization, are left out of this
/// evaluation; the solution is refined by the residuals of M x - D^T lambda = a, D x = b, so that what counts is the
/// condition of D and not that of D M^-1 D^T, its square.
class RankTolerant final : public Formulation {
 public:
  RankTolerant(const System& system, const RegularizedInertia& inertia);

  void analyze(const System&, const Evaluation&, const ConstraintRows&) override {}
  /// SingularSystemError: there is no factorization whatever is left out.
  void factorize(const Evaluation& at) override;
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override;
  SaddleSolver& saddle() const override { return solver_.saddle(); }

 private:
  bool factorize(const Evaluation& at, double tolerance);
  bool corrects(const ConstVector& a, const ConstVector& b) const;

  const RegularizedInertia& inertia_;
  MassWeightedLeastSquares solver_;
  Evaluation at_;  ///< without the rows left out
  DroppedRows left_out_;
  Refinement refinement_;
  VectorXd b_;
};

}  // namespace linkwork
