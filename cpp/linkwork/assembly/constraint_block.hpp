#pragma once

#include <cstddef>

namespace linkwork {

/// One dense block of D: the rows of a joint, the columns of one of its bodies.
/// Values stand row after row (rows x 6) at `offset` in Evaluation::D.
struct ConstraintBlock {
  int joint;
  int body;
  int row;   ///< first row
  int rows;  ///< number of rows
  std::ptrdiff_t offset;

  bool operator==(const ConstraintBlock&) const = default;
};

}  // namespace linkwork
