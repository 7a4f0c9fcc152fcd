#include "linkwork/linear/qr/sparse_qr.hpp"

#include <numeric>

#include "support.hpp"

using namespace support;

namespace {

/// Random, nine of ten entries zero but for the diagonal; column c = the sum of columns a and b with these weights.
struct Planted {
  MatrixXd A;
  int a = 2, b = 5, c = 9;
  double w_a = 0.7, w_b = -1.3;

  explicit Planted(std::uint64_t seed) {
    Random random(seed);
    A = random.matrix(30, 14);
    for (double& value : A.reshaped())
      if (random.number() < 0.8) value = 0.0;
    A.diagonal().array() += 2.0;
    A.col(c) = w_a * A.col(a) + w_b * A.col(b);
  }
};

std::vector<int> dependent(const MatrixXd& A, MatrixXd& dense, const std::vector<int>& groups, double weak = 1e-9) {
  block::KeptOrders orders;
  qr::RowMatrix sparse = A.sparseView();
  sparse.makeCompressed();
  return qr::dependent_columns(sparse, groups, {1e-9, weak}, dense, orders);
}

std::vector<int> each_alone(const MatrixXd& A) {
  std::vector<int> groups(A.cols());
  std::iota(groups.begin(), groups.end(), 0);
  return groups;
}

}  // namespace

TEST_CASE("a column that is planted as a combination is found, as one of those in it") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Planted planted(seed);
    MatrixXd none(0, planted.A.cols());
    const std::vector<int> found = dependent(planted.A, none, each_alone(planted.A));
    REQUIRE(found.size() == 1);
    CHECK((found[0] == planted.a || found[0] == planted.b || found[0] == planted.c));
  }
}

TEST_CASE("columns that are ordered together have the same rank") {
  const Planted planted(21);
  std::vector<int> pairs;
  for (int column = 0; column < planted.A.cols(); ++column) pairs.push_back(column / 2);
  MatrixXd none(0, planted.A.cols());
  CHECK(dependent(planted.A, none, pairs).size() == 1);
}

TEST_CASE("dense rows become what A does not say of them: zero in independent columns, for combinations of rows all") {
  const Planted planted(22);
  Random random(23);
  MatrixXd dense(2, planted.A.cols());
  dense.row(0) = random.vector(30).transpose() * planted.A;
  dense.row(1) = random.vector(planted.A.cols()).transpose();
  const MatrixXd given = dense;
  const std::vector<int> found = dependent(planted.A, dense, each_alone(planted.A));
  REQUIRE(found.size() == 1);
  const double size = given.cwiseAbs().maxCoeff();
  CHECK(dense.topRows(1).cwiseAbs().maxCoeff() < 1e-12 * size);
  // A z = 0 for z = w_a e_a + w_b e_b - e_c, and X R z = 0 likewise: dense z stays what it was.
  VectorXd z = VectorXd::Zero(planted.A.cols());
  z[planted.a] = planted.w_a;
  z[planted.b] = planted.w_b;
  z[planted.c] = -1.0;
  CHECK((planted.A * z).norm() < 1e-14);
  CHECK(dense.row(1).dot(z) == doctest::Approx(given.row(1).dot(z)).epsilon(1e-10));
  for (int column = 0; column < planted.A.cols(); ++column)
    if (column != found[0]) CHECK(std::abs(dense(1, column)) < 1e-12 * size);
}

TEST_CASE("columns that are barely independent are listed, and dense rows say by what") {
  Random random(24);
  MatrixXd A = random.matrix(12, 6);
  const VectorXd apart = random.vector(12);
  A.col(4) = A.col(1) + 1e-6 * apart;
  MatrixXd dense(0, A.cols());
  const std::vector<int> found = dependent(A, dense, each_alone(A), 1e-4);
  REQUIRE(found.size() == 1);
  REQUIRE(dense.rows() == 1);
  const MatrixXd others = A(Eigen::all, std::vector<int>{0, found[0] == 1 ? 4 : 1, 2, 3, 5});
  const VectorXd part = apart - others * others.householderQr().solve(apart);
  CHECK(std::abs(dense(0, found[0])) == doctest::Approx(1e-6 * part.norm()).epsilon(1e-5));
}
