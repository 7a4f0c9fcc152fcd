#include "linkwork/linear/assembled_solver.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork::detail {
namespace {

/// N = M + D^T E^-1 D by blocks: the bodies b and c of each joint couple, N_bc += D_b^T E^-1 D_c.
///   N x = a + D^T E^-1 b,   lambda = E^-1 (b - D x)                                             (12.14)
class NormalSolver final : public AssembledSolver {
 public:
  using AssembledSolver::AssembledSolver;

  void analyze(const System& system, const Evaluation&) override {
    system_ = &system;
    build_pattern(
        std::vector<int>(system.body_count(), velocity_size), system.joint_count(),
        [&](int joint) { return system.joint_blocks(joint); }, [](const ConstraintBlock& block) { return block.body; });
    solver_->analyze(matrix_->matrix());
    right_hand_side_.resize(system.v_size(), 1);
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    assemble(at, e);
    smallest_pivot_ = solver_->factorize(matrix_->matrix());
    if (!(smallest_pivot_.ratio > singular_pivot)) throw_free_body();
    at_ = &at;
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    lambda = penalty_.cwiseProduct(b);
    x = a;
    system_->add_D_transposed(*at_, lambda, x);
    right_hand_side_.col(0) = x;
    solver_->solve(right_hand_side_);  // (12.14)
    x = right_hand_side_.col(0);
    system_->multiply_D(*at_, x, lambda);
    lambda = penalty_.cwiseProduct(b - lambda);
  }

 private:
  static constexpr double singular_pivot = 1e-15;  // masses and penalties mix: small pivots are legitimate

  void assemble(const Evaluation& at, const VectorXd& e) {
    const Stopwatch watch(assemble_time_);
    penalty_ = e.cwiseInverse();
    add_masses();
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6> weighted;  // D_l^T E^-1
    for (const Product& product : products_) {
      const ConstraintBlock& l = system_->blocks()[product.l];
      if (product.new_l) weighted = block_of(at, l).transpose() * penalty_.segment(l.row, l.rows).asDiagonal();
      matrix_->block(product.place) += weighted.lazyProduct(block_of(at, system_->blocks()[product.k])).transpose();
    }
    if (storage_ == Storage::full) matrix_->mirror();
  }

  void add_masses() {
    matrix_->set_zero();
    for (int body = 0; body < system_->body_count(); ++body) {
      auto block = matrix_->block(diagonal_[body]);
      block.topLeftCorner<3, 3>().diagonal().setConstant(system_->mass(body));
      block.bottomRightCorner<3, 3>() = system_->inertia(body);
    }
  }

  [[noreturn]] void throw_free_body() const {
    ErrorDetails details;
    std::string who = "a body";
    if (smallest_pivot_.row >= 0) {
      details.bodies = {system_->model().body_name(smallest_pivot_.row / 6)};
      who = "body '" + details.bodies.front() + "'";
    }
    throw SingularSystemError("free_massless_body",
                              who +
                                  " has a motion without inertia that no joint resists: M + D^T a D is singular; give "
                                  "it mass and inertia, or hold it by joints",
                              details);
  }

  VectorXd penalty_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_normal(std::unique_ptr<LinearSolver> solver, Storage storage) {
  return std::make_unique<NormalSolver>(std::move(solver), storage);
}

}  // namespace linkwork::detail
