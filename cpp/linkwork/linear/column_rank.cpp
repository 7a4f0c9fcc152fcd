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
using ColumnMatrix = Eigen::Ref<const Eigen::SparseMatrix<double>>;

constexpr double most_dense = 4e7;  // numbers in dense rows
constexpr double weak = 1e-3;       // pivot, relative to the largest column: roundoff by it may look like a pivot

double largest_column(const ColumnMatrix& A) {
  if (A.rows() == 0) return 0.0;  // Eigen takes no norm of nothing
  double squares = 0.0;
  for (int column = 0; column < A.cols(); ++column) squares = std::max(squares, A.col(column).squaredNorm());
  return std::sqrt(squares);
}

/// Columns with one entry are eliminated with its row, one after the other: the first rows of R, without arithmetic.
/// What is left of A is a matrix of its own.
class SingletonElimination {
 public:
  SingletonElimination(const ColumnMatrix& A, qr::Pivots pivots)
      : A_(A), pivots_(pivots), by_rows_(A), row_left_(A.rows(), 1), column_left_(A.cols(), 1), count_(A.cols()) {
    for (int column = 0; column < A.cols(); ++column) {
      count(column) = A.outerIndexPtr()[column + 1] - A.outerIndexPtr()[column];
      if (count(column) <= 1) next_.push_back(column);
    }
    while (!next_.empty()) {
      const int column = next_.back();
      next_.pop_back();
      eliminate(column);
    }
  }

  const std::vector<int>& dead() const { return dead_; }
  const std::vector<ColumnRank::Weak>& weak() const { return weak_; }  ///< by small entries

  /// The rest, and the columns of A that it has.
  RowMatrix rest(std::vector<int>& columns) && {
    std::vector<int> number(column_left_.size(), -1);
    for (std::size_t column = 0; column < number.size(); ++column)
      if (column_left_[column]) {
        number[column] = static_cast<int>(columns.size());
        columns.push_back(static_cast<int>(column));
      }
    const auto rows = static_cast<Eigen::Index>(std::count(row_left_.begin(), row_left_.end(), 1));
    RowMatrix out;
    if (rows == A_.rows() && std::ssize(columns) == A_.cols()) {
      out.swap(by_rows_);  // matrices of Eigen 3.4 are copied where they are moved
      return out;
    }
    out.resize(rows, static_cast<Eigen::Index>(columns.size()));
    out.reserve(A_.nonZeros());
    int place = 0;
    for (int row = 0; row < A_.rows(); ++row) {
      if (!row_left_[row]) continue;
      out.startVec(place);
      for (RowMatrix::InnerIterator it(by_rows_, row); it; ++it)
        if (const int column = number[it.col()]; column >= 0) out.insertBack(place, column) = it.value();
      ++place;
    }
    out.finalize();
    return out;
  }

 private:
  int& count(int column) { return count_[column]; }

  void eliminate(int column) {
    column_left_[column] = 0;
    for (ColumnMatrix::InnerIterator it(A_, column); it; ++it) {
      auto& row_left = row_left_[it.row()];
      if (!row_left) continue;
      if (!(std::abs(it.value()) > pivots_.none)) break;
      row_left = 0;
      if (!(std::abs(it.value()) > pivots_.weak)) weak_.push_back({column, std::abs(it.value())});
      for (RowMatrix::InnerIterator other(by_rows_, it.row()); other; ++other)
        if (const int c = static_cast<int>(other.col()); column_left_[c] && --count(c) == 1) next_.push_back(c);
      return;
    }
    dead_.push_back(column);
  }

  const ColumnMatrix& A_;
  const qr::Pivots pivots_;
  std::vector<ColumnRank::Weak> weak_;
  RowMatrix by_rows_;
  std::vector<char> row_left_, column_left_;
  std::vector<int> count_;  ///< of each column that is left: entries in rows that are left
  std::vector<int> next_, dead_;
};

/// Rows with more entries than this are dense: their square would be costly.
int dense_row(Eigen::Index columns) {
  return static_cast<int>(std::clamp(4.0 * std::sqrt(static_cast<double>(columns)), 100.0, 400.0));
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

/// Takes rows out of A, which become rows of a full matrix.
MatrixXd take_out(const std::vector<int>& rows, RowMatrix& A) {
  MatrixXd out = MatrixXd::Zero(static_cast<Eigen::Index>(rows.size()), A.cols());
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (RowMatrix::InnerIterator it(A, rows[k]); it; ++it) out(static_cast<Eigen::Index>(k), it.col()) = it.value();
  if (!rows.empty())
    A.prune([&](Eigen::Index row, Eigen::Index, double) {
      return !std::binary_search(rows.begin(), rows.end(), static_cast<int>(row));
    });
  return out;
}

/// Dense rows would fill R. Of A = [S; F], F the dense rows, the sparse ones decide first: of the columns of S the
/// candidates S_c depend on the others, S_c = S_o L. Those are independent in A where F_c - F_o L is, which is what
/// eliminating F by the rows of R leaves of it. Rows of R with a weak pivot are taken for dense ones.
ColumnRank rank_of_rest(RowMatrix& A, const std::vector<int>& groups, qr::Pivots pivots, block::KeptOrders& orders) {
  MatrixXd F = take_out(dense_rows(A), A);
  std::vector<int> candidates = qr::dependent_columns(A, groups, pivots, F, orders);
  if (candidates.empty() || F.rows() == 0) return {std::move(candidates), {}};
  std::sort(candidates.begin(), candidates.end());
  MatrixXd rest(F.rows(), static_cast<Eigen::Index>(candidates.size()));
  for (std::size_t k = 0; k < candidates.size(); ++k) rest.col(static_cast<Eigen::Index>(k)) = F.col(candidates[k]);
  Eigen::ColPivHouseholderQR<MatrixXd> qr(rest);
  const double largest = qr.maxPivot();
  qr.setThreshold(largest > 0.0 ? pivots.none / largest : 1.0);
  const auto of = [&](Eigen::Index k) { return candidates[qr.colsPermutation().indices()[k]]; };
  ColumnRank out;
  for (Eigen::Index k = 0; k < rest.cols(); ++k) {
    if (k >= qr.rank()) out.dependent.push_back(of(k));
    else if (const double part = std::abs(qr.matrixQR()(k, k)); !(part > pivots.weak))
      out.weak.push_back({of(k), part});
  }
  return out;
}

/// Those of some columns, without gaps; one for each column where there are none.
std::vector<int> groups_of(const std::vector<int>& columns, const std::vector<int>& groups) {
  std::vector<int> out(columns.size(), 0);
  for (std::size_t k = 1; k < columns.size(); ++k) {
    const bool same = !groups.empty() && groups[columns[k]] == groups[columns[k - 1]];
    out[k] = out[k - 1] + (same ? 0 : 1);
  }
  return out;
}

}  // namespace

ColumnRank rank_of_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                           const std::vector<int>& groups, block::KeptOrders& orders) {
  const double largest = largest_column(A), none = tolerance * largest;
  const qr::Pivots pivots{none, std::max(weak * largest, none)};
  SingletonElimination singletons(A, pivots);
  ColumnRank out{singletons.dead(), singletons.weak()};
  std::vector<int> columns;
  RowMatrix rest = std::move(singletons).rest(columns);
  if (!columns.empty()) {
    const ColumnRank of_rest = rank_of_rest(rest, groups_of(columns, groups), pivots, orders);
    for (const int k : of_rest.dependent) out.dependent.push_back(columns[k]);
    for (const auto& [k, part] : of_rest.weak) out.weak.push_back({columns[k], part});
  }
  for (ColumnRank::Weak& it : out.weak) it.part /= largest;
  std::sort(out.dependent.begin(), out.dependent.end());
  return out;
}

std::vector<int> dependent_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                                   const std::vector<int>& groups) {
  block::KeptOrders orders;
  return rank_of_columns(A, tolerance, groups, orders).dependent;
}

std::vector<int> dependent_columns(int rows, int columns, const std::vector<Entry>& entries, double tolerance) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const Entry& entry : entries) triplets.emplace_back(entry.row, entry.column, entry.value);
  Eigen::SparseMatrix<double> A(rows, columns);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return dependent_columns(A, tolerance, {});
}

}  // namespace linkwork
