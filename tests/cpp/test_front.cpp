#include "linkwork/linear/qr/front.hpp"

#include "support.hpp"

using namespace support;

namespace {

struct Factored {
  MatrixXd R;            ///< rows of R, what stands left of their column zeroed
  std::vector<int> row;  ///< of R, of each column, or -1
};

Factored factor(MatrixXd A, int pivots, double tolerance) {
  const auto rows = static_cast<int>(A.rows()), columns = static_cast<int>(A.cols());
  const std::vector<int> stair(columns, rows);
  Factored out{MatrixXd(), std::vector<int>(columns, -2)};
  std::vector<double> workspace(qr::workspace_size(rows, columns));
  qr::front_factorization()({.entries = A.data(),
                             .stride = rows,
                             .columns = columns,
                             .pivots = pivots,
                             .stair = stair.data(),
                             .tolerance = tolerance,
                             .row = out.row.data(),
                             .workspace = workspace.data()});
  int count = 0;
  for (int c = 0; c < columns; ++c)
    if (out.row[c] >= 0) A.row(count++).head(c).setZero();
  out.R = A.topRows(count);
  return out;
}

}  // namespace

TEST_CASE("R^T R = A^T A, with and without panels") {
  Random random(61);
  for (const int columns : {3, 24, 70}) {
    const MatrixXd A = random.matrix(columns + 30, columns);
    const Factored found = factor(A, columns, 1e-9);
    CHECK(found.R.rows() == columns);
    CHECK(relative_error(MatrixXd(found.R.transpose() * found.R), MatrixXd(A.transpose() * A)) < 1e-13);
  }
}

TEST_CASE("columns that are combinations of those before them take no row of R") {
  Random random(62);
  MatrixXd A = random.matrix(60, 40);
  const std::vector<int> dependent = {7, 25, 39};
  for (const int column : dependent) A.col(column) = A.leftCols(column) * random.vector(column);
  const Factored found = factor(A, 40, 1e-9);
  for (int column = 0; column < 40; ++column)
    CHECK((found.row[column] < 0) == std::binary_search(dependent.begin(), dependent.end(), column));
  CHECK(found.R.rows() == 37);
  CHECK(relative_error(MatrixXd(found.R.transpose() * found.R), MatrixXd(A.transpose() * A)) < 1e-12);
}
