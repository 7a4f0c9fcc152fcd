#pragma once

#include <cholmod.h>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// The same numbers as CHOLMOD and SPQR see a dense matrix.
inline cholmod_dense dense_view(Eigen::Ref<MatrixXd> x) {
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(x.rows());
  view.ncol = static_cast<std::size_t>(x.cols());
  view.d = static_cast<std::size_t>(x.outerStride());
  view.nzmax = view.d * view.ncol;
  view.x = x.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

}  // namespace linkwork
