#pragma once

#include <cstddef>
#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Constraint rows that the solve leaves out because the others imply them. In
///   [M  D^T] {   x   }   {a}
///   [D  -E ] {-lambda} = {b}
/// their D is zero, their b 0 and their e 1: the multiplier is 0, and no matrix changes its structure.
class DroppedRows {
 public:
  DroppedRows() = default;
  DroppedRows(const System& system, std::vector<int> rows);

  const std::vector<int>& rows() const { return rows_; }
  int count() const { return static_cast<int>(rows_.size()); }
  bool empty() const { return rows_.empty(); }
  /// Of each row, as last taken out, whether it holds translations; else it is of rotations alone.
  std::vector<char> translating() const;

  /// Takes the rows out of the D of an evaluation, and keeps their entries.
  void take_out(Evaluation& at);
  void put_back(Evaluation& at) const;

  // The rows D_d as last taken out, and vectors over all rows and over these.
  void multiply(const ConstVector& x, MutableVector omega) const;        ///< omega = D_d x
  void add_transposed(const ConstVector& omega, MutableVector y) const;  ///< y += D_d^T omega
  void take_from(MutableVector b) const;                                 ///< b_d = 0
  void scatter(const ConstVector& omega, MutableVector lambda) const;    ///< lambda_d = omega
  void gather(const ConstVector& lambda, MutableVector omega) const;     ///< omega = lambda_d

 private:
  using Row = Eigen::Matrix<double, 6, 1>;
  /// The entries of one row for one body.
  struct Piece {
    int place;  ///< in rows_
    int body;
    std::ptrdiff_t offset;  ///< in Evaluation::D
    Row entries;
  };
  std::vector<int> rows_;
  std::vector<Piece> pieces_;
};

}  // namespace linkwork
