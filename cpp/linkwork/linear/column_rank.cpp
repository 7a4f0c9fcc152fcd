#include "linkwork/linear/column_rank.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "linkwork/linear/qr/sparse_qr.hpp"

namespace linkwork {
namespace {

using qr::RowMatrix;

constexpr double most_dense = 4e7;  // numbers in dense rows

double largest_column(const RowMatrix& A) {
  VectorXd squares = VectorXd::Zero(A.cols());
  for (int row = 0; row < A.rows(); ++row)
    for (RowMatrix::InnerIterator it(A, row); it; ++it) squares[it.col()] += it.value() * it.value();
  return squares.size() > 0 ? std::sqrt(squares.maxCoeff()) : 0.0;
}

/// Rows with more entries than this are dense: their square would be work.
int dense_row(Eigen::Index columns) {
  return static_cast<int>(std::clamp(10.0 * std::sqrt(static_cast<double>(columns)), 200.0, 1000.0));
}

/// Ascending; the longest ones where there are many.
std::vector<int> dense_rows(const RowMatrix& A) {
  const auto length = [&](int row) { return A.outerIndexPtr()[row + 1] - A.outerIndexPtr()[row]; };
  std::vector<int> rows;
  for (int row = 0; row < A.rows(); ++row)
    if (length(row) > dense_row(A.cols())) rows.push_back(row);
  const auto most = static_cast<std::size_t>(most_dense / static_cast<double>(A.cols() + 1));
  if (rows.size() > most) {
    std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) { return length(a) > length(b); });
    rows.resize(most);
    std::sort(rows.begin(), rows.end());
  }
  return rows;
}

/// A without some of its rows, and these.
std::pair<RowMatrix, MatrixXd> split(const RowMatrix& A, const std::vector<int>& dense) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(A.nonZeros()));
  MatrixXd full = MatrixXd::Zero(static_cast<Eigen::Index>(dense.size()), A.cols());
  auto next = dense.begin();
  for (int row = 0; row < A.rows(); ++row) {
    const bool is_dense = next != dense.end() && *next == row;
    for (RowMatrix::InnerIterator it(A, row); it; ++it) {
      if (is_dense) full(next - dense.begin(), it.col()) = it.value();
      else entries.emplace_back(row, static_cast<int>(it.col()), it.value());
    }
    if (is_dense) ++next;
  }
  RowMatrix rest(A.rows(), A.cols());
  rest.setFromTriplets(entries.begin(), entries.end());
  return {std::move(rest), std::move(full)};
}

/// Dense rows would fill R. Of A = [S; F], F the dense rows, the sparse ones decide first: of the columns of S the
/// candidates S_c depend on the others, S_c = S_o L. Those are independent in A where F_c - F_o L is, which is what
/// eliminating F by the rows of R leaves of it.
std::vector<int> dead_columns(const RowMatrix& A, const std::vector<int>& groups, const std::vector<int>& dense,
                              double tolerance) {
  auto [S, F] = split(A, dense);
  std::vector<int> candidates = qr::dependent_columns(S, groups, tolerance, F);
  if (candidates.empty()) return candidates;
  std::sort(candidates.begin(), candidates.end());
  MatrixXd rest(F.rows(), static_cast<Eigen::Index>(candidates.size()));
  for (std::size_t k = 0; k < candidates.size(); ++k) rest.col(static_cast<Eigen::Index>(k)) = F.col(candidates[k]);
  Eigen::ColPivHouseholderQR<MatrixXd> qr(rest);
  const double largest = qr.maxPivot();
  qr.setThreshold(largest > 0.0 ? tolerance / largest : 1.0);
  std::vector<int> dead;
  for (Eigen::Index k = qr.rank(); k < rest.cols(); ++k)
    dead.push_back(candidates[static_cast<std::size_t>(qr.colsPermutation().indices()[k])]);
  return dead;
}

}  // namespace

std::vector<int> dependent_columns(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, double tolerance,
                                   std::vector<int> groups) {
  if (groups.empty()) {
    groups.resize(static_cast<std::size_t>(A.cols()));
    std::iota(groups.begin(), groups.end(), 0);
  }
  std::vector<int> dead(static_cast<std::size_t>(A.cols()));
  std::iota(dead.begin(), dead.end(), 0);
  const double largest = largest_column(A);
  if (!(largest > 0.0)) return dead;
  dead = dead_columns(A, groups, dense_rows(A), tolerance * largest);
  std::sort(dead.begin(), dead.end());
  return dead;
}

std::vector<int> dependent_columns(int rows, int columns, const std::vector<Entry>& entries, double tolerance) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const Entry& entry : entries) triplets.emplace_back(entry.row, entry.column, entry.value);
  RowMatrix A(rows, columns);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return dependent_columns(A, tolerance);
}

}  // namespace linkwork
