#include "linkwork/linear/column_rank.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseQR>
#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>

#if LINKWORK_WITH_GPL
#include <SuiteSparseQR.hpp>
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
  for (Eigen::Index c = 0; c < A.cols(); ++c) largest = std::max(largest, A.col(c).norm());
  return largest;
}

#if LINKWORK_WITH_GPL

std::vector<int> dead_columns(Matrix& A, double tolerance) {
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  cholmod_common common;
  cholmod_l_start(&common);
  common.print = 0;
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
  auto* qr = SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, tolerance, &view, &common);
  if (!qr) {
    cholmod_l_finish(&common);
    throw std::bad_alloc();
  }
  // Columns with a pivot among the singletons are live; SPQR marks the dead ones of the rest.
  std::vector<char> live(static_cast<std::size_t>(A.cols()), 0);
  for (SuiteSparse_long k = 0; k < qr->n1rows; ++k) live[static_cast<std::size_t>(qr->R1j[qr->R1p[k]])] = 1;
  std::vector<int> dead;
  for (SuiteSparse_long k = 0; k < qr->n1cols; ++k)
    if (!live[static_cast<std::size_t>(k)]) dead.push_back(static_cast<int>(qr->Q1fill ? qr->Q1fill[k] : k));
  if (qr->rank < A.cols())
    for (SuiteSparse_long k = qr->n1cols; k < A.cols(); ++k)
      if (qr->QRnum->Rdead[k - qr->n1cols]) dead.push_back(static_cast<int>(qr->Q1fill ? qr->Q1fill[k] : k));
  const bool consistent = static_cast<std::int64_t>(dead.size()) == A.cols() - qr->rank;
  SuiteSparseQR_free<double>(&qr, &common);
  cholmod_l_finish(&common);
  if (!consistent) throw std::logic_error("SPQR: the dead columns are not columns - rank");
  return dead;
}

#else

std::vector<int> dead_columns(Matrix& A, double tolerance) {
  Eigen::SparseMatrix<double> B = A;
  B.makeCompressed();
  Eigen::SparseQR<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> qr;
  qr.setPivotThreshold(tolerance);
  qr.compute(B);
  std::vector<int> dead;
  for (Eigen::Index k = qr.rank(); k < B.cols(); ++k) dead.push_back(qr.colsPermutation().indices()[k]);
  return dead;
}

#endif

}  // namespace

std::vector<int> dependent_columns(int rows, int columns, std::vector<Entry> entries, double tolerance) {
  if (columns == 0) return {};
  Matrix A = assemble(rows, columns, entries);
  entries = {};
  const double largest = largest_column(A);
  std::vector<int> dead(static_cast<std::size_t>(columns));
  std::iota(dead.begin(), dead.end(), 0);
  if (largest > 0.0) dead = dead_columns(A, tolerance * largest);
  std::sort(dead.begin(), dead.end());
  return dead;
}

}  // namespace linkwork
