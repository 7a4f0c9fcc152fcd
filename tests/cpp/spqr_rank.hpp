#pragma once

// The reference of the rank service: SuiteSparse's rank-revealing sparse QR.
#if LINKWORK_WITH_GPL

#include <SuiteSparseQR.hpp>
#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

#include "linkwork/linear/backends/cholmod_view.hpp"
#include "linkwork/math/types.hpp"

namespace support {

/// Columns of A that depend on the others, ascending; `tolerance` relative to the largest column.
inline std::vector<int> spqr_dependent_columns(const Eigen::SparseMatrix<double>& given, double tolerance) {
  Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t> A = given;
  A.makeCompressed();
  static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));
  double largest = 0.0;
  for (Eigen::Index c = 0; c < A.cols() && A.rows() > 0; ++c) largest = std::max(largest, A.col(c).norm());
  cholmod_common common;
  cholmod_l_start(&common);
  common.print = 0;
  cholmod_sparse view = linkwork::sparse_view(A.rows(), A.cols(), A.nonZeros(), A.outerIndexPtr(), A.innerIndexPtr(),
                                              A.valuePtr(), CHOLMOD_LONG);
  auto* qr = SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, tolerance * largest, &view, &common);
  if (!qr) throw std::bad_alloc();
  // Columns with a pivot among the singletons are live; SPQR marks the dead ones of the rest.
  std::vector<char> live(A.cols(), 0);
  for (SuiteSparse_long k = 0; k < qr->n1rows; ++k) live[qr->R1j[qr->R1p[k]]] = 1;
  const auto original = [&](SuiteSparse_long k) { return static_cast<int>(qr->Q1fill ? qr->Q1fill[k] : k); };
  std::vector<int> dead;
  for (SuiteSparse_long k = 0; k < qr->n1cols; ++k)
    if (!live[k]) dead.push_back(original(k));
  if (qr->rank < A.cols())
    for (SuiteSparse_long k = qr->n1cols; k < A.cols(); ++k)
      if (qr->QRnum->Rdead[k - qr->n1cols]) dead.push_back(original(k));
  if (static_cast<std::int64_t>(dead.size()) != A.cols() - qr->rank)
    throw std::logic_error("SPQR: the dead columns are not columns - rank");
  std::sort(dead.begin(), dead.end());
  SuiteSparseQR_free<double>(&qr, &common);
  cholmod_l_finish(&common);
  return dead;
}

}  // namespace support

#endif
