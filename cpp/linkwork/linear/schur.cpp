#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork::detail {
namespace {

// Permanent redundancy is found by the rank service before a run. Here only a breakdown counts: a straight chain of n
// links has relative pivots of S down to about 1/n^3, and they are right.
constexpr double singular_pivot = 1e-15;

/// S = D M^-1 D^T + E by blocks: joints k and l couple through each body b that they share, S_kl += D_kb M_b^-1 D_lb^T.
///   S lambda = b - D M^-1 a,   x = M^-1 (a + D^T lambda)                                        (12.5), (12.6)
class SchurSolver final : public SaddleSolver {
 public:
  SchurSolver(std::unique_ptr<LinearSolver> solver, Storage storage) : solver_(std::move(solver)), storage_(storage) {}

  void analyze(const System& system, const Evaluation&) override {
    system_ = &system;
    build_pattern();
    solver_->analyze(matrix_->matrix());
    right_hand_side_.resize(system.row_count(), 1);
    acceleration_.resize(system.v_size());
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    assemble(at, e);
    smallest_pivot_ = solver_->factorize(matrix_->matrix());
    if (!(smallest_pivot_.ratio > singular_pivot))
      throw_singular(*system_, "schur", smallest_pivot_, smallest_pivot_.row);
    at_ = &at;
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    system_->multiply_inverse_mass(a, acceleration_);
    system_->multiply_D(*at_, acceleration_, lambda);
    right_hand_side_.col(0) = b - lambda;
    solver_->solve(right_hand_side_);
    lambda = right_hand_side_.col(0);
    acceleration_ = a;
    system_->add_D_transposed(*at_, lambda, acceleration_);
    system_->multiply_inverse_mass(acceleration_, x);
  }

  std::int64_t factor_nonzeros() const override { return solver_->factor_nonzeros(); }
  std::optional<double> flops() const override { return solver_->flops(); }
  std::optional<std::int64_t> factor_bytes() const override { return solver_->factor_bytes(); }
  std::optional<std::int64_t> matrix_nonzeros() const override { return triangle_nonzeros(matrix_->matrix()); }

 private:
  /// S_kl += D_k M^-1 D_l^T, with k and l blocks of the same body.
  struct Term {
    int k, l, place;
    bool first_of_block;  ///< l differs from the term before: M^-1 D_l^T is needed anew
  };

  void build_pattern() {
    const auto& rows = system_->model().joint_rows();
    std::vector<int> sizes;
    std::vector<BlockIndex> blocks;
    for (int joint = 0; joint < system_->joint_count(); ++joint) {
      sizes.push_back(rows[joint + 1] - rows[joint]);
      blocks.push_back({joint, joint});
    }
    for_each_pair([&](int, int, int row, int column, bool) {
      blocks.push_back({row, column});
      if (storage_ == Storage::full) blocks.push_back({column, row});
    });
    matrix_ = std::make_unique<BlockMatrix>(sizes, std::move(blocks), storage_);
    terms_.clear();
    for_each_pair([&](int k, int l, int row, int column, bool first) {
      terms_.push_back({k, l, matrix_->find(row, column), first});
    });
    diagonal_.clear();
    for (int joint = 0; joint < system_->joint_count(); ++joint) diagonal_.push_back(matrix_->find(joint, joint));
  }

  /// Calls visit(block k, block l, joint of k, joint of l, l is new) for all pairs on one body with joint k <= joint l.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (int body = 0; body < system_->body_count(); ++body)
      for (const int l : system_->body_blocks(body)) {
        bool first = true;
        for (const int k : system_->body_blocks(body)) {
          const int row = system_->blocks()[k].joint;
          const int column = system_->blocks()[l].joint;
          if (row > column) continue;
          visit(k, l, row, column, first);
          first = false;
        }
      }
  }

  void assemble(const Evaluation& at, const VectorXd& e) {
    const Stopwatch watch(assemble_time_);
    matrix_->set_zero();
    for (std::size_t joint = 0; joint < diagonal_.size(); ++joint) {
      auto block = matrix_->block(diagonal_[joint]);
      block.diagonal() = e.segment(system_->model().joint_rows()[joint], block.rows());
    }
    using Weighted = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    Weighted weighted;
    for (const Term& term : terms_) {
      if (term.first_of_block) weighted = divide_by_mass(at, system_->blocks()[term.l]);
      matrix_->block(term.place) += block_of(at, system_->blocks()[term.k]).lazyProduct(weighted);
    }
    if (storage_ == Storage::full) matrix_->mirror();
  }

  /// M_b^-1 D_lb^T.
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6> divide_by_mass(const Evaluation& at,
                                                                                 const ConstraintBlock& block) const {
    const ConstBlock D = block_of(at, block);
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6> out(6, block.rows);
    out.topRows<3>() = system_->inverse_mass(block.body) * D.leftCols<3>().transpose();
    out.bottomRows<3>() = system_->inverse_inertia(block.body).lazyProduct(D.rightCols<3>().transpose());
    return out;
  }

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  std::unique_ptr<LinearSolver> solver_;
  Storage storage_;
  std::unique_ptr<BlockMatrix> matrix_;
  std::vector<Term> terms_;
  std::vector<int> diagonal_;
  MatrixXd right_hand_side_;
  VectorXd acceleration_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_schur(std::unique_ptr<LinearSolver> solver, Storage storage) {
  return std::make_unique<SchurSolver>(std::move(solver), storage);
}

}  // namespace linkwork::detail
