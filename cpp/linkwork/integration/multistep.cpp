#include <cmath>
#include <utility>

#include "linkwork/integration/integrator.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double same_step = 1e-6;  // t + h - t has the roundoff of t

void check(const MultistepCoefficients& method) {
  const auto refuse = [&](const std::string& why) {
    throw OptionError("multistep", "multistep method '" + method.name + "': " + why);
  };
  if (method.predictor.size() < 1) refuse("has no predictor");
  if (std::abs(method.predictor.sum() - 1.0) > consistency) refuse("the predictor's coefficients must add up to 1");
  if (method.corrector.size() > 0 && std::abs(method.corrector.sum() - 1.0) > consistency)
    refuse("the corrector's coefficients must add up to 1");
  if (method.corrector.size() > method.predictor.size() + 1)
    refuse("the corrector reaches further back than the predictor");
}

/// Adams-Bashforth, or Adams-Bashforth-Moulton in the mode PECE, at a fixed step.
///
/// Sampled stabilization stays out of the stored rates: f is that of the mechanism itself, and each step adds the
/// correction once (Dynamics::add_correction). The violation then has a nilpotent map, which a held u inside f would
/// not give here.
class Multistep final : public Integrator {
 public:
  explicit Multistep(const MultistepCoefficients& method)
      : method_(method), starter_(make_runge_kutta(method.starter)) {
    check(method);
  }

  const std::string& name() const override { return method_.name; }
  int order() const override { return method_.order; }
  int memory() const override { return static_cast<int>(method_.predictor.size()) - 1; }
  void start(int y_size) override {
    f_.assign(method_.predictor.size(), VectorXd::Zero(y_size));
    predicted_rates_.resize(y_size);
    correction_.resize(y_size);
    filled_ = 0;
    last_step_ = 0.0;
    starter_->start(y_size);
  }

  void keep(Archive& archive) override { archive(f_, filled_, last_step_); }

  void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) override {
    const double h = step.h;
    if (filled_ > 0 && std::abs(h - last_step_) > same_step * h) filled_ = 0;  // another step: begin anew
    last_step_ = h;
    store(dynamics);
    if (filled_ < f_.size()) return starter_->step(dynamics, step, y);
    correction_.setZero();
    dynamics.add_correction(h, correction_);
    if (method_.corrector.size() == 0) y += combine(method_.predictor, 0, h) + correction_;
    else y = correct(dynamics, step, y);
  }

 private:
  void store(Dynamics& dynamics) {
    VectorXd oldest = std::move(f_.back());
    f_.pop_back();
    dynamics.rates(oldest);
    f_.insert(f_.begin(), std::move(oldest));
    filled_ = std::min(filled_ + 1, f_.size());
  }

  /// h sum_k coefficients[first + k] f_{n-k}
  VectorXd combine(const VectorXd& coefficients, Eigen::Index first, double h) const {
    VectorXd sum = VectorXd::Zero(predicted_rates_.size());
    for (Eigen::Index k = first; k < coefficients.size(); ++k) sum += (h * coefficients[k]) * f_[k - first];
    return sum;
  }

  VectorXd correct(Dynamics& dynamics, const StepSpan& step, const VectorXd& y) {
    const double h = step.h;
    const VectorXd predicted = y + combine(method_.predictor, 0, h) + correction_;
    dynamics.evaluate(step.at(1.0), predicted);
    dynamics.rates(predicted_rates_);
    return y + (h * method_.corrector[0]) * predicted_rates_ + combine(method_.corrector, 1, h) + correction_;
  }

  MultistepCoefficients method_;
  std::unique_ptr<Integrator> starter_;
  std::vector<VectorXd> f_;  ///< newest first
  std::size_t filled_ = 0;
  double last_step_ = 0.0;
  VectorXd predicted_rates_, correction_;
};

}  // namespace

std::unique_ptr<Integrator> make_multistep(const MultistepCoefficients& coefficients) {
  return std::make_unique<Multistep>(coefficients);
}

}  // namespace linkwork
