#include <doctest/doctest.h>

#include <algorithm>

#include "dense_algebra.hpp"
#include "linkwork/linear/column_rank.hpp"
#include "spqr_rank.hpp"
#include "support.hpp"

using namespace support;

namespace {

constexpr double tolerance = 1e-9;

std::vector<int> dependent(const MatrixXd& A) {
  std::vector<Entry> entries;
  for (int row = 0; row < A.rows(); ++row)
    for (int column = 0; column < A.cols(); ++column)
      if (A(row, column) != 0.0) entries.push_back({row, column, A(row, column)});
  return dependent_columns(static_cast<int>(A.rows()), static_cast<int>(A.cols()), entries, tolerance);
}

/// As many as columns less rank, ascending, and the others are independent.
void check_dependent(const MatrixXd& A) {
  const std::vector<int> columns = dependent(A);
  const int expected = dense_rank(A, tolerance);
  CHECK(static_cast<int>(A.cols()) - static_cast<int>(columns.size()) == expected);
  CHECK(std::is_sorted(columns.begin(), columns.end()));
  MatrixXd rest(A.rows(), 0);
  for (int column = 0; column < A.cols(); ++column)
    if (!std::binary_search(columns.begin(), columns.end(), column)) {
      rest.conservativeResize(Eigen::NoChange, rest.cols() + 1);
      rest.rightCols<1>() = A.col(column);
    }
  CHECK(dense_rank(rest, tolerance) == expected);
}

/// Random with most entries zero.
MatrixXd sparse(int rows, int columns, Random& random) {
  MatrixXd A = random.matrix(rows, columns);
  for (double& value : A.reshaped())
    if (random.number() > -0.2) value = 0.0;
  return A;
}

}  // namespace

TEST_CASE("planted combinations of columns are found, as many as the singular values say") {
  Random random(100);
  for (int repetition = 0; repetition < 40; ++repetition) {
    const int columns = random.integer(4, 30), rows = columns + random.integer(0, 20);
    CAPTURE(columns);
    MatrixXd A = sparse(rows, columns, random);
    for (int planted = random.integer(1, 3); planted > 0; --planted)
      A.col(random.integer(0, columns - 1)) = A.col(0) - 2.0 * A.col(columns / 2) + 0.5 * A.col(columns - 1);
    check_dependent(A);
  }
}

TEST_CASE("a matrix of full column rank has no dependent columns") {
  Random random(101);
  for (int repetition = 0; repetition < 10; ++repetition) CHECK(dependent(random.matrix(20, 12)).empty());
}

TEST_CASE("equal columns: all but one are dependent") {
  Random random(102);
  MatrixXd A = random.matrix(8, 5);
  A.col(3) = A.col(1);
  A.col(4) = -A.col(1);
  const std::vector<int> columns = dependent(A);
  CHECK(columns.size() == 2);
  for (const int column : columns) CHECK((column == 1 || column == 3 || column == 4));
}

TEST_CASE("zero columns are dependent") {
  Random random(103);
  MatrixXd A = random.matrix(8, 5);
  A.col(2).setZero();
  CHECK(dependent(A) == std::vector<int>{2});
}

TEST_CASE("all columns of a zero matrix are dependent") {
  CHECK(dependent(MatrixXd::Zero(4, 3)) == std::vector<int>{0, 1, 2});
  CHECK(dependent_columns(2, 2, {{0, 0, 0.0}, {1, 1, 0.0}}, tolerance) == std::vector<int>{0, 1});
  CHECK(dependent(MatrixXd::Zero(0, 2)) == std::vector<int>{0, 1});
}

TEST_CASE("no columns, no dependent columns") { CHECK(dependent(MatrixXd::Zero(4, 0)).empty()); }

TEST_CASE("without rows all columns are dependent") {
  CHECK(dependent(MatrixXd::Zero(0, 3)) == std::vector<int>{0, 1, 2});
}

TEST_CASE("more columns than rows: at least the difference is dependent") {
  Random random(104);
  for (int repetition = 0; repetition < 10; ++repetition) {
    const MatrixXd A = sparse(6, random.integer(7, 15), random);
    check_dependent(A);
    CHECK(static_cast<int>(dependent(A).size()) >= A.cols() - 6);
  }
}

TEST_CASE("columns that differ by less than the tolerance are dependent, by more independent") {
  Random random(105);
  MatrixXd A = random.matrix(8, 3);
  A.col(2) = A.col(0) + 1e-11 * random.vector(8);
  CHECK(dependent(A).size() == 1);
  A.col(2) = A.col(0) + 1e-6 * random.vector(8);
  CHECK(dependent(A).empty());
}

TEST_CASE("what is independent in a column that nearly depends on the others is known") {
  Random random(106);
  block::KeptOrders orders;
  for (const double part : {1e-4, 1e-6, 1e-8}) {
    MatrixXd A = MatrixXd::Identity(8, 6);
    A.col(2) = A.col(0) + part * A.col(2) + 0.5 * A.col(5);
    A.bottomRows(2).setZero();
    A(5, 5) = 1.0;
    const ColumnRank found = rank_of_columns(A.sparseView(0.0, 0.0), tolerance, {0, 1, 2, 3, 4, 5}, orders);
    CHECK(found.dependent.empty());
    REQUIRE(found.weak.size() == 1);
    CHECK((found.weak[0].column == 2 || found.weak[0].column == 0 || found.weak[0].column == 5));
    CHECK(found.weak[0].part == doctest::Approx(part / A.colwise().norm().maxCoeff()).epsilon(0.6));
  }
  CHECK(rank_of_columns(random.matrix(8, 4).sparseView(0.0, 0.0), tolerance, {0, 1, 2, 3}, orders).weak.empty());
}

TEST_CASE("entries at the same place add up") {
  CHECK(dependent_columns(1, 1, {{0, 0, 1.0}, {0, 0, -1.0}}, tolerance) == std::vector<int>{0});
  CHECK(dependent_columns(1, 1, {{0, 0, 1.0}, {0, 0, 1.0}}, tolerance).empty());
}

TEST_CASE("rows with entries in most columns are taken last and change nothing") {
  Random random(106);
  const int blocks = 90, dense = 4;  // 3 columns each on 4 rows of its own, and all on the dense rows
  for (int repetition = 0; repetition < (sanitized ? 1 : 6); ++repetition) {
    MatrixXd A = MatrixXd::Zero(4 * blocks + dense, 3 * blocks);
    for (int k = 0; k < blocks; ++k) A.block(4 * k, 3 * k, 4, 3) = random.matrix(4, 3);
    A.bottomRows(dense) = random.matrix(dense, 3 * blocks);
    check_dependent(A);
    for (int k = 0; k < repetition + 3; ++k) {  // dependent but for the dense rows, or altogether
      const int column = 3 * random.integer(0, blocks - 1);
      A.col(column) = A.col(column + 1) + A.col(column + 2);
      if (k > 0) A.col(column).tail(dense) = random.vector(dense);
    }
    check_dependent(A);
    A.bottomRows(2) = A.middleRows(4 * blocks, 2);
    check_dependent(A);
  }
}

namespace {

/// Fours of columns of rank 2, two of them nearly equal; neighbors share rows.
MatrixXd nearly_equal(Random& random, int planes, double apart) {
  MatrixXd A = MatrixXd::Zero(8 * planes + 4, 4 * planes);
  for (int k = 0; k < planes; ++k) {
    const VectorXd a = random.vector(12).normalized(), other = random.vector(12).normalized();
    const VectorXd columns[] = {a, a + apart * other, 0.3 * a - 0.7 * other, 0.6 * a + 0.5 * other};
    const int turn = random.integer(0, 3);
    for (int j = 0; j < 4; ++j) A.block(8 * k, 4 * k + j, 12, 1) = columns[(j + turn) % 4];
  }
  return A;
}

}  // namespace

TEST_CASE("roundoff by columns that are nearly equal is not taken for independence") {
  Random random(108);
  for (const double apart : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
    for (int repetition = 0; repetition < 10; ++repetition) {
      const int planes = random.integer(1, repetition == 9 ? 200 : 12);
      CAPTURE(apart);
      CAPTURE(planes);
      CHECK(static_cast<int>(dependent(nearly_equal(random, planes, apart)).size()) == 2 * planes);
    }
}

#if LINKWORK_WITH_GPL

namespace {

/// A chain of blocks of columns that share rows with the next, all on the dense rows below; of some columns only a part
/// of length `gap` is independent of others.
MatrixXd chain_with_gaps(int blocks, int dense, int planted, double gap, Random& random) {
  MatrixXd A = MatrixXd::Zero(4 * blocks + 6 + dense, 3 * blocks);
  for (int k = 0; k < blocks; ++k) A.block(4 * k, 3 * k, 8, 3) = random.matrix(8, 3);
  A.bottomRows(dense) = random.matrix(dense, 3 * blocks);
  for (double& value : A.reshaped())
    if (random.number() > 0.5) value = 0.0;
  A.colwise().normalize();
  for (int k = 0; k < planted; ++k) {
    const int first = 3 * random.integer(1, blocks - 2);
    A.col(first) =
        (A.col(first - 1) - 2.0 * A.col(first + 1)).normalized() + gap * random.vector(A.rows()).normalized();
  }
  return A;
}

}  // namespace

TEST_CASE("gaps on both sides of the tolerance are decided as SPQR decides them") {
  Random random(107);
  for (int repetition = 0; repetition < 90; ++repetition) {
    const int blocks = random.integer(4, 40), dense = repetition % 3 == 0 ? 4 : 0;
    const double gap = std::pow(10.0, -6.0 - 0.1 * random.integer(0, 60));
    if (gap > 2e-10 && gap < 2e-8)
      continue;  // a choice between a few times the tolerance and less depends on the order
    CAPTURE(gap);
    const MatrixXd A = chain_with_gaps(blocks, dense, random.integer(1, 3), gap, random);
    CHECK(dependent(A).size() == spqr_dependent_columns(A.sparseView(0.0, 0.0), tolerance).size());
  }
}

#endif
