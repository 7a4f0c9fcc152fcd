#include "linkwork/linear/qr/left_kernel.hpp"

#include <cmath>

namespace linkwork::qr {

// With A P = Q [R; 0], n^T A = 0 is n = Q [0; x]: the last columns of Q = H_1 H_2 ... H_rank, H = 1 - tau v v^T. The
// columns are taken by what is left of them (P. Businger, G. H. Golub, Numer. Math. 7, 1965): in a long row of bodies
// roundoff would grow from each to the next where they are taken as they stand.
MatrixXd LeftKernel::of(const RowMatrix& D, const std::vector<int>& rows, double tolerance) {
  gather(D, rows);
  const Eigen::Index rank = factor(tolerance);
  MatrixXd N = MatrixXd::Zero(A_.rows(), A_.rows() - rank);
  N.bottomRows(N.cols()).setIdentity();
  for (Eigen::Index c = 0; c < N.cols(); ++c)
    for (Eigen::Index k = rank; k-- > 0;) reflect(k, N.col(c));
  return N;
}

void LeftKernel::gather(const RowMatrix& D, const std::vector<int>& rows) {
  local_.resize(D.cols(), -1);
  columns_.clear();
  for (const int row : rows)
    for (RowMatrix::InnerIterator it(D, row); it; ++it)
      if (int& local = local_[it.col()]; local < 0) {
        local = static_cast<int>(columns_.size());
        columns_.push_back(static_cast<int>(it.col()));
      }
  A_.setZero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns_.size()));
  for (Eigen::Index k = 0; k < A_.rows(); ++k)
    for (RowMatrix::InnerIterator it(D, rows[k]); it; ++it) A_(k, local_[it.col()]) = it.value();
  for (const int column : columns_) local_[column] = -1;
}

/// Returns the rank.
Eigen::Index LeftKernel::factor(double tolerance) {
  const Eigen::Index most = std::min(A_.rows(), A_.cols());
  tau_.resize(most);
  squares_ = A_.colwise().squaredNorm();
  double least = 0.0;
  for (Eigen::Index k = 0; k < most; ++k) {
    bring_largest(k);
    const double norm = std::sqrt(squares_[k]);
    if (k == 0) least = tolerance * norm;
    if (!(norm > least)) return k;
    eliminate(k, norm);
  }
  return most;
}

void LeftKernel::bring_largest(Eigen::Index k) {
  Eigen::Index largest = 0;
  squares_.tail(squares_.size() - k).maxCoeff(&largest);
  if (largest == 0) return;
  A_.col(k).swap(A_.col(k + largest));
  std::swap(squares_[k], squares_[k + largest]);
}

/// Column k becomes (beta, v_2, v_3, ...) from its row k on, with H (x) = beta e_1 and v_1 = 1; the others follow.
void LeftKernel::eliminate(Eigen::Index k, double norm) {
  const Eigen::Index rest = A_.rows() - k - 1;
  const double x = A_(k, k), beta = x > 0.0 ? -norm : norm;
  tau_[k] = (beta - x) / beta;
  A_.col(k).tail(rest) /= x - beta;
  A_(k, k) = beta;
  for (Eigen::Index c = k + 1; c < A_.cols(); ++c) {
    reflect(k, A_.col(c));
    squares_[c] = A_.col(c).tail(rest).squaredNorm();
  }
}

/// x = H x
void LeftKernel::reflect(Eigen::Index k, Eigen::Ref<VectorXd> x) const {
  const auto v = A_.col(k).tail(A_.rows() - k - 1);
  auto below = x.tail(v.size());
  const double w = tau_[k] * (x[k] + v.dot(below));
  if (w == 0.0) return;  // of bodies that are no neighbors
  x[k] -= w;
  below -= w * v;
}

}  // namespace linkwork::qr
