#include "linkwork/formulation/direct_formulation.hpp"

namespace linkwork {
namespace {

// v_dot is wrong by about 1e-9 / s_min, s_min of the scaled D M^-1 D^T, and roundoff in lambda is magnified by 1e9.
constexpr double default_scale = 1e9;

/// Constraints as stiff massless elements,
///   (M + D^T alpha D) v_dot = a + D^T alpha b,   lambda = alpha (b - D v_dot),                 (12.14)
/// which is the system of DirectFormulation with E = alpha^-1.
class Penalty final : public DirectFormulation {
 public:
  Penalty(std::unique_ptr<SaddleSolver> saddle, const Options& options)
      : DirectFormulation(std::move(saddle)), options_(options) {}

  void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) override {
    saddle_->drop(rows.dropped);
    saddle_->analyze(system, typical);
    compliance_ = row_penalties(rows, options_.penalty, options_.penalty_scale.value_or(default_scale)).cwiseInverse();
  }

 private:
  Options options_;
};

}  // namespace

FormulationInfo penalty_formulation() {
  return {.name = "penalty",
          .documentation = "Penalty method, Flores (2015) eq. (12.14)",
          .forms = {"normal"},
          .options = {"penalty", "penalty_scale", "damping_ratio", "frequency"},
          .compliant = true,
          .make = [](std::unique_ptr<SaddleSolver> saddle, const Options& options) -> std::unique_ptr<Formulation> {
            return std::make_unique<Penalty>(std::move(saddle), options);
          }};
}

}  // namespace linkwork
