#include "linkwork/linear/linear_solver.hpp"

#if LINKWORK_WITH_SUITESPARSE
#include <klu.h>

#include <new>

namespace linkwork {
namespace {

class Klu final : public LinearSolver {
 public:
  Klu() {
    klu_defaults(&common_);
    common_.tol = 0.1;  // the default 0.001 prefers the diagonal so much that digits are lost
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;
  ~Klu() override { release(); }

  void analyze(const SparseMatrix& pattern) override {
    release();
    symbolic_ = klu_analyze(pattern.size, begin(pattern), rows(pattern), &common_);
    if (!symbolic_ && common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
    structurally_singular_ = !symbolic_;
  }

  Pivot factorize(const SparseMatrix& A) override {
    if (structurally_singular_) return {0.0, -1};
    matrix_ = &A;
    if (!numeric_ && pivoted_.size() == A.value.size()) pivot(A, pivoted_);
    if (numeric_ && refactorize(A)) return {common_.rcond, -1};
    pivoted_.clear();
    if (!pivot(A, A.value)) return {0.0, common_.singular_col < A.size ? common_.singular_col : -1};
    pivoted_ = A.value;
    return {common_.rcond, -1};
  }

  /// The pivots, by the matrix for which they were chosen.
  void keep(Archive& archive) override {
    archive(pivoted_);
    if (archive.reading()) klu_free_numeric(&numeric_, &common_);
  }

  void solve(Eigen::Ref<MatrixXd> x) override {
    for (Eigen::Index column = 0; column < x.cols(); ++column) {
      residual_ = x.col(column);
      solve_column(x.col(column).data());
      subtract_product(x.col(column));
      solve_column(residual_.data());
      x.col(column) += residual_;
    }
  }

  std::int64_t factor_nonzeros() const override { return numeric_ ? std::int64_t{numeric_->lnz} + numeric_->unz : 0; }
  std::optional<double> flops() const override {
    klu_common common = common_;  // KLU writes the count there
    if (!numeric_ || !klu_flops(symbolic_, numeric_, &common)) return {};
    return common.flops;
  }
  std::optional<std::int64_t> factor_bytes() const override { return static_cast<std::int64_t>(common_.memusage); }

 private:
  /// A full factorization of a matrix with the pattern of A; false where it is singular.
  bool pivot(const SparseMatrix& A, const std::vector<double>& values) {
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(begin(A), rows(A), const_cast<double*>(values.data()), symbolic_, &common_);
    if (!numeric_ && common_.status == KLU_OUT_OF_MEMORY) throw std::bad_alloc();
    if (!numeric_) return false;
    klu_rcond(symbolic_, numeric_, &common_);
    pivoted_condition_ = common_.rcond;
    return true;
  }

  void solve_column(double* column) { klu_solve(symbolic_, numeric_, matrix_->size, 1, column, &common_); }

  /// residual_ -= A x: for one step of iterative refinement, because kept pivots are not the best ones.
  void subtract_product(const ConstVector& x) {
    for (int column = 0; column < matrix_->size; ++column)
      for (int k = matrix_->column_begin[column]; k < matrix_->column_begin[column + 1]; ++k)
        residual_[matrix_->row[k]] -= matrix_->value[k] * x[column];
  }

  /// With the pivots of the last full factorization; false where they have become poor ones.
  bool refactorize(const SparseMatrix& A) {
    const bool done = klu_refactor(begin(A), rows(A), values(A), symbolic_, numeric_, &common_) &&
                      klu_rcond(symbolic_, numeric_, &common_);
    return done && common_.rcond > 0.01 * pivoted_condition_;
  }
  static int* begin(const SparseMatrix& A) { return const_cast<int*>(A.column_begin.data()); }
  static int* rows(const SparseMatrix& A) { return const_cast<int*>(A.row.data()); }
  static double* values(const SparseMatrix& A) { return const_cast<double*>(A.value.data()); }
  void release() {
    pivoted_.clear();
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
  const SparseMatrix* matrix_ = nullptr;  // for iterative refinement; outlives the factorization
  VectorXd residual_;
  std::vector<double> pivoted_;  ///< values of the matrix for which the pivots were chosen
  double pivoted_condition_ = 0.0;
  bool structurally_singular_ = false;
};

std::unique_ptr<LinearSolver> make(Storage) { return std::make_unique<Klu>(); }

}  // namespace
}  // namespace linkwork
#endif

namespace linkwork {

LinearSolverInfo klu_solver() {
  LinearSolverInfo info{.name = "klu",
                        .documentation = "KLU's sparse LU, refactorized with the pivots kept while they serve"};
#if LINKWORK_WITH_SUITESPARSE
  info.make = make;
#else
  info.missing = "KLU is a part of SuiteSparse, and LINKWORK_WITH_SUITESPARSE was OFF, as in wheels";
#endif
  return info;
}

}  // namespace linkwork
