#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "linkwork/linear/sparse_lu.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// A sparse matrix (m, n) as dense and as values over its pattern; rows beyond n are sums of the others.
struct Sample {
  Sample(int n, int dependent, Random& random) : A(MatrixXd::Zero(n + dependent, n)) {
    for (int row = 0; row < n; ++row) {
      A(row, (row + 3) % n) = 1.0 + random.number(0.0, 1.0);
      for (int k = 0; k < 3; ++k) A(row, random.integer(0, n - 1)) = random.number();
    }
    for (int row = n; row < n + dependent; ++row) A.row(row) = A.row(row - n) - 2.0 * A.row((2 * row) % n);
  }
  SparseLu lu() const {
    std::vector<int> begin{0}, rows;
    for (int column = 0; column < A.cols(); ++column) {
      for (int row = 0; row < A.rows(); ++row)
        if (A(row, column) != 0.0) rows.push_back(row);
      begin.push_back(static_cast<int>(rows.size()));
    }
    return SparseLu(static_cast<int>(A.rows()), begin, rows);
  }
  /// Of a matrix with the same pattern.
  std::vector<double> values(const MatrixXd& other) const {
    std::vector<double> out;
    for (int column = 0; column < A.cols(); ++column)
      for (int row = 0; row < A.rows(); ++row)
        if (A(row, column) != 0.0) out.push_back(other(row, column));
    return out;
  }
  MatrixXd A;
};

}  // namespace

TEST_CASE("a consistent system of more rows than unknowns is solved, and its transpose") {
  Random random(3);
  for (const int n : {1, 6, 30, 120}) {
    const Sample sample(n, n > 1 ? 3 : 0, random);
    SparseLu lu = sample.lu();
    const VectorXd x = random.vector(n);
    VectorXd found(n), y(sample.A.rows());
    for (int pass = 0; pass < 3; ++pass) {
      const MatrixXd A = sample.A * (1.0 + 0.5 * pass);
      CHECK((pass == 0 ? lu.factorize(sample.values(A)) : lu.refactorize(sample.values(A))));
      lu.solve(A * x, found);
      CHECK((found - x).norm() < 1e-11 * (1.0 + x.norm()));
      lu.solve_transposed(x, y);
      CHECK((A.transpose() * y - x).norm() < 1e-11 * (1.0 + x.norm()));
    }
  }
}

TEST_CASE("the sign tells that the determinant has passed zero") {
  Random random(5);
  const Sample start(24, 0, random);
  MatrixXd direction = MatrixXd::Zero(24, 24);  // so that the determinant is linear
  direction.row(5) = (start.A.row(5).array() != 0.0).select(random.vector(24).transpose(), 0.0);
  SparseLu lu = start.lu();
  REQUIRE(lu.factorize(start.values(start.A)));
  const double first = dense_determinant(start.A);
  const int sign = lu.sign();
  int passed = 0;
  for (int k = -100; k <= 100; ++k) {
    const MatrixXd A = start.A + 0.2 * k * direction;
    if (!lu.refactorize(start.values(A))) {  // too near to zero for these pivots
      REQUIRE(lu.factorize(start.values(start.A)));
      continue;
    }
    CHECK((lu.sign() == sign) == (dense_determinant(A) * first > 0.0));
    passed += lu.sign() != sign;
  }
  CHECK(passed > 0);
}

TEST_CASE("a matrix whose columns depend on each other has no factors") {
  Random random(7);
  Sample sample(12, 2, random);
  SparseLu lu = sample.lu();
  CHECK(lu.factorize(sample.values(sample.A)));
  MatrixXd singular = sample.A;
  singular.col(4).setZero();
  CHECK_FALSE(lu.refactorize(sample.values(singular)));
  CHECK_FALSE(lu.factorize(sample.values(singular)));
  CHECK(lu.factorize(sample.values(sample.A)));
}

TEST_CASE("pivots that have become small are refused until others are chosen") {
  std::vector<double> values = {1.0, 1.0, 1.0, -1.0};
  SparseLu lu(2, {0, 2, 4}, {0, 1, 0, 1});
  REQUIRE(lu.factorize(values));
  bool refused = false;
  for (const int place : {0, 1}) {  // one of them is the pivot
    std::vector<double> other = values;
    other[place] = 1e-6;
    refused = refused || !lu.refactorize(other);
    CHECK(lu.factorize(other));
    REQUIRE(lu.factorize(values));
  }
  CHECK(refused);
}
