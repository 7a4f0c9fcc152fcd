#pragma once

#include <cholmod.h>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// The same numbers as CHOLMOD and SPQR see a dense matrix.
inline cholmod_dense dense_view(Eigen::Ref<MatrixXd> x) {
  cholmod_dense view{};
  view.nrow = x.rows();
  view.ncol = x.cols();
  view.d = x.outerStride();
  view.nzmax = view.d * view.ncol;
  view.x = x.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

/// A sparse matrix of compressed columns, rows ascending; `itype` is that of the indices.
inline cholmod_sparse sparse_view(std::size_t rows, std::size_t columns, std::size_t nonzeros, const void* begin,
                                  const void* row, const double* value, int itype) {
  cholmod_sparse view{};
  view.nrow = rows;
  view.ncol = columns;
  view.nzmax = nonzeros;
  view.p = const_cast<void*>(begin);
  view.i = const_cast<void*>(row);
  view.x = const_cast<double*>(value);
  view.itype = itype;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

}  // namespace linkwork
