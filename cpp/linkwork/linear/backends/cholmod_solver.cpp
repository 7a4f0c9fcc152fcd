#include "linkwork/linear/backends/cholmod_solver.hpp"

#if LINKWORK_WITH_CHOLMOD
#include <cholmod.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "linkwork/linear/backends/cholmod_view.hpp"
#include "linkwork/linear/blas_buffer.hpp"
#include "linkwork/linear/shared_state.hpp"

namespace linkwork {
namespace {

class Cholmod final : public LinearSolver {
 public:
  explicit Cholmod(CholmodMode mode) {
    cholmod_start(&common_);
    common_.print = 0;
    common_.supernodal = mode == CholmodMode::simplicial   ? CHOLMOD_SIMPLICIAL
                         : mode == CholmodMode::supernodal ? CHOLMOD_SUPERNODAL
                                                           : CHOLMOD_AUTO;
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
  ~Cholmod() override {
    release();
    cholmod_finish(&common_);
  }

  void analyze(const SparseMatrix& pattern) override {
    const SharedState held;
    release();
    cholmod_sparse A = view(pattern);
    factor_ = cholmod_analyze(&A, &common_);
    if (!factor_) throw std::bad_alloc();
    if (factor_->is_super) reserve_blas_buffer();
  }

  Pivot factorize(const SparseMatrix& matrix) override {
    const SharedState held;
    cholmod_sparse A = view(matrix);
    cholmod_factorize(&A, factor_, &common_);
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (factor_->minor < factor_->n) return {0.0, original(factor_->minor)};
    return factor_->is_super ? supernodal_pivot(matrix) : simplicial_pivot(matrix);
  }

  void solve(Eigen::Ref<MatrixXd> x) override {
    const SharedState held;
    cholmod_dense B = dense_view(x);
    if (!cholmod_solve2(CHOLMOD_A, factor_, &B, nullptr, &solution_, nullptr, &workspace_y_, &workspace_e_, &common_))
      throw std::bad_alloc();
    x = Eigen::Map<const MatrixXd, 0, Eigen::OuterStride<>>(
        static_cast<const double*>(solution_->x), x.rows(), x.cols(),
        Eigen::OuterStride<>(static_cast<Eigen::Index>(solution_->d)));
  }

  std::int64_t factor_nonzeros() const override {
    return factor_->is_super ? static_cast<std::int64_t>(factor_->xsize) : static_cast<std::int64_t>(factor_->nzmax);
  }
  std::optional<double> flops() const override { return common_.fl; }
  std::optional<std::int64_t> factor_bytes() const override { return static_cast<std::int64_t>(common_.memory_inuse); }

 private:
  static cholmod_sparse view(const SparseMatrix& matrix) {
    cholmod_sparse A = sparse_view(matrix.size, matrix.size, matrix.value.size(), matrix.column_begin.data(),
                                   matrix.row.data(), matrix.value.data(), CHOLMOD_INT);
    A.stype = 1;  // upper triangle
    return A;
  }

  int original(std::size_t column) const { return static_cast<const int*>(factor_->Perm)[column]; }

  /// d_k / A_kk for the k-th eliminated row.
  void lower(Pivot& smallest, const SparseMatrix& A, std::size_t column, double d) const {
    const int row = original(column);
    const int last = A.column_begin[row + 1];
    const int first = A.column_begin[row];
    const auto at = std::lower_bound(A.row.begin() + first, A.row.begin() + last, row);
    keep_smallest(smallest, d / std::abs(A.value[at - A.row.begin()]), row);
  }

  Pivot simplicial_pivot(const SparseMatrix& A) const {
    const auto* begin = static_cast<const int*>(factor_->p);
    const auto* x = static_cast<const double*>(factor_->x);
    Pivot smallest;
    for (std::size_t k = 0; k < factor_->n; ++k) {
      const double d = x[begin[k]];
      lower(smallest, A, k, factor_->is_ll ? d * d : d);
    }
    return smallest;
  }

  Pivot supernodal_pivot(const SparseMatrix& A) const {
    const auto* first = static_cast<const int*>(factor_->super);
    const auto* rows = static_cast<const int*>(factor_->pi);
    const auto* values = static_cast<const int*>(factor_->px);
    const auto* x = static_cast<const double*>(factor_->x);
    Pivot smallest;
    for (std::size_t s = 0; s < factor_->nsuper; ++s) {
      const int stride = rows[s + 1] - rows[s];
      for (int k = first[s]; k < first[s + 1]; ++k) {
        const double d = x[values[s] + (k - first[s]) * (stride + 1)];
        lower(smallest, A, static_cast<std::size_t>(k), d * d);
      }
    }
    return smallest;
  }

  void release() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_free_dense(&solution_, &common_);
    cholmod_free_dense(&workspace_y_, &common_);
    cholmod_free_dense(&workspace_e_, &common_);
  }

  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_dense *solution_ = nullptr, *workspace_y_ = nullptr, *workspace_e_ = nullptr;
};

template <CholmodMode mode>
std::unique_ptr<LinearSolver> make(Storage) {
  return std::make_unique<Cholmod>(mode);
}

}  // namespace
}  // namespace linkwork
#endif

namespace linkwork {

LinearSolverInfo cholmod_info(const std::string& name, const std::string& documentation, CholmodMode mode) {
  LinearSolverInfo info{.name = name, .documentation = documentation, .positive_definite = true};
  info.blas = mode != CholmodMode::simplicial;
#if LINKWORK_WITH_CHOLMOD
  info.make = mode == CholmodMode::automatic    ? make<CholmodMode::automatic>
              : mode == CholmodMode::simplicial ? make<CholmodMode::simplicial>
                                                : make<CholmodMode::supernodal>;
#else
  info.missing =
      "the CHOLMOD that was found has modules under the GPL (Supernodal, MatrixOps, Modify), or there was none, and "
      "LINKWORK_WITH_GPL was OFF";
#endif
#if !LINKWORK_WITH_GPL
  if (mode == CholmodMode::supernodal) {
    info.make = nullptr;
    info.missing = "CHOLMOD's supernodal module is under the GPL, and LINKWORK_WITH_GPL was OFF";
  }
#endif
  return info;
}

}  // namespace linkwork
