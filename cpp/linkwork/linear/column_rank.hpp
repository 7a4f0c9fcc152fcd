#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linkwork/linear/block/kept_orders.hpp"

namespace linkwork {

struct Entry {
  int row, column;
  double value;
};

/// Columns that depend on others, and those that nearly do.
struct ColumnRank {
  std::vector<int> dependent;  ///< ascending: columns - rank
  /// Of the others, what is independent in a column, relative to the largest column, where it is found to be small.
  struct Weak {
    int column;
    double part;
  };
  std::vector<Weak> weak;
};

/// Of A (compressed), by a rank-revealing sparse QR. `tolerance` is relative to the largest column. `groups`, where
/// given, ascend from 0: equal numbers for columns that have much the same rows, which takes less time to order.
/// `orders`: where their order is kept.
ColumnRank rank_of_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                           const std::vector<int>& groups, block::KeptOrders& orders);
/// The dependent ones alone.
std::vector<int> dependent_columns(const Eigen::Ref<const Eigen::SparseMatrix<double>>& A, double tolerance,
                                   const std::vector<int>& groups = {});
/// The same of entries, which add up where they have the same place.
std::vector<int> dependent_columns(int rows, int columns, const std::vector<Entry>& entries, double tolerance);

}  // namespace linkwork
