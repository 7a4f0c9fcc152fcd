#pragma once

#include <vector>

namespace linkwork {

struct Entry {
  int row, column;
  double value;
};

/// Columns that depend on the others, ascending, found by rank-revealing sparse QR (SPQR, or Eigen's SparseQR in a
/// build without GPL parts): their number is columns - rank. `tolerance` is relative to the largest column.
std::vector<int> dependent_columns(int rows, int columns, std::vector<Entry> entries, double tolerance);

}  // namespace linkwork
