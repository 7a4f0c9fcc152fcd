#include "linkwork/linear/linear_solver.hpp"

#if LINKWORK_WITH_GPL
#include <SuiteSparseQR.hpp>
#include <cmath>
#include <new>

#include "linkwork/linear/backends/cholmod_view.hpp"
#include "linkwork/linear/blas_buffer.hpp"
#include "linkwork/linear/shared_state.hpp"

namespace linkwork {
namespace {

/// Powers of two s such that the largest entry in each column of diag(s) A diag(s) is about 1, for a symmetric A (Ruiz
/// 2001): where masses are far apart, SPQR would take what is small for singular.
VectorXd equilibration(const SparseMatrix& A) {
  constexpr int rounds = 6;  // each takes the square root of what is left to be done
  VectorXd s = VectorXd::Ones(A.size), largest(A.size);
  for (int round = 0; round < rounds; ++round) {
    for (int column = 0; column < A.size; ++column) {
      double& most = largest[column] = 0.0;
      for (int k = A.column_begin[column]; k < A.column_begin[column + 1]; ++k)
        most = std::max(most, std::abs(A.value[k]) * s[A.row[k]]);
      most *= s[column];
    }
    for (int k = 0; k < A.size; ++k)
      if (largest[k] > 0.0) s[k] /= std::sqrt(largest[k]);
  }
  return s.unaryExpr([](double x) { return std::exp2(std::round(std::log2(x))); });
}

class Spqr final : public LinearSolver {
 public:
  Spqr() {
    cholmod_l_start(&common_);
    common_.print = 0;
  }
  Spqr(const Spqr&) = delete;
  Spqr& operator=(const Spqr&) = delete;
  ~Spqr() override {
    SuiteSparseQR_free<double>(&qr_, &common_);
    cholmod_l_finish(&common_);
  }

  void analyze(const SparseMatrix& pattern) override {
    const SharedState held;
    reserve_blas_buffer();
    begin_.assign(pattern.column_begin.begin(), pattern.column_begin.end());
    row_.assign(pattern.row.begin(), pattern.row.end());
    SuiteSparseQR_free<double>(&qr_, &common_);
    scaled_ = pattern.value;
    cholmod_sparse A = view(pattern);
    qr_ = SuiteSparseQR_symbolic<double>(SPQR_ORDERING_DEFAULT, true, &A, &common_);
    if (!qr_) throw std::bad_alloc();
  }

  Pivot factorize(const SparseMatrix& matrix) override {
    const SharedState held;
    if (!VectorXd::Map(matrix.value.data(), static_cast<Eigen::Index>(matrix.value.size())).allFinite())
      return {-1.0, -1};
    scale_ = equilibration(matrix);
    scaled_ = matrix.value;
    for (int column = 0; column < matrix.size; ++column)
      for (int k = matrix.column_begin[column]; k < matrix.column_begin[column + 1]; ++k)
        scaled_[k] *= scale_[column] * scale_[matrix.row[k]];
    cholmod_sparse A = view(matrix);
    if (!SuiteSparseQR_numeric<double>(SPQR_DEFAULT_TOL, &A, qr_, &common_)) throw std::bad_alloc();
    return {qr_->rank < matrix.size ? 0.0 : 1.0, -1};
  }

  void solve(Eigen::Ref<MatrixXd> x) override {
    const SharedState held;
    x.array().colwise() *= scale_.array();
    cholmod_dense B = dense_view(x);
    cholmod_dense* y = SuiteSparseQR_qmult<double>(SPQR_QTX, qr_, &B, &common_);
    cholmod_dense* z = y ? SuiteSparseQR_solve<double>(SPQR_RETX_EQUALS_B, qr_, y, &common_) : nullptr;
    cholmod_l_free_dense(&y, &common_);
    if (!z) throw std::bad_alloc();
    x = scale_.asDiagonal() * Eigen::Map<const MatrixXd>(static_cast<const double*>(z->x), x.rows(), x.cols());
    cholmod_l_free_dense(&z, &common_);
  }

  std::int64_t factor_nonzeros() const override { return static_cast<std::int64_t>(common_.SPQR_istat[0]); }
  std::optional<double> flops() const override { return common_.SPQR_flopcount; }
  std::optional<std::int64_t> factor_bytes() const override { return static_cast<std::int64_t>(common_.memory_inuse); }

 private:
  cholmod_sparse view(const SparseMatrix& matrix) const {
    return sparse_view(matrix.size, matrix.size, scaled_.size(), begin_.data(), row_.data(), scaled_.data(),
                       CHOLMOD_LONG);
  }

  cholmod_common common_{};
  SuiteSparseQR_factorization<double>* qr_ = nullptr;
  std::vector<SuiteSparse_long> begin_, row_;
  VectorXd scale_;              ///< of rows and columns
  std::vector<double> scaled_;  ///< entries of the matrix
};

std::unique_ptr<LinearSolver> make(Storage) { return std::make_unique<Spqr>(); }

}  // namespace
}  // namespace linkwork
#endif

namespace linkwork {

LinearSolverInfo spqr_solver() {
  LinearSolverInfo info{.name = "spqr", .documentation = "SuiteSparseQR's rank-revealing sparse QR"};
  info.blas = true;
#if LINKWORK_WITH_GPL
  info.make = make;
#else
  info.missing = "SPQR is under the GPL, and LINKWORK_WITH_GPL was OFF";
#endif
  return info;
}

}  // namespace linkwork
