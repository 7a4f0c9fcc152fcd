#include <cmath>

#include "linkwork/integration/runge_kutta.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/pieces.hpp"

namespace linkwork {

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
  if (std::abs(tableau.b.sum() - 1.0) > consistency) refuse("the weights b must add up to 1");
  if (tableau.c[0] != 0.0) refuse("c[0] must be 0: the first stage is at the start of the step");
}

void add_combination(double h, const ConstVector& weights, const MatrixXd& k, VectorXd& y) {
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (weights[i] != 0.0) y += (h * weights[i]) * k.col(i);
}

void evaluate_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                     MatrixXd& k, VectorXd& stage) {
  evaluate_first_stage(tableau, dynamics, step, k);
  evaluate_later_stages(tableau, dynamics, step, y, k, stage);
}

void evaluate_first_stage(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, MatrixXd& k) {
  dynamics.begin_zero_order_hold(deadbeat_gains(tableau.b.dot(tableau.c), step.h), step.h);
  dynamics.rates(k.col(0));
}

void evaluate_free_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                          MatrixXd& k, VectorXd& stage) {
  dynamics.rates(k.col(0));
  evaluate_later_stages(tableau, dynamics, step, y, k, stage);
}

void evaluate_later_stages(const ButcherTableau& tableau, Dynamics& dynamics, const StepSpan& step, const VectorXd& y,
                           MatrixXd& k, VectorXd& stage) {
  const double h = step.h;
  for (Eigen::Index i = 1; i < tableau.b.size(); ++i) {
    stage.resize(y.size());
    in_pieces(dynamics.system().threads(), y.size(), [&](Eigen::Index first, Eigen::Index count) {
      auto piece = stage.segment(first, count);
      piece = y.segment(first, count);
      for (Eigen::Index j = 0; j < i; ++j)
        if (tableau.A(i, j) != 0.0) piece += (h * tableau.A(i, j)) * k.col(j).segment(first, count);
    });
    dynamics.evaluate(step.at(tableau.c[i]), stage, static_cast<int>(i) + 1);
    dynamics.rates(k.col(i));
  }
}

namespace {

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

  void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) override {
    evaluate_stages(tableau_, dynamics, step, y, k_, stage_);
    in_pieces(dynamics.system().threads(), y.size(), [&](Eigen::Index first, Eigen::Index count) {
      auto piece = y.segment(first, count);
      for (Eigen::Index i = 0; i < tableau_.b.size(); ++i)
        if (tableau_.b[i] != 0.0) piece += (step.h * tableau_.b[i]) * k_.col(i).segment(first, count);
    });
    dynamics.end_zero_order_hold();
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
