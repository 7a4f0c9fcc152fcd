#pragma once

#include <memory>

#include "linkwork/constraints/conjugate_residuals.hpp"
#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/mass_weighted_least_squares.hpp"
#include "linkwork/constraints/refinement.hpp"
#include "linkwork/formulation/formulation.hpp"

namespace linkwork {

/// Lagrange multipliers at and near singular poses, in place of a formulation whose matrix has become (nearly)
/// singular. Rows of loops that depend on the others, by a rank-revealing factorization, are left out of this
/// evaluation; the others are factorized as if they yielded a little, and ConjugateResiduals go on from there to their
/// exact solution, so that what counts is the condition of D and not that of D M^-1 D^T, its square. Where small
/// inertias are regularized, Refinement does.
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
  bool factorize(bool yielding);
  bool exact(const ConstVector& a, MutableVector v_dot, MutableVector lambda);
  bool corrects(const ConstVector& a, const ConstVector& b) const;

  const RegularizedInertia& inertia_;
  MassWeightedLeastSquares solver_;
  Evaluation at_;  ///< without the rows left out
  DroppedRows left_out_;
  bool yields_ = false;  ///< what is factorized
  Refinement refinement_;
  Refinement::Nearby nearby_ = [this](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx,
                                      MutableVector dlambda) { solver_.solve(r_1, r_2, dx, dlambda); };
  ConjugateResiduals residuals_;
  VectorXd b_;
};

}  // namespace linkwork
