#include <utility>

#include "linkwork/assembly/mass_ratios.hpp"
#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork::detail {
namespace {

/// Each inerter as a row d of D with the compliance 1 / b: where its right-hand side is zero its multiplier is -b d x, so
/// that the first equations are those of M + b d^T d.
class InerterSolver final : public SaddleSolver {
 public:
  explicit InerterSolver(std::unique_ptr<SaddleSolver> solver) : solver_(std::move(solver)) {}

  void analyze(const System& system, const Evaluation& typical) override {
    begin(system);
    solver_->analyze(*system_, typical);
  }

  bool analyze_as_it_is(const System& system, const Evaluation& typical, const std::vector<int>& light) override {
    begin(system);
    return solver_->analyze_as_it_is(*system_, typical, light);
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    take_compliance(e);
    try {
      solver_->factorize(at, e_);
    } catch (...) {
      note_pivot();
      throw;
    }
    note_pivot();
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    b_.head(rows_) = b;
    solver_->solve(a, b_, x, lambda_);
    lambda = lambda_.head(rows_);
  }

  void factorize_and_solve(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b,
                           MutableVector x, MutableVector lambda) override {
    take_compliance(e);
    b_.head(rows_) = b;
    try {
      solver_->factorize_and_solve(at, e_, a, b_, x, lambda_);
    } catch (...) {
      note_pivot();
      throw;
    }
    note_pivot();
    lambda = lambda_.head(rows_);
  }

  void keep(Archive& archive) override { solver_->keep(archive); }
  bool loses_digits(const MassRatios& ratios) const override { return solver_->loses_digits(ratios); }
  bool reordered() const override { return solver_->reordered(); }
  bool shares_work() const override { return solver_->shares_work(); }
  std::int64_t factor_nonzeros() const override { return solver_->factor_nonzeros(); }
  std::optional<double> flops() const override { return solver_->flops(); }
  std::optional<std::int64_t> factor_bytes() const override { return solver_->factor_bytes(); }
  std::optional<std::int64_t> matrix_nonzeros() const override { return solver_->matrix_nonzeros(); }

 private:
  void begin(const System& system) {
    rows_ = system.row_count();
    system_ = std::make_unique<System>(Inerters::as_joints(system.model()));
    system_->use(system.shared_threads());
    const auto count = static_cast<Eigen::Index>(system.inerters().count());
    for (VectorXd* all : {&e_, &b_, &lambda_}) all->setZero(rows_ + count);
    for (Eigen::Index k = 0; k < count; ++k) e_[rows_ + k] = 1.0 / system.inerters().inertance(k);
    yields_ = false;
    solver_->drop(dropped_);
    solver_->expect_inerters(rows_, MassRatios(system).inertance);
  }

  void take_compliance(const VectorXd& e) {
    if (e.size() > 0) e_.head(rows_) = e;
    else if (yields_) e_.head(rows_).setZero();
    yields_ = e.size() > 0;
  }

  void note_pivot() {
    smallest_pivot_.ratio = solver_->smallest_pivot();
    assemble_time_ = solver_->assemble_time();
  }

  std::unique_ptr<SaddleSolver> solver_;
  std::unique_ptr<System> system_;  ///< with the rows of inerters behind those of the joints
  int rows_ = 0;
  bool yields_ = false;  ///< rows of joints have a compliance of their own
  VectorXd e_, b_, lambda_;
};

}  // namespace

std::unique_ptr<SaddleSolver> with_inerters(std::unique_ptr<SaddleSolver> solver) {
  return std::make_unique<InerterSolver>(std::move(solver));
}

}  // namespace linkwork::detail
