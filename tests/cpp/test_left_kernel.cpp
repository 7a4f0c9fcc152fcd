#include "linkwork/linear/qr/left_kernel.hpp"

#include "dense_algebra.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// A row of blocks, each on the columns of two neighbors, as joints between bodies have them.
MatrixXd band(Random& random, int blocks, int rows, int columns) {
  MatrixXd A = MatrixXd::Zero(blocks * rows, (blocks + 1) * columns);
  for (int k = 0; k < blocks; ++k) A.block(k * rows, k * columns, rows, 2 * columns) = random.matrix(rows, 2 * columns);
  return A;
}

MatrixXd rows_of(const MatrixXd& A, const std::vector<int>& rows) {
  MatrixXd out(static_cast<Eigen::Index>(rows.size()), A.cols());
  for (std::size_t k = 0; k < rows.size(); ++k) out.row(static_cast<Eigen::Index>(k)) = A.row(rows[k]);
  return out;
}

qr::RowMatrix sparse(const MatrixXd& A) { return A.sparseView(); }

void check_kernel(const MatrixXd& N, const MatrixXd& A, Eigen::Index dimension) {
  REQUIRE(N.rows() == A.rows());
  REQUIRE(N.cols() == dimension);
  CHECK(relative_error(MatrixXd(N.transpose() * N), MatrixXd(MatrixXd::Identity(dimension, dimension))) < 1e-13);
  CHECK((N.transpose() * A).cwiseAbs().maxCoeff() < 1e-13 * A.norm());
}

}  // namespace

TEST_CASE("the left kernel of dependent rows is orthonormal and as large as they are many, in any order of the rows") {
  Random random(81);
  MatrixXd A = band(random, 6, 5, 6);
  A.row(7) = 0.3 * A.row(8) - 2.0 * A.row(12);
  A.row(21) = A.row(4) + A.row(17) + A.row(25);
  qr::LeftKernel kernel;
  std::vector<int> rows(30);
  for (int k = 0; k < 30; ++k) rows[k] = (11 * k + 3) % 30;
  for (int again = 0; again < 2; ++again) check_kernel(kernel.of(sparse(A), rows, 1e-9), rows_of(A, rows), 2);
}

TEST_CASE("left kernels of different rows follow each other, with rows of zeros, of panels, and none at all") {
  Random random(82);
  MatrixXd A = band(random, 30, 5, 6);
  A.row(3).setZero();
  A.row(100) = A.row(99);
  qr::LeftKernel kernel;
  std::vector<int> all(150);
  for (int k = 0; k < 150; ++k) all[k] = k;
  const qr::RowMatrix D = sparse(A);
  check_kernel(kernel.of(D, {2, 3, 4}, 1e-9), rows_of(A, {2, 3, 4}), 1);
  check_kernel(kernel.of(D, all, 1e-9), A, 2);
  check_kernel(kernel.of(D, {99, 50, 100}, 1e-9), rows_of(A, {99, 50, 100}), 1);
  CHECK(kernel.of(D, {3}, 1e-9) == MatrixXd::Identity(1, 1));
  CHECK(kernel.of(D, {50, 51}, 1e-9).cols() == 0);
  CHECK(kernel.of(D, {}, 1e-9).size() == 0);
}

TEST_CASE("what is left of a column counts relative to the largest") {
  MatrixXd A = MatrixXd::Identity(3, 3);
  A(2, 2) = 1e-8;
  for (const double scale : {1e-12, 1.0, 1e12}) {
    qr::LeftKernel kernel;
    CHECK(kernel.of(sparse(scale * A), {0, 1, 2}, 1e-9).cols() == 0);
    CHECK(kernel.of(sparse(scale * A), {0, 1, 2}, 1e-7).cols() == 1);
  }
}
