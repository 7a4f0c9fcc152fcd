#include "linkwork/linear/saddle_solver.hpp"

#include "linkwork/math/error.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork::detail {
namespace {

constexpr double singular_pivot = 1e-15;  // M + D^T E^-1 D mixes masses and penalties: small pivots are legitimate

/// N = M + D^T E^-1 D by blocks: the bodies of joint k couple, N_bc += D_kb^T E_k^-1 D_kc.
///   N x = a + D^T E^-1 b,   lambda = E^-1 (b - D x)                                             (12.14)
class NormalSolver final : public SaddleSolver {
 public:
  NormalSolver(std::unique_ptr<LinearSolver> solver, Storage storage) : solver_(std::move(solver)), storage_(storage) {}

  void analyze(const System& system, const Evaluation&) override {
    system_ = &system;
    build_pattern();
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
    solver_->solve(right_hand_side_);
    x = right_hand_side_.col(0);
    system_->multiply_D(*at_, x, lambda);
    lambda = penalty_.cwiseProduct(b - lambda);
  }

  std::int64_t factor_nonzeros() const override { return solver_->factor_nonzeros(); }
  std::optional<double> flops() const override { return solver_->flops(); }
  std::optional<std::int64_t> factor_bytes() const override { return solver_->factor_bytes(); }
  std::optional<std::int64_t> matrix_nonzeros() const override { return triangle_nonzeros(matrix_->matrix()); }

 private:
  /// N_bc += D_b^T E^-1 D_c, with b and c blocks of the same joint.
  struct Term {
    int b, c, place;
  };

  void build_pattern() {
    const std::vector<int> sizes(system_->body_count(), 6);
    std::vector<BlockIndex> blocks;
    for (int body = 0; body < system_->body_count(); ++body) blocks.push_back({body, body});
    for_each_pair([&](int, int, int row, int column) {
      blocks.push_back({row, column});
      if (storage_ == Storage::full) blocks.push_back({column, row});
    });
    matrix_ = std::make_unique<BlockMatrix>(sizes, std::move(blocks), storage_);
    terms_.clear();
    for_each_pair([&](int b, int c, int row, int column) { terms_.push_back({b, c, matrix_->find(row, column)}); });
    diagonal_.clear();
    for (int body = 0; body < system_->body_count(); ++body) diagonal_.push_back(matrix_->find(body, body));
  }

  /// Calls visit(block b, block c, body of b, body of c) for all pairs of one joint with body b <= body c.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    for (int joint = 0; joint < system_->joint_count(); ++joint)
      for (const int b : system_->joint_blocks(joint))
        for (const int c : system_->joint_blocks(joint)) {
          const int row = system_->blocks()[b].body;
          const int column = system_->blocks()[c].body;
          if (row <= column) visit(b, c, row, column);
        }
  }

  void assemble(const Evaluation& at, const VectorXd& e) {
    const Stopwatch watch(assemble_time_);
    penalty_ = e.cwiseInverse();
    add_masses();
    using Weighted = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
    for (const Term& term : terms_) {
      const ConstraintBlock& c = system_->blocks()[term.c];
      const Weighted weighted = block_of(at, c).transpose() * penalty_.segment(c.row, c.rows).asDiagonal();
      matrix_->block(term.place) += (weighted.lazyProduct(block_of(at, system_->blocks()[term.b]))).transpose();
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

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  std::unique_ptr<LinearSolver> solver_;
  Storage storage_;
  std::unique_ptr<BlockMatrix> matrix_;
  std::vector<Term> terms_;
  std::vector<int> diagonal_;
  VectorXd penalty_;
  MatrixXd right_hand_side_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_normal(std::unique_ptr<LinearSolver> solver, Storage storage) {
  return std::make_unique<NormalSolver>(std::move(solver), storage);
}

}  // namespace linkwork::detail
