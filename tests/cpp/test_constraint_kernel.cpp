#include "linkwork/constraints/constraint_kernel.hpp"

#include "dense_algebra.hpp"
#include "mechanisms.hpp"

using namespace support;

TEST_CASE("vectors of the kernel satisfy D^T n = 0, with the values given for the dependent rows") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, 1e-9);
  MassWeightedLeastSquares solver(system);
  const MatrixXd D = dense_D(system, at);
  const std::vector<int> dependent = {17, 18, 19};  // of the last hinge: z, and the rotations about x and y
  ConstraintKernel kernel(solver, loops, at, dependent);
  REQUIRE(kernel.regular());
  CHECK(kernel.size() == 3);
  // The kernel refers to rows of unit length in the metric M^-1.
  const VectorXd root = dense_delassus(dense_M(system.model()), D).diagonal().cwiseSqrt();
  const MatrixXd unit = root.cwiseInverse().asDiagonal() * D;
  for (int k = 0; k < 3; ++k) {
    const VectorXd n = kernel.vector(VectorXd::Unit(3, k));
    CHECK((unit.transpose() * n).cwiseAbs().maxCoeff() < 1e-10 * n.cwiseAbs().maxCoeff());
    for (int row = 0; row < 3; ++row) CHECK(std::abs(n[dependent[row]] - (row == k ? 1.0 : 0.0)) < 1e-12);
  }
}

TEST_CASE("rows that leave dependent ones behind are no choice") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, 1e-9);
  MassWeightedLeastSquares solver(system);
  CHECK(!ConstraintKernel(solver, loops, at, {15, 16}).regular());
}

TEST_CASE("an evaluation is as it was when the kernel is gone") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, 1e-9);
  MassWeightedLeastSquares solver(system);
  const MatrixXd D = dense_D(system, at);
  {
    const ConstraintKernel kernel(solver, loops, at, {17, 18, 19});
    CHECK(dense_D(system, at).bottomRows(3).isZero(0.0));
  }
  CHECK(dense_D(system, at) == D);
}

TEST_CASE("members are the rows that a planar loop repeats: shifts along z, and turns about x and y") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, 1e-9);
  MassWeightedLeastSquares solver(system);
  ConstraintKernel kernel(solver, loops, at, {17, 18, 19});
  std::vector<char> marks(20, 0);
  kernel.mark_members(marks);
  for (int joint = 0; joint < 4; ++joint)
    for (int k = 0; k < 5; ++k) CHECK(static_cast<bool>(marks[5 * joint + k]) == (k >= 2));
}
