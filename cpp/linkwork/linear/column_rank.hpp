#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linkwork/linear/block/kept_orders.hpp"

namespace linkwork {

struct Entry {
  int row, column;
  double value;
};

/// Columns of A (compressed) that depend on the others, ascending, found by a rank-revealing sparse QR: their number is
/// columns - rank. `tolerance` is relative to the largest column. `groups`, where given, ascend from 0: equal numbers
/// for columns that have much the same rows, which takes less time to order. `orders`: where their order is kept.
std::vector<int> dependent_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                                   const std::vector<int>& groups, block::KeptOrders& orders);
std::vector<int> dependent_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                                   const std::vector<int>& groups = {});
/// The same of entries, which add up where they have the same place.
std::vector<int> dependent_columns(int rows, int columns, const std::vector<Entry>& entries, double tolerance);

}  // namespace linkwork
