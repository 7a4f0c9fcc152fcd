#pragma once

#include "linkwork/math/types.hpp"

/// Dense algebra to compare with: Eigen's decompositions are compiled once, not in every test.
namespace support {

using linkwork::MatrixXd, linkwork::VectorXd;

MatrixXd dense_inverse(const MatrixXd& A);
MatrixXd dense_delassus(const MatrixXd& M, const MatrixXd& D);  ///< D M^-1 D^T
VectorXd dense_solution(const MatrixXd& A, const VectorXd& b);  ///< of A x = b
/// The same in long double.
VectorXd accurate_solution(const MatrixXd& A, const VectorXd& b);
/// The x with the least |A x - b|, and of these the one with the least |x|.
VectorXd dense_least_norm(const MatrixXd& A, const VectorXd& b, double tolerance);
double dense_determinant(const MatrixXd& A);
VectorXd singular_values(const MatrixXd& A);          ///< the largest first
int dense_rank(const MatrixXd& A, double tolerance);  ///< relative to the largest singular value

}  // namespace support
