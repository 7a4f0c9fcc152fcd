#include "dense_algebra.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace support {

MatrixXd dense_inverse(const MatrixXd& A) { return A.inverse(); }

MatrixXd dense_delassus(const MatrixXd& M, const MatrixXd& D) { return D * M.inverse() * D.transpose(); }

VectorXd dense_solution(const MatrixXd& A, const VectorXd& b) { return A.fullPivLu().solve(b); }

VectorXd accurate_solution(const MatrixXd& A, const VectorXd& b) {
  return A.cast<long double>().fullPivLu().solve(b.cast<long double>()).cast<double>();
}

VectorXd dense_least_norm(const MatrixXd& A, const VectorXd& b, double tolerance) {
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> decomposition(A);
  decomposition.setThreshold(tolerance);
  return decomposition.solve(b);
}

double dense_determinant(const MatrixXd& A) { return A.determinant(); }

VectorXd singular_values(const MatrixXd& A) { return Eigen::BDCSVD<MatrixXd>(A).singularValues(); }

int dense_rank(const MatrixXd& A, double tolerance) {
  if (A.size() == 0) return 0;
  const VectorXd sigma = singular_values(A);
  return static_cast<int>((sigma.array() > tolerance * sigma[0]).count());
}

}  // namespace support
