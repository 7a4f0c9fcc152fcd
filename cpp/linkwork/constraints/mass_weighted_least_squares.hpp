#pragma once

#include <memory>

#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {

/// Least squares in the metric of the masses or of geometry, for questions about the constraints alone:
///   [M  D^T] {   x   }   {a}
///   [D  -E ] {-lambda} = {b}
/// Massless bodies get the mean mass and inertia of the others here, so that there is a metric. `weights`, where given,
/// are factors of mass and inertia, one per body.
class MassWeightedLeastSquares {
 public:
  explicit MassWeightedLeastSquares(const System& system, const VectorXd& weights = {});
  /// The metric of geometry: instead of the masses the velocities of natural size (see velocity_scale) count alike.
  /// Positions are counted from where one body of each connected component is in a pose: as a rule they are then as
  /// large as the mechanism, wherever it stands, and no digits of what joints say of them are lost.
  static MassWeightedLeastSquares of_geometry(const System& system, const ConstVector& q);

  /// The given system, or one with the same bodies, joints and rows that has a regular mass matrix.
  const System& system() const { return *system_; }
  /// A pose of the given system as that one sees it.
  VectorXd seen(const ConstVector& q) const;

  /// False where the matrix is singular; `e` as in SaddleSolver.
  bool factorize(const Evaluation& at, const VectorXd& e);
  SaddleSolver& saddle() const { return *saddle_; }
  /// Both in one.
  bool factorize_and_solve(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b,
                           MutableVector x, MutableVector lambda);
  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda);

 private:
  MassWeightedLeastSquares(const System& system, std::unique_ptr<System> other, VectorXd origins = {});

  VectorXd origins_;  ///< 3 per body, or nothing
  std::unique_ptr<System> regularized_;
  const System* system_;
  std::unique_ptr<SaddleSolver> saddle_;
  InterruptionMeter meter_;
};

}  // namespace linkwork
