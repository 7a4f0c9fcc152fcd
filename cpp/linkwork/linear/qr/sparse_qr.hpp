#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork::qr {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Lengths of the part of a column that is independent of the columns before it.
struct Pivots {
  double none;  ///< no longer than that: it depends on them
  double weak;  ///< no longer than that: the columns at the end may say that it does
};

/// Columns of A that depend on the others, or barely do not, in no order. `groups`, one number per column, ascending
/// from 0: columns that have much the same rows; they are ordered together.
///
/// `dense`, rows over the columns of A that are not rows of A, become dense - X R with X R = dense in the other columns:
/// zero there, and in the listed ones what these do not say about them. The rows of R of columns that are barely
/// independent, if they are not too many, are added to the dense ones; where no row is dense then, all that are listed
/// depend on the others.
///
/// Multifrontal Householder QR on the elimination tree of A^T A (J. W. H. Liu, On general row merging schemes for
/// sparse Givens transformations, SIAM J. Sci. Stat. Comput. 7, 1986), dense fronts, neither Q nor R kept. The order of
/// the groups is one of `orders`.
std::vector<int> dependent_columns(const RowMatrix& A, const std::vector<int>& groups, Pivots pivots, MatrixXd& dense,
                                   block::KeptOrders& orders);

}  // namespace linkwork::qr
