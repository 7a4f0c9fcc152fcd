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

  std::int64_t factor_nonzeros() const override { return ldlt_.matrixL().nestedExpression().nonZeros() + copy_.rows(); }

 private:
  Eigen::SparseMatrix<double> copy_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper> ldlt_;
};

}  // namespace

LinearSolverInfo eigen_ldlt_solver() {
  return {"eigen_ldlt", "Eigen's simplicial LDL^T", true,
          [](Storage) -> std::unique_ptr<LinearSolver> { return std::make_unique<EigenLdlt>(); }};
}

}  // namespace linkwork
