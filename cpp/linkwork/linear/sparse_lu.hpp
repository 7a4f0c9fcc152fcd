#pragma once

#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// P A Q = L U for n independent rows of a sparse A (m, n), m >= n, which partial pivoting chooses; a solution of
/// A x = b meets these rows. Left-looking (J. R. Gilbert, T. Peierls, Sparse partial pivoting in time proportional to
/// arithmetic operations, SIAM J. Sci. Stat. Comput. 9, 1988), columns in COLAMD's order. A matrix with other values is
/// factorized with the same pivots, as long as they are large enough among the rows chosen.
class SparseLu {
 public:
  /// Where A has entries: rows of each column, by compressed columns.
  SparseLu(int rows, std::vector<int> begin, std::vector<int> row);

  /// With new pivots. False: A has no n independent rows; there is no solution.
  bool factorize(const std::vector<double>& values);
  /// With the pivots chosen before. False: one of them has become too small; there is no solution.
  bool refactorize(const std::vector<double>& values);

  void solve(const ConstVector& b, MutableVector x);             ///< A x = b in the chosen rows; b (m), x (n)
  void solve_transposed(const ConstVector& f, MutableVector y);  ///< A^T y = f, y zero in the others; f (n), y (m)

  /// The sign of the determinant of the chosen rows; it can be compared as long as these remain.
  int sign() const { return sign_; }
  std::size_t nonzeros() const { return L_.row.size() + U_.row.size() + diagonal_.size(); }

 private:
  struct Columns {
    std::vector<int> begin{0}, row;
    std::vector<double> value;
  };
  void order_columns();
  void reach(int column, std::vector<int>& nodes);
  int choose_pivot(const std::vector<int>& nodes) const;
  bool store_column(int k, const std::vector<int>& nodes);
  void number_by_pivots();
  void find_sign();

  int m_, n_;
  std::vector<int> begin_, row_;  ///< of A
  std::vector<int> order_;        ///< Q: the columns of A as they are eliminated
  std::vector<int> pivot_of_row_, row_of_pivot_;
  Columns L_, U_;  ///< without diagonals; rows numbered by pivots; those of a column of U in the order of their use
  std::vector<double> diagonal_, work_;
  std::vector<int> place_;  ///< of A's entries: the pivot of their row, or -1
  std::vector<int> mark_;
  int sign_ = 0;
};

}  // namespace linkwork
