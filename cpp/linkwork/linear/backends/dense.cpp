#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "linkwork/linear/linear_solver.hpp"

namespace linkwork {
namespace {

void copy_to_dense(const SparseMatrix& A, MatrixXd& dense) {
  dense.setZero();
  for (int column = 0; column < A.size; ++column)
    for (int k = A.column_begin[column]; k < A.column_begin[column + 1]; ++k) dense(A.row[k], column) = A.value[k];
}

double cubed(Eigen::Index n) { return std::pow(static_cast<double>(n), 3); }

std::int64_t bytes_of(const MatrixXd& matrix) { return static_cast<std::int64_t>(sizeof(double)) * matrix.size(); }

/// Cholesky of the upper triangle.
class DenseCholesky final : public LinearSolver {
 public:
  void analyze(const SparseMatrix& pattern) override { matrix_.resize(pattern.size, pattern.size); }

  Pivot factorize(const SparseMatrix& A) override {
    copy_to_dense(A, matrix_);
    llt_.compute(matrix_);
    return llt_.info() == Eigen::Success ? smallest_pivot() : broken_pivot();
  }

  void solve(Eigen::Ref<MatrixXd> x) override { llt_.solveInPlace(x); }
  std::int64_t factor_nonzeros() const override { return matrix_.size(); }
  std::optional<double> flops() const override { return cubed(matrix_.rows()) / 3.0; }
  std::optional<std::int64_t> factor_bytes() const override { return bytes_of(matrix_) + bytes_of(llt_.matrixLLT()); }

 private:
  static constexpr double singular_pivot = 1e-15;

  Pivot smallest_pivot() const {
    Pivot smallest;
    for (Eigen::Index k = 0; k < matrix_.rows(); ++k) {
      const double u = llt_.matrixLLT()(k, k);
      keep_smallest(smallest, u * u / matrix_(k, k), static_cast<int>(k));
    }
    return smallest;
  }

  /// Eigen does not say where it stopped: the first row whose leading block is not positive definite.
  Pivot broken_pivot() const {
    MatrixXd U = matrix_;
    for (Eigen::Index k = 0; k < U.rows(); ++k) {
      const double d = U(k, k) - U.col(k).head(k).squaredNorm();
      if (!(d > singular_pivot * matrix_(k, k))) return {0.0, static_cast<int>(k)};
      U(k, k) = std::sqrt(d);
      for (Eigen::Index c = k + 1; c < U.cols(); ++c)
        U(k, c) = (U(k, c) - U.col(k).head(k).dot(U.col(c).head(k))) / U(k, k);
    }
    return {0.0, -1};
  }

  MatrixXd matrix_;
  Eigen::LLT<MatrixXd, Eigen::Upper> llt_;
};

/// LU with partial pivoting.
class DenseLu final : public LinearSolver {
 public:
  void analyze(const SparseMatrix& pattern) override { matrix_.resize(pattern.size, pattern.size); }

  Pivot factorize(const SparseMatrix& A) override {
    copy_to_dense(A, matrix_);
    lu_.compute(matrix_);
    const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
    if (pivots.size() == 0) return {};
    if (!lu_.matrixLU().allFinite()) return {-1.0, -1};
    return {pivots.minCoeff() / pivots.maxCoeff(), -1};
  }

  void solve(Eigen::Ref<MatrixXd> x) override { x = lu_.solve(x).eval(); }
  std::int64_t factor_nonzeros() const override { return matrix_.size(); }
  std::optional<double> flops() const override { return 2.0 * cubed(matrix_.rows()) / 3.0; }
  std::optional<std::int64_t> factor_bytes() const override { return bytes_of(matrix_) + bytes_of(lu_.matrixLU()); }

 private:
  MatrixXd matrix_;
  Eigen::PartialPivLU<MatrixXd> lu_;
};

std::unique_ptr<LinearSolver> make(Storage storage) {
  if (storage == Storage::upper) return std::make_unique<DenseCholesky>();
  return std::make_unique<DenseLu>();
}

}  // namespace

LinearSolverInfo dense_solver() {
  return {.name = "dense",
          .documentation = "Eigen's dense Cholesky or LU, for small systems and as a reference",
          .make = make,
          .dense = true};
}

}  // namespace linkwork
