#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork::qr {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Columns of A that depend on the others, in no order: those of which, in the order of elimination, a part not longer
/// than `tolerance` is independent of the columns before. `groups`, one number per column, ascending from 0: columns
/// that have much the same rows; they are ordered together.
///
/// `dense`, rows over the columns of A that are not rows of A, become dense - X R with X R = dense in the independent
/// columns: zero there, and in the dependent ones what A does not say about them. With dense rows, columns that are
/// barely independent count among the dependent ones, and the rows of R that say so are added to the dense ones.
///
/// Multifrontal Householder QR on the elimination tree of A^T A (J. W. H. Liu, On general row merging schemes for
/// sparse Givens transformations, SIAM J. Sci. Stat. Comput. 7, 1986), dense fronts, neither Q nor R kept.
std::vector<int> dependent_columns(const RowMatrix& A, const std::vector<int>& groups, double tolerance,
                                   MatrixXd& dense);

}  // namespace linkwork::qr
