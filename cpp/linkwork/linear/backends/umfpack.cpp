#include "linkwork/linear/linear_solver.hpp"

#if LINKWORK_WITH_GPL
#include <umfpack.h>

#include <new>

#include "linkwork/linear/blas_buffer.hpp"
#include "linkwork/linear/shared_state.hpp"

namespace linkwork {
namespace {

class Umfpack final : public LinearSolver {
 public:
  Umfpack() {
    umfpack_di_defaults(control_);
    control_[UMFPACK_IRSTEP] = 1;
  }
  Umfpack(const Umfpack&) = delete;
  Umfpack& operator=(const Umfpack&) = delete;
  ~Umfpack() override { release(); }

  void analyze(const SparseMatrix& pattern) override {
    const SharedState held;
    reserve_blas_buffer();
    release();
    check(umfpack_di_symbolic(pattern.size, pattern.size, pattern.column_begin.data(), pattern.row.data(), nullptr,
                              &symbolic_, control_, info_));
    index_workspace_.resize(pattern.size);
    workspace_.resize(5 * static_cast<std::size_t>(pattern.size));
    solution_.resize(pattern.size);
  }

  Pivot factorize(const SparseMatrix& A) override {
    const SharedState held;
    umfpack_di_free_numeric(&numeric_);
    const int status =
        umfpack_di_numeric(A.column_begin.data(), A.row.data(), A.value.data(), symbolic_, &numeric_, control_, info_);
    if (status == UMFPACK_WARNING_singular_matrix) return {0.0, -1};
    check(status);
    matrix_ = &A;
    return {info_[UMFPACK_RCOND], -1};
  }

  void solve(Eigen::Ref<MatrixXd> x) override {
    const SharedState held;
    for (Eigen::Index column = 0; column < x.cols(); ++column) {
      check(umfpack_di_wsolve(UMFPACK_A, matrix_->column_begin.data(), matrix_->row.data(), matrix_->value.data(),
                              solution_.data(), x.col(column).data(), numeric_, control_, info_,
                              index_workspace_.data(), workspace_.data()));
      x.col(column) = solution_;
    }
  }

  std::int64_t factor_nonzeros() const override {
    return static_cast<std::int64_t>(info_[UMFPACK_LNZ] + info_[UMFPACK_UNZ]);
  }
  std::optional<double> flops() const override { return info_[UMFPACK_FLOPS]; }
  std::optional<std::int64_t> factor_bytes() const override {
    return static_cast<std::int64_t>(info_[UMFPACK_NUMERIC_SIZE] * info_[UMFPACK_SIZE_OF_UNIT]);
  }

 private:
  static void check(int status) {
    if (status == UMFPACK_ERROR_out_of_memory) throw std::bad_alloc();
    if (status < 0) throw std::logic_error("UMFPACK status " + std::to_string(status));
  }
  void release() {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }

  double control_[UMFPACK_CONTROL]{}, info_[UMFPACK_INFO]{};
  void *symbolic_ = nullptr, *numeric_ = nullptr;
  const SparseMatrix* matrix_ = nullptr;  // for the step of iterative refinement; outlives the factorization
  std::vector<int> index_workspace_;
  std::vector<double> workspace_;
  VectorXd solution_;
};

std::unique_ptr<LinearSolver> make(Storage) { return std::make_unique<Umfpack>(); }

}  // namespace
}  // namespace linkwork
#endif

namespace linkwork {

LinearSolverInfo umfpack_solver() {
  LinearSolverInfo info{.name = "umfpack", .documentation = "UMFPACK's multifrontal sparse LU"};
  info.blas = true;
#if LINKWORK_WITH_GPL
  info.make = make;
#else
  info.missing = "UMFPACK is under the GPL, and LINKWORK_WITH_GPL was OFF";
#endif
  return info;
}

}  // namespace linkwork
