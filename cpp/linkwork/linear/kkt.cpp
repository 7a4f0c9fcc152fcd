#include <algorithm>

#include "linkwork/linear/assembled_solver.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork::detail {
namespace {

/// [M D^T; D -E], E = 0 but for rows of which compliance is expected, scaled on both sides by W = diag(M_ii^-1/2, (D M^-1 D^T)_ii^-1/2) so that its pivots measure the
/// geometry and not the units.
class KktSolver final : public AssembledSolver {
 public:
  using AssembledSolver::AssembledSolver;

  void analyze(const System& system, const Evaluation& typical) override {
    system_ = &system;
    build_matrix();
    build_scaling(typical);
    solver_->analyze(matrix_->matrix());
    right_hand_side_.resize(matrix_->matrix().size, 1);
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    assemble(at);
    assemble_compliance(e);
    smallest_pivot_ = solver_->factorize(matrix_->matrix());
    if (!(smallest_pivot_.ratio > singular_pivot))
      throw_singular(*system_, "kkt", smallest_pivot_, smallest_pivot_.row - system_->v_size(), e);
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    right_hand_side_.col(0) << a, b;
    right_hand_side_.col(0).array() *= scale_.array();
    solver_->solve(right_hand_side_);  // (12.3)
    right_hand_side_.col(0).array() *= scale_.array();
    x = right_hand_side_.col(0).head(system_->v_size());
    lambda = -right_hand_side_.col(0).tail(system_->row_count());
  }

 private:
  static constexpr double singular_pivot = 1e-14;  // a breakdown; permanent redundancy is found by the rank service

  void build_matrix() {
    const int n = system_->body_count();
    std::vector<int> sizes(n, 6);
    const auto& rows = system_->model().joint_rows();
    for (std::size_t joint = 0; joint + 1 < rows.size(); ++joint) sizes.push_back(rows[joint + 1] - rows[joint]);
    std::vector<BlockIndex> blocks;
    for (int body = 0; body < n; ++body) blocks.push_back({body, body});
    for (const ConstraintBlock& block : system_->blocks()) {
      blocks.push_back({block.body, n + block.joint});
      blocks.push_back({n + block.joint, block.body});
    }
    const auto first_compliant = std::lower_bound(rows.begin(), rows.end() - 1, compliant_from_) - rows.begin();
    for (int joint = static_cast<int>(first_compliant); joint < system_->joint_count(); ++joint)
      blocks.push_back({n + joint, n + joint});
    matrix_ = std::make_unique<BlockMatrix>(sizes, std::move(blocks), Storage::full);
    upper_.clear();
    lower_.clear();
    for (const ConstraintBlock& block : system_->blocks()) {
      upper_.push_back(matrix_->find(block.body, n + block.joint));
      lower_.push_back(matrix_->find(n + block.joint, block.body));
    }
    compliant_.clear();
    for (int joint = static_cast<int>(first_compliant); joint < system_->joint_count(); ++joint)
      compliant_.push_back({rows[joint], matrix_->find(n + joint, n + joint)});
  }

  void build_scaling(const Evaluation& typical) {
    const int n = system_->body_count();
    scale_.setOnes(system_->v_size() + system_->row_count());
    for (int body = 0; body < n; ++body) {
      auto scale = scale_.segment<6>(6 * body);
      const double m = system_->mass(body);
      const Mat3<double>& J = system_->inertia(body);
      if (m > 0.0) scale.head<3>().setConstant(1.0 / std::sqrt(m));
      for (int k = 0; k < 3; ++k)
        if (J(k, k) > 0.0) scale[3 + k] = 1.0 / std::sqrt(J(k, k));
      auto block = matrix_->block(matrix_->find(body, body));
      block.setZero();
      block.topLeftCorner<3, 3>().diagonal().setConstant(m);
      block.bottomRightCorner<3, 3>() = J;
      block = scale.asDiagonal() * MatrixXd(block) * scale.asDiagonal();
    }
    const VectorXd delassus = system_->delassus_diagonal(typical);
    for (Eigen::Index row = 0; row < delassus.size(); ++row)
      if (delassus[row] > 0.0) scale_[6 * n + row] = 1.0 / std::sqrt(delassus[row]);
  }

  void assemble(const Evaluation& at) {
    const Stopwatch watch(assemble_time_);
    for (std::size_t k = 0; k < system_->blocks().size(); ++k) {
      const ConstraintBlock& block = system_->blocks()[k];
      const auto rows = scale_.segment(system_->v_size() + block.row, block.rows);
      const auto columns = scale_.segment<6>(6 * block.body);
      auto lower = matrix_->block(lower_[k]);
      lower = rows.asDiagonal() * block_of(at, block) * columns.asDiagonal();
      matrix_->block(upper_[k]) = lower.transpose();
    }
  }

  void assemble_compliance(const VectorXd& e) {
    for (const auto& [row, place] : compliant_) {
      auto block = matrix_->block(place);
      const auto scale = scale_.segment(system_->v_size() + row, block.rows());
      block.setZero();
      block.diagonal() = -e.segment(row, block.rows()).cwiseProduct(scale.cwiseAbs2());
    }
  }

  std::vector<int> upper_, lower_;              ///< places of each block of D
  std::vector<std::pair<int, int>> compliant_;  ///< of joints with E: first row, place of the block
  VectorXd scale_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_kkt(std::unique_ptr<LinearSolver> solver, Storage) {
  return std::make_unique<KktSolver>(std::move(solver), Storage::full);
}

}  // namespace linkwork::detail
