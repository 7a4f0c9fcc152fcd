#pragma once

#include <cstddef>

#include "linkwork/math/instruction_set.hpp"

namespace linkwork::qr {

/// A dense matrix on its way to R, column after column. Its rows are sorted by the column of their first entry: column
/// k is zero below row stair[k] (not descending).
struct Front {
  double* entries;        ///< column-major
  std::ptrdiff_t stride;  ///< rows of memory from column to column
  int columns;
  int pivots;         ///< the first columns, which are complete and may turn out to depend on those before them
  const int* stair;   ///< per column
  double tolerance;   ///< length of what is left of a column that depends on those before it
  int* row;           ///< out, per column: its row of R, or -1 where it depends on those before it or has none
  double* workspace;  ///< workspace_size of them
};

/// Columns that are gathered before the others follow them.
constexpr int panel = 24;

constexpr std::size_t workspace_size(std::size_t rows, std::size_t columns) {
  return panel * (rows + 2 * columns + 2 * panel);
}

/// Householder's transformations, one for each column that is none of the dependent ones (M. T. Heath, Some extensions
/// of an algorithm for sparse linear least squares problems, SIAM J. Sci. Stat. Comput. 3, 1982): these become zero
/// from the next row of R on and take no row. Row k of R begins in the column that has it; what stands left of that is
/// not zeroed.
using FactorFront = void (*)(const Front&);

/// For the widest instruction set of this processor.
FactorFront front_factorization();

}  // namespace linkwork::qr
