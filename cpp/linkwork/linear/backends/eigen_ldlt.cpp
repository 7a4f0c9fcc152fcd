#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <cmath>

#include "linkwork/linear/linear_solver.hpp"

namespace linkwork {
namespace {

class EigenLdlt final : public LinearSolver {
 public:
  void analyze(const SparseMatrix& pattern) override {
    copy_ = Eigen::Map<const Eigen::SparseMatrix<double>>(
        pattern.size, pattern.size, static_cast<Eigen::Index>(pattern.value.size()), pattern.column_begin.data(),
        pattern.row.data(), pattern.value.data());
    ldlt_.analyzePattern(copy_);
  }

  Pivot factorize(const SparseMatrix& A) override {
    std::copy(A.value.begin(), A.value.end(), copy_.valuePtr());
    ldlt_.factorize(copy_);
    if (ldlt_.info() != Eigen::Success) return {0.0, -1};
    const VectorXd d = ldlt_.vectorD();
    const auto& original = ldlt_.permutationPinv().indices();
    Pivot smallest;
    for (Eigen::Index k = 0; k < d.size(); ++k) {
      const int row = original[k];
      keep_smallest(smallest, d[k] / std::abs(copy_.coeff(row, row)), row);
    }
    return smallest;
  }

  void solve(Eigen::Ref<MatrixXd> x) override { x = ldlt_.solve(x).eval(); }

  std::int64_t factor_nonzeros() const override { return L().nonZeros() + copy_.rows(); }

  /// sum over columns of (entries, the diagonal included)^2
  std::optional<double> flops() const override {
    const auto* begin = L().outerIndexPtr();
    double sum = 0.0;
    for (Eigen::Index c = 0; c < L().cols(); ++c) sum += std::pow(begin[c + 1] - begin[c] + 1, 2);
    return sum;
  }
  std::optional<std::int64_t> factor_bytes() const override {
    const std::int64_t vectors = copy_.rows() * static_cast<std::int64_t>(sizeof(double) + 4 * sizeof(int));
    return bytes_of(L()) + bytes_of(copy_) + vectors;  // D; the permutation and its inverse, tree and column counts
  }

 private:
  static std::int64_t bytes_of(const Eigen::SparseMatrix<double>& matrix) {
    return matrix.data().allocatedSize() * static_cast<std::int64_t>(sizeof(double) + sizeof(int)) +
           (matrix.cols() + 1) * static_cast<std::int64_t>(sizeof(int));
  }
  const Eigen::SparseMatrix<double>& L() const { return ldlt_.matrixL().nestedExpression(); }

  Eigen::SparseMatrix<double> copy_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> ldlt_;
};

}  // namespace

LinearSolverInfo eigen_ldlt_solver() {
  return {.name = "eigen_ldlt",
          .documentation = "Eigen's simplicial LDL^T",
          .positive_definite = true,
          .make = [](Storage) -> std::unique_ptr<LinearSolver> { return std::make_unique<EigenLdlt>(); }};
}

}  // namespace linkwork
