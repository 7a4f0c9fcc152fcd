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
  const Places rows = redundant_rows(solver, loops, assembled, perturbed, found, tolerance).rows;
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

namespace {

constexpr int many_loops = 40;  // more than are chosen from by one kernel for all

/// Of a ladder, its posts laid down along its line: a dead center of all its loops.
VectorXd laid_down(const Model& model) {
  VectorXd q = model.initial_q();
  for (int k = 0; k <= many_loops; ++k) {
    q.segment<3>(7 * k) << k + 0.5, 0.0, 0.0;
    q.segment<4>(7 * k + 3) << std::sqrt(0.5), 0.0, 0.0, -std::sqrt(0.5);
    if (k < many_loops) q.segment<3>(7 * (many_loops + 1 + k)) << k + 1.5, 0.0, 0.0;
  }
  return q;
}

struct Chosen {
  std::size_t rows;
  bool independent;
  double condition;  ///< of the other rows, at the assembled pose
};

/// From a pose of the ladder, and its first one as the perturbed one.
Chosen chosen(const Model& model, const VectorXd& q) {
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, tolerance);
  MassWeightedLeastSquares solver(system);
  LoopPose assembled(system, loops, {0.0, q, {}}, tolerance);
  LoopPose perturbed(system, loops, {0.0, model.initial_q(), {}}, tolerance);
  CHECK(assembled.at.Phi.norm() < 1e-12);
  const PerturbedPose found{{q, {1}}, {1}};
  const RedundantRows redundant = redundant_rows(solver, loops, assembled, perturbed, found, tolerance);
  for (const int place : redundant.rows) CHECK(loops.closing(model.joint_of_row(loops.rows()[place])));
  return {redundant.rows.size(), redundant.independent.at(0) != 0, condition(without(assembled.D, redundant.rows))};
}

}  // namespace

TEST_CASE("of a long ladder three rows of each closing joint are left out, and the rest is independent") {
  const Model model = ladder(many_loops);
  const Chosen upright = chosen(model, model.initial_q());
  CHECK(upright.rows == 3 * many_loops);
  CHECK(upright.independent);
  CHECK(upright.condition > 1e-5);
}

TEST_CASE("the rest of a long ladder is not taken for independent at a dead center") {
  const Model model = ladder(many_loops);
  const Chosen flat = chosen(model, laid_down(model));
  CHECK(flat.rows == 3 * many_loops);
  CHECK(!flat.independent);
  CHECK(flat.condition < 1e-12);
}
