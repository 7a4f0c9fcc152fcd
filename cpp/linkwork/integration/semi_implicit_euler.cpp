#include "linkwork/integration/integrator.hpp"

namespace linkwork {
namespace {

class SemiImplicitEuler final : public Integrator {
 public:
  const std::string& name() const override { return name_; }
  int order() const override { return 1; }
  void start(int y_size) override { rates_.resize(y_size); }

  void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) override {
    const double h = step.h;
    const int nq = dynamics.system().q_size(), nv = dynamics.system().v_size();
    dynamics.begin_zero_order_hold(deadbeat_gains(1.0, h), h);
    dynamics.rates(rates_);
    dynamics.end_zero_order_hold();
    y.tail(nv + 1) += h * rates_.tail(nv + 1);
    dynamics.system().position_rates(y.head(nq), y.segment(nq, nv), rates_.head(nq));
    y.head(nq) += h * rates_.head(nq);
  }

 private:
  std::string name_ = "semi_implicit_euler";
  VectorXd rates_;
};

}  // namespace

std::unique_ptr<Integrator> make_semi_implicit_euler() { return std::make_unique<SemiImplicitEuler>(); }

}  // namespace linkwork
