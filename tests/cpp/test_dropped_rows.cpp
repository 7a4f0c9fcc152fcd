#include "linkwork/constraints/dropped_rows.hpp"

#include "mechanisms.hpp"

using namespace support;

TEST_CASE("dropped rows leave D as zeros and come back as they were") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const MatrixXd D = dense_D(system, at);
  DroppedRows dropped(system, {2, 9, 13});
  dropped.take_out(at);
  MatrixXd without = D;
  for (const int row : {2, 9, 13}) without.row(row).setZero();
  CHECK(dense_D(system, at) == without);
  dropped.put_back(at);
  CHECK(dense_D(system, at) == D);
}

TEST_CASE("products with the dropped rows are those with rows of D") {
  Random random(11);
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  const MatrixXd D = dense_D(system, at);
  DroppedRows dropped(system, {0, 7, 19});
  dropped.take_out(at);
  MatrixXd D_d(3, D.cols());
  D_d << D.row(0), D.row(7), D.row(19);
  const VectorXd x = random.vector(D.cols()), omega = random.vector(3), y = random.vector(D.cols());
  VectorXd product(3), sum = y;
  dropped.multiply(x, product);
  CHECK(relative_error(product, VectorXd(D_d * x)) < 1e-14);
  dropped.add_transposed(omega, sum);
  CHECK(relative_error(sum, VectorXd(y + D_d.transpose() * omega)) < 1e-14);
}

TEST_CASE("scatter and gather are each other's inverse, and a dropped right-hand side is zero") {
  Random random(12);
  const System system(four_bar());
  const DroppedRows dropped(system, {3, 4, 18});
  const VectorXd omega = random.vector(3);
  VectorXd lambda = random.vector(20), b = lambda, found(3);
  dropped.scatter(omega, lambda);
  dropped.gather(lambda, found);
  CHECK(found == omega);
  dropped.take_from(b);
  for (int row = 0; row < 20; ++row) CHECK((b[row] == 0.0) == (row == 3 || row == 4 || row == 18));
}

TEST_CASE("a hinge has three equations of translations and two of rotations") {
  const System system(four_bar());
  Evaluation at = evaluate_initially(system);
  DroppedRows dropped(system, {0, 1, 2, 3, 4});
  dropped.take_out(at);
  CHECK(dropped.translating() == std::vector<char>{1, 1, 1, 0, 0});
}
