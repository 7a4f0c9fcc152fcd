#include "linkwork/linear/column_rank.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>
#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "linkwork/math/types.hpp"

#if LINKWORK_WITH_GPL
#include <SuiteSparseQR.hpp>

#include "linkwork/linear/backends/cholmod_view.hpp"
#endif

namespace linkwork {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

Matrix assemble(int rows, int columns, const std::vector<Entry>& entries) {
  std::vector<Eigen::Triplet<double, std::int64_t>> triplets;
  triplets.reserve(entries.size());
  for (const Entry& entry : entries) triplets.emplace_back(entry.row, entry.column, entry.value);
  Matrix A(rows, columns);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

double largest_column(const Matrix& A) {
  double largest = 0.0;
  for (Eigen::Index c = 0; c < A.cols() && A.rows() > 0; ++c) largest = std::max(largest, A.col(c).norm());
  return largest;
}

#if LINKWORK_WITH_GPL

/// SuiteSparse's QR factorization A E = Q R.
class Factorization {
 public:
  Factorization(Matrix& A, double tolerance) : columns_(A.cols()) {
    static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
    cholmod_l_start(&common_);
    common_.print = 0;
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(A.rows());
    view.ncol = static_cast<std::size_t>(A.cols());
    view.nzmax = static_cast<std::size_t>(A.nonZeros());
    view.p = A.outerIndexPtr();
    view.i = A.innerIndexPtr();
    view.x = A.valuePtr();
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    qr_ = SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, tolerance, &view, &common_);
    if (!qr_) {
      cholmod_l_finish(&common_);
      throw std::bad_alloc();
    }
  }
  Factorization(const Factorization&) = delete;
  Factorization& operator=(const Factorization&) = delete;
  ~Factorization() {
    SuiteSparseQR_free<double>(&qr_, &common_);
    cholmod_l_finish(&common_);
  }

  /// Columns that depend on the others, in no order.
  std::vector<int> dead_columns() const {
    // Columns with a pivot among the singletons are live; SPQR marks the dead ones of the rest.
    std::vector<char> live(static_cast<std::size_t>(columns_), 0);
    for (SuiteSparse_long k = 0; k < qr_->n1rows; ++k) live[static_cast<std::size_t>(qr_->R1j[qr_->R1p[k]])] = 1;
    const auto original = [&](SuiteSparse_long k) { return static_cast<int>(qr_->Q1fill ? qr_->Q1fill[k] : k); };
    std::vector<int> dead;
    for (SuiteSparse_long k = 0; k < qr_->n1cols; ++k)
      if (!live[static_cast<std::size_t>(k)]) dead.push_back(original(k));
    if (qr_->rank < columns_)
      for (SuiteSparse_long k = qr_->n1cols; k < columns_; ++k)
        if (qr_->QRnum->Rdead[k - qr_->n1cols]) dead.push_back(original(k));
    if (static_cast<std::int64_t>(dead.size()) != columns_ - qr_->rank)
      throw std::logic_error("SPQR: the dead columns are not columns - rank");
    return dead;
  }

  /// The shortest X with A^T X = B; A has full column rank.
  MatrixXd shortest(MatrixXd B) {
    cholmod_dense view = dense_view(B);
    cholmod_dense* y = SuiteSparseQR_solve<double>(SPQR_RTX_EQUALS_ETB, qr_, &view, &common_);
    cholmod_dense* x = y ? SuiteSparseQR_qmult<double>(SPQR_QX, qr_, y, &common_) : nullptr;
    cholmod_l_free_dense(&y, &common_);
    if (!x) throw std::bad_alloc();
    MatrixXd X = Eigen::Map<const MatrixXd>(static_cast<const double*>(x->x), static_cast<Eigen::Index>(x->nrow),
                                            static_cast<Eigen::Index>(x->ncol));
    cholmod_l_free_dense(&x, &common_);
    return X;
  }

 private:
  Eigen::Index columns_;
  cholmod_common common_{};
  SuiteSparseQR_factorization<double>* qr_ = nullptr;
};

#else

class Factorization {
 public:
  Factorization(const Matrix& A, double tolerance) {
    Eigen::SparseMatrix<double> B = A;
    B.makeCompressed();
    qr_.setPivotThreshold(tolerance);
    qr_.compute(B);
  }

  std::vector<int> dead_columns() const {
    const auto& order = qr_.colsPermutation().indices();
    return {order.begin() + qr_.rank(), order.end()};
  }

  MatrixXd shortest(const MatrixXd& B) {
    const MatrixXd y = qr_.matrixR()
                           .topLeftCorner(B.rows(), B.rows())
                           .transpose()
                           .triangularView<Eigen::Lower>()
                           .solve(qr_.colsPermutation().transpose() * B);
    MatrixXd X = MatrixXd::Zero(qr_.rows(), B.cols());
    X.topRows(B.rows()) = y;
    return qr_.matrixQ() * X;
  }

 private:
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> qr_;
};

#endif

std::vector<int> dead_columns(Matrix& A, double tolerance) { return Factorization(A, tolerance).dead_columns(); }

/// A without the rows that `dense` marks, and these.
std::pair<Matrix, MatrixXd> split(const Matrix& A, const std::vector<int>& dense) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(static_cast<std::size_t>(A.nonZeros()));
  MatrixXd full = MatrixXd::Zero(static_cast<Eigen::Index>(dense.size()), A.cols());
  for (Eigen::Index column = 0; column < A.cols(); ++column)
    for (Matrix::InnerIterator it(A, column); it; ++it) {
      const auto place = std::lower_bound(dense.begin(), dense.end(), static_cast<int>(it.row())) - dense.begin();
      if (place < full.rows() && dense[static_cast<std::size_t>(place)] == it.row()) full(place, column) = it.value();
      else entries.emplace_back(it.row(), it.col(), it.value());
    }
  Matrix rest(A.rows(), A.cols());
  rest.setFromTriplets(entries.begin(), entries.end());
  return {std::move(rest), std::move(full)};
}

Matrix select_columns(const Matrix& A, const std::vector<int>& columns) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (Matrix::InnerIterator it(A, columns[k]); it; ++it)
      entries.emplace_back(it.row(), static_cast<std::int64_t>(k), it.value());
  Matrix out(A.rows(), static_cast<Eigen::Index>(columns.size()));
  out.setFromTriplets(entries.begin(), entries.end());
  return out;
}

/// Dense rows would fill R. Of A = [S; F], F the dense rows, the sparse ones decide first: of the columns of S the
/// candidates S_c depend on the others, S_c = S_o L. Those are independent in A where F_c - F_o L is, and with the
/// shortest X of S_o^T X = F_o^T this is F_c - X^T S_c: a solution for each dense row, however many candidates there
/// are.
std::vector<int> dead_columns(const Matrix& A, const std::vector<int>& dense, double tolerance) {
  auto [S, F] = split(A, dense);
  std::vector<int> candidates = dead_columns(S, tolerance);
  if (candidates.empty()) return candidates;
  std::sort(candidates.begin(), candidates.end());
  std::vector<int> others;
  for (int column = 0; column < A.cols(); ++column)
    if (!std::binary_search(candidates.begin(), candidates.end(), column)) others.push_back(column);
  MatrixXd rest(F.rows(), static_cast<Eigen::Index>(candidates.size()));
  for (std::size_t k = 0; k < candidates.size(); ++k) rest.col(static_cast<Eigen::Index>(k)) = F.col(candidates[k]);
  if (!others.empty()) {
    MatrixXd B(static_cast<Eigen::Index>(others.size()), F.rows());
    for (std::size_t k = 0; k < others.size(); ++k) B.row(static_cast<Eigen::Index>(k)) = F.col(others[k]).transpose();
    Matrix independent = select_columns(S, others);
    const MatrixXd X = Factorization(independent, 0.0).shortest(std::move(B));
    for (std::size_t k = 0; k < candidates.size(); ++k)
      for (Matrix::InnerIterator it(S, candidates[k]); it; ++it)
        rest.col(static_cast<Eigen::Index>(k)) -= it.value() * X.row(it.row()).transpose();
  }
  Eigen::ColPivHouseholderQR<MatrixXd> qr(rest);
  const double largest = qr.maxPivot();
  qr.setThreshold(largest > 0.0 ? tolerance / largest : 1.0);
  std::vector<int> dead;
  for (Eigen::Index k = qr.rank(); k < rest.cols(); ++k)
    dead.push_back(candidates[static_cast<std::size_t>(qr.colsPermutation().indices()[k])]);
  return dead;
}

/// Rows with more entries than this are dense: their square would be work.
Eigen::Index dense_row(Eigen::Index columns) {
  return std::clamp(static_cast<Eigen::Index>(10.0 * std::sqrt(columns)), Eigen::Index{200}, Eigen::Index{1000});
}

}  // namespace

std::vector<int> dependent_columns(int rows, int columns, std::vector<Entry> entries, double tolerance) {
  if (columns == 0) return {};
  Matrix A = assemble(rows, columns, entries);
  entries = std::vector<Entry>();
  const double largest = largest_column(A);
  std::vector<int> dead(static_cast<std::size_t>(columns));
  std::iota(dead.begin(), dead.end(), 0);
  if (largest > 0.0) {
    std::vector<Eigen::Index> count(static_cast<std::size_t>(rows), 0);
    for (Eigen::Index column = 0; column < columns; ++column)
      for (Matrix::InnerIterator it(A, column); it; ++it) ++count[static_cast<std::size_t>(it.row())];
    std::vector<int> dense;
    for (int row = 0; row < rows; ++row)
      if (count[static_cast<std::size_t>(row)] > dense_row(columns)) dense.push_back(row);
    dead = dense.empty() ? dead_columns(A, tolerance * largest) : dead_columns(A, dense, tolerance * largest);
  }
  std::sort(dead.begin(), dead.end());
  return dead;
}

}  // namespace linkwork
