#include "linkwork/constraints/row_selection.hpp"

#include "dense_algebra.hpp"
#include "linkwork/constraints/rank.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

constexpr double tolerance = 1e-9;

MatrixXd without(const MatrixXd& D, const Places& left_out) {
  MatrixXd kept(D.rows() - static_cast<Eigen::Index>(left_out.size()), D.cols());
  for (Eigen::Index row = 0, next = 0; row < D.rows(); ++row)
    if (!std::binary_search(left_out.begin(), left_out.end(), static_cast<int>(row))) kept.row(next++) = D.row(row);
  return kept;
}

double condition(const MatrixXd& D) {
  const VectorXd sigma = singular_values(D);
  return sigma.tail<1>()[0] / sigma[0];
}

}  // namespace

TEST_CASE("without the dependent rows the others are independent, and no fewer are") {
  const System system(four_bar());
  const Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, tolerance);
  const SparseRows D = loops.scaled_D(at);
  const Places dependent = dependent_rows(loops, D, tolerance);
  CHECK(dependent.size() == 3);
  CHECK(condition(without(D, dependent)) > 1e-3);
}

TEST_CASE("the rows to leave out belong to a joint that closes a loop, and leave the others well conditioned") {
  const Model model = four_bar();
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, tolerance);
  const VectorXd q = model.initial_q(), history = system.initial_history();
  MassWeightedLeastSquares solver(system);
  Evaluation scratch = system.make_evaluation();
  const PerturbedPose found = perturb(solver, loops, q, {1}, scratch);
  LoopPose assembled(system, loops, {0.0, q, history}, tolerance);
  LoopPose perturbed(system, loops, {0.0, found.q, history}, tolerance);
  const Places rows = redundant_rows(solver, loops, assembled, perturbed, found, tolerance);
  REQUIRE(rows.size() == 3);
  for (const int place : rows) CHECK(loops.closing(model.joint_of_row(loops.rows()[place])));
  CHECK(condition(without(assembled.D, rows)) > 1e-2);
}

TEST_CASE("rows left out of the question do not change which of the others depend on each other") {
  const System used(four_bar());
  const Evaluation at = evaluate_initially(used);
  const ClosedLoops loops(used, at, tolerance);
  const SparseRows D = loops.scaled_D(at);
  for (const int left_out : {-1, 0, 7, 19, 7, -1}) {  // the same structures come back
    Places kept;
    for (int place = 0; place < loops.row_count(); ++place)
      if (place != left_out) kept.push_back(place);
    const SparseRows rest = select_rows(D, kept);
    const System fresh(four_bar());
    const ClosedLoops alone(fresh, at, tolerance);
    CHECK(dependent_rows(loops, rest, tolerance) == dependent_rows(alone, rest, tolerance));
    CHECK(rest.nonZeros() == D.nonZeros() - (left_out < 0 ? 0 : D.row(left_out).nonZeros()));
  }
}
