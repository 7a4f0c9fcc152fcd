#include <cmath>

#include "linkwork/integration/integrator.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

void check(const ButcherTableau& tableau) {
  const Eigen::Index s = tableau.b.size();
  const auto refuse = [&](const std::string& why) {
    throw OptionError("tableau", "tableau '" + tableau.name + "': " + why);
  };
  if (s < 1 || tableau.c.size() != s || tableau.A.rows() != s || tableau.A.cols() != s)
    refuse("A must be s x s, b and c of length s >= 1");
  if (!tableau.A.allFinite() || !tableau.b.allFinite() || !tableau.c.allFinite()) refuse("a coefficient is not finite");
  if (tableau.A.triangularView<Eigen::Upper>().toDenseMatrix().cwiseAbs().maxCoeff() > 0.0)
    refuse("A must be strictly lower triangular: only explicit methods");
  if (std::abs(tableau.b.sum() - 1.0) > 1e-12) refuse("the weights b must add up to 1");
  if (tableau.c[0] != 0.0) refuse("c[0] must be 0: the first stage is at the start of the step");
}

/// Y_i = y + h sum_j a_ij f(t + c_j h, Y_j),   y' = y + h sum_i b_i f(t + c_i h, Y_i)
class RungeKutta final : public Integrator {
 public:
  explicit RungeKutta(const ButcherTableau& tableau) : tableau_(tableau) { check(tableau); }

  const std::string& name() const override { return tableau_.name; }
  int order() const override { return tableau_.order; }
  void start(int y_size) override {
    k_.resize(y_size, tableau_.b.size());
    stage_.resize(y_size);
  }

  void step(Dynamics& dynamics, double t, double h, VectorXd& y) override {
    dynamics.hold_correction(deadbeat_gains(tableau_.b.dot(tableau_.c), h));
    dynamics.rates(k_.col(0));
    for (Eigen::Index i = 1; i < tableau_.b.size(); ++i) {
      stage_ = y;
      for (Eigen::Index j = 0; j < i; ++j)
        if (tableau_.A(i, j) != 0.0) stage_ += (h * tableau_.A(i, j)) * k_.col(j);
      dynamics.evaluate(t + tableau_.c[i] * h, stage_);
      dynamics.rates(k_.col(i));
    }
    for (Eigen::Index i = 0; i < tableau_.b.size(); ++i)
      if (tableau_.b[i] != 0.0) y += (h * tableau_.b[i]) * k_.col(i);
    dynamics.release_correction();
  }

 private:
  ButcherTableau tableau_;
  MatrixXd k_;
  VectorXd stage_;
};

}  // namespace

std::unique_ptr<Integrator> make_runge_kutta(const ButcherTableau& tableau) {
  return std::make_unique<RungeKutta>(tableau);
}

}  // namespace linkwork
