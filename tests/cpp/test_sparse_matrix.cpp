#include <doctest/doctest.h>

#include <map>

#include "linkwork/linear/sparse_matrix.hpp"
#include "support.hpp"

using namespace support;

namespace {

const std::vector<int> sizes = {6, 3, 1, 5};
const std::vector<BlockIndex> pattern = {{3, 1}, {0, 0}, {1, 1}, {0, 2}, {2, 0},
                                         {1, 3}, {2, 2}, {3, 3}, {0, 0}, {1, 3}};

int first_row(int block) {
  int first = 0;
  for (int k = 0; k < block; ++k) first += sizes[k];
  return first;
}

MatrixXd to_dense(const SparseMatrix& A) {
  MatrixXd dense = MatrixXd::Zero(A.size, A.size);
  for (int column = 0; column < A.size; ++column)
    for (int k = A.column_begin[column]; k < A.column_begin[column + 1]; ++k) dense(A.row[k], column) += A.value[k];
  return dense;
}

/// Writes random blocks into a block matrix and the same into a dense one, which it returns.
MatrixXd fill(BlockMatrix& matrix, Storage storage, Random& random) {
  MatrixXd dense = MatrixXd::Zero(15, 15);
  for (const BlockIndex& at : pattern) {
    if (storage == Storage::upper && at.row > at.column) continue;
    const auto rows = sizes[at.row], columns = sizes[at.column];
    const MatrixXd values = random.matrix(rows, columns);
    matrix.block(matrix.find(at.row, at.column)) = values;
    dense.block(first_row(at.row), first_row(at.column), rows, columns) = values;
  }
  return dense;
}

}  // namespace

TEST_CASE("blocks written into a block matrix stand where they stand in the dense matrix") {
  Random random(40);
  for (const Storage storage : {Storage::full, Storage::upper}) {
    BlockMatrix matrix(sizes, pattern, storage);
    const MatrixXd dense = fill(matrix, storage, random);
    CHECK(matrix.matrix().storage == storage);
    CHECK((to_dense(matrix.matrix()) - dense).norm() == 0.0);
  }
}

TEST_CASE("duplicate blocks count once, upper storage keeps row <= column") {
  CHECK(BlockMatrix(sizes, pattern, Storage::full).block_count() == 8);
  CHECK(BlockMatrix(sizes, pattern, Storage::upper).block_count() == 6);
  CHECK(BlockMatrix(sizes, pattern, Storage::full).matrix().value.size() == 36 + 9 + 1 + 25 + 2 * 6 + 2 * 15);
}

TEST_CASE("rows of every column ascend and columns end where the next begins") {
  const BlockMatrix matrix(sizes, pattern, Storage::full);
  const SparseMatrix& A = matrix.matrix();
  CHECK(A.size == 15);
  CHECK(A.column_begin.size() == 16);
  CHECK(A.column_begin.back() == static_cast<int>(A.row.size()));
  for (std::size_t column = 0; column < 15; ++column)
    for (int k = A.column_begin[column] + 1; k < A.column_begin[column + 1]; ++k) CHECK(A.row[k - 1] < A.row[k]);
}

TEST_CASE("find gives every block another place") {
  const BlockMatrix matrix(sizes, pattern, Storage::full);
  std::map<int, int> uses;
  for (const BlockIndex& at : {BlockIndex{0, 0}, {2, 0}, {1, 1}, {3, 1}, {0, 2}, {2, 2}, {1, 3}, {3, 3}})
    uses[matrix.find(at.row, at.column)] += 1;
  CHECK(uses.size() == 8);
  CHECK(uses.begin()->first == 0);
  CHECK(uses.rbegin()->first == 7);
}

TEST_CASE("mirror copies the transposed upper blocks into the lower ones") {
  Random random(41);
  BlockMatrix matrix(sizes, pattern, Storage::full);
  MatrixXd dense = fill(matrix, Storage::full, random);
  matrix.mirror();
  dense.block(9, 0, 1, 6) = dense.block(0, 9, 6, 1).transpose();
  dense.block(10, 6, 5, 3) = dense.block(6, 10, 3, 5).transpose();
  CHECK((to_dense(matrix.matrix()) - dense).norm() == 0.0);
}

TEST_CASE("set_zero clears the values and keeps the pattern") {
  Random random(42);
  BlockMatrix matrix(sizes, pattern, Storage::full);
  fill(matrix, Storage::full, random);
  const std::size_t nonzeros = matrix.matrix().row.size();
  matrix.set_zero();
  CHECK(to_dense(matrix.matrix()).norm() == 0.0);
  CHECK(matrix.matrix().row.size() == nonzeros);
}

TEST_CASE("a matrix without blocks is empty") {
  const BlockMatrix matrix({}, {}, Storage::upper);
  CHECK(matrix.matrix().size == 0);
  CHECK(matrix.matrix().column_begin == std::vector<int>{0});
}
