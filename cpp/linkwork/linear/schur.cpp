#include <algorithm>

#include "linkwork/linear/assembled_solver.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork::detail {
namespace {

/// S = D M^-1 D^T + E by blocks: joints k and l couple through each body b that they share, S_kl += D_kb M_b^-1 D_lb^T.
///   S lambda = b - D M^-1 a,   x = M^-1 (a + D^T lambda)                            (12.5), (12.4), (12.6)
class SchurSolver final : public AssembledSolver {
 public:
  using AssembledSolver::AssembledSolver;

  void analyze(const System& system, const Evaluation&) override {
    system_ = &system;
    const std::vector<int>& rows = system.model().joint_rows();
    std::vector<int> sizes;
    for (int joint = 0; joint < system.joint_count(); ++joint) sizes.push_back(rows[joint + 1] - rows[joint]);
    build_pattern(
        sizes, system.body_count(), [&](int body) { return system.body_blocks(body); },
        [](const ConstraintBlock& block) { return block.joint; });
    solver_->analyze(matrix_->matrix());
    right_hand_side_.resize(system.row_count(), 1);
    acceleration_.resize(system.v_size());
  }

  /// S adds up inverses of masses: where they are 1e6 times apart accelerations are 5e-9 off.
  bool loses_digits(const MassRatios& ratios) const override { return std::max(ratios.mass, ratios.moment) > 1e5; }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    assemble(at, e);
    smallest_pivot_ = solver_->factorize(matrix_->matrix());
    if (!(smallest_pivot_.ratio > singular_pivot))
      throw_singular(*system_, "schur", smallest_pivot_, smallest_pivot_.row, e);
    at_ = &at;
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    system_->multiply_inverse_mass(a, acceleration_);
    system_->multiply_D(*at_, acceleration_, lambda);
    right_hand_side_.col(0) = b - lambda;
    solver_->solve(right_hand_side_);  // (12.5)
    lambda = right_hand_side_.col(0);
    acceleration_ = a;
    system_->add_D_transposed(*at_, lambda, acceleration_);
    system_->multiply_inverse_mass(acceleration_, x);  // (12.4), (12.6)
  }

 private:
  // Permanent redundancy is found by the rank service before a run. Here only a breakdown counts: a straight chain of n
  // links has relative pivots of S down to about 1/n^3, and they are right.
  static constexpr double singular_pivot = 1e-15;

  using Weighted = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

  void assemble(const Evaluation& at, const VectorXd& e) {
    const Stopwatch watch(assemble_time_);
    matrix_->set_zero();
    for (std::size_t joint = 0; joint < diagonal_.size(); ++joint) {
      auto block = matrix_->block(diagonal_[joint]);
      if (e.size() > 0) block.diagonal() = e.segment(system_->model().joint_rows()[joint], block.rows());
    }
    Weighted weighted;
    for (const Product& product : products_) {
      if (product.new_l) weighted = divide_by_mass(at, system_->blocks()[product.l]);
      matrix_->block(product.place) += block_of(at, system_->blocks()[product.k]).lazyProduct(weighted);
    }
    if (storage_ == Storage::full) matrix_->mirror();
  }

  /// M_b^-1 D_l^T.
  Weighted divide_by_mass(const Evaluation& at, const ConstraintBlock& block) const {
    const BlockOfD D = block_of(at, block);
    Weighted out(6, block.rows);
    out.topRows<3>() = system_->inverse_mass(block.body) * D.leftCols<3>().transpose();
    out.bottomRows<3>() = system_->inverse_inertia(block.body).lazyProduct(D.rightCols<3>().transpose());
    return out;
  }

  VectorXd acceleration_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_schur(std::unique_ptr<LinearSolver> solver, Storage storage) {
  return std::make_unique<SchurSolver>(std::move(solver), storage);
}

}  // namespace linkwork::detail
