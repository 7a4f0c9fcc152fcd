#include "linkwork/formulation/formulation.hpp"

namespace linkwork {
namespace {

/// Lagrange multipliers: the system (12.3) as it stands, or (12.5) for lambda and (12.6) for v_dot.
class Standard final : public Formulation {
 public:
  explicit Standard(std::unique_ptr<SaddleSolver> saddle) : saddle_(std::move(saddle)) {}

  void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) override {
    saddle_->drop(rows.dropped);
    saddle_->analyze(system, typical);
    compliance_.setZero(system.row_count());
    for (const int row : rows.dropped) compliance_[row] = 1.0;
  }
  void factorize(const Evaluation& at) override { saddle_->factorize(at, compliance_); }
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override {
    saddle_->solve(a, b, v_dot, lambda);
  }
  void factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector v_dot,
                           MutableVector lambda) override {
    saddle_->factorize_and_solve(at, compliance_, a, b, v_dot, lambda);
  }
  const SaddleSolver& saddle() const override { return *saddle_; }

 private:
  std::unique_ptr<SaddleSolver> saddle_;
  VectorXd compliance_;  ///< 0, and 1 for dropped rows
};

}  // namespace

FormulationInfo standard_formulation() {
  return {.name = "standard",
          .documentation = "Lagrange multipliers, Flores (2015) eq. (12.3) or (12.5)-(12.6)",
          .forms = {"schur", "kkt"},
          .needs_full_rank = true,
          .needs_mass = true,
          .make = [](std::unique_ptr<SaddleSolver> saddle, const Options&) -> std::unique_ptr<Formulation> {
            return std::make_unique<Standard>(std::move(saddle));
          }};
}

}  // namespace linkwork
