#pragma once

#include <vector>

#include "linkwork/linear/qr/sparse_qr.hpp"

namespace linkwork::qr {

/// Left kernels of a few rows at a time of a sparse matrix, such as those of each loop of a large mechanism, by dense
/// algebra whose memory is there from one to the next.
class LeftKernel {
 public:
  /// Orthonormal basis of the n with n^T A = 0, A the given rows of D; in its columns one entry for each row. Columns of
  /// A that depend on the others are told by `tolerance`, relative to the largest.
  MatrixXd of(const RowMatrix& D, const std::vector<int>& rows, double tolerance);

 private:
  void gather(const RowMatrix& D, const std::vector<int>& rows);
  Eigen::Index factor(double tolerance);
  void bring_largest(Eigen::Index k);
  void eliminate(Eigen::Index k, double norm);
  void reflect(Eigen::Index k, Eigen::Ref<VectorXd> x) const;

  std::vector<int> local_;    ///< of each column of D: its column in A, or -1
  std::vector<int> columns_;  ///< of D that the rows have
  MatrixXd A_;                ///< then the vectors of the transformations, below the diagonal
  VectorXd tau_, squares_;    ///< of the transformations; of what is left of each column
};

}  // namespace linkwork::qr
