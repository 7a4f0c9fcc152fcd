#include "linkwork/model/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

/// Horner's scheme for a polynomial and its first two derivatives; ascending powers.
Signal<double> horner(const double* c, std::size_t count, double x) {
  double f = 0.0, df = 0.0, half_ddf = 0.0;
  for (std::size_t k = count; k-- > 0;) {
    half_ddf = half_ddf * x + df;
    df = df * x + f;
    f = f * x + c[k];
  }
  return {f, df, 2.0 * half_ddf};
}

class Polynomial final : public TimeFunction {
 public:
  explicit Polynomial(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {}
  Signal<double> evaluate(double t) const override { return horner(coefficients_.data(), coefficients_.size(), t); }

 private:
  std::vector<double> coefficients_;
};

class Harmonic final : public TimeFunction {
 public:
  Harmonic(double amplitude, double frequency, double phase, double offset)
      : amplitude_(amplitude), frequency_(frequency), phase_(phase), offset_(offset) {}

  Signal<double> evaluate(double t) const override {
    const double angle = frequency_ * t + phase_;
    const double sine = amplitude_ * std::sin(angle), cosine = amplitude_ * std::cos(angle);
    return {offset_ + sine, frequency_ * cosine, -frequency_ * frequency_ * sine};
  }

 private:
  double amplitude_, frequency_, phase_, offset_;
};

class Characteristic final : public TimeFunction {
 public:
  explicit Characteristic(TimeFunctionPtr function) : function_(std::move(function)) {}
  Signal<double> evaluate(double x) const override {
    try {
      return function_->evaluate(x);
    } catch (const OptionError& error) {
      throw OptionError("outside_table", "the characteristic of a force element has no value at " + std::to_string(x) +
                                             ": the motion leaves its table; extend it");
    }
  }
  bool has_derivatives() const override { return function_->has_derivatives(); }
  bool of_time() const override { return false; }

 private:
  TimeFunctionPtr function_;
};

class PiecewisePolynomial final : public TimeFunction {
 public:
  PiecewisePolynomial(std::vector<double> breaks, std::vector<double> coefficients)
      : breaks_(std::move(breaks)), coefficients_(std::move(coefficients)) {
    const auto fault = std::adjacent_find(breaks_.begin(), breaks_.end(), std::greater_equal<>());
    if (breaks_.size() < 2 || fault != breaks_.end())
      throw ModelError("time_function", "piecewise polynomial: breaks must be at least two and strictly increasing");
    if (coefficients_.empty() || coefficients_.size() % (breaks_.size() - 1) != 0)
      throw ModelError("time_function", "piecewise polynomial: coefficients must be a row for each interval");
    count_ = coefficients_.size() / (breaks_.size() - 1);
  }

  Signal<double> evaluate(double t) const override {
    const double slack = 1e-9 * (breaks_.back() - breaks_.front());  // roundoff of a last step
    if (!(t >= breaks_.front() - slack && t <= breaks_.back() + slack))
      throw OptionError("time_function_range", "table of a time function covers " + std::to_string(breaks_.front()) +
                                                   " to " + std::to_string(breaks_.back()) + " s, not t = " +
                                                   std::to_string(t) + " s; extend the table or shorten the run");
    const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t);
    const std::size_t piece = static_cast<std::size_t>(after - breaks_.begin()) - 1;
    return horner(coefficients_.data() + piece * count_, count_, t - breaks_[piece]);
  }

 private:
  std::vector<double> breaks_, coefficients_;
  std::size_t count_ = 0;
};

class Cycloidal final : public TimeFunction {
 public:
  Cycloidal(double rise, double start, double duration) : rise_(rise), start_(start), duration_(duration) {
    if (!(duration > 0.0)) throw ModelError("time_function", "cycloidal: duration must be positive");
  }

  Signal<double> evaluate(double t) const override {
    constexpr double turn = 2.0 * std::numbers::pi;
    const double s = (t - start_) / duration_;
    if (s <= 0.0) return {0.0, 0.0, 0.0};
    if (s >= 1.0) return {rise_, 0.0, 0.0};
    return {rise_ * (s - std::sin(turn * s) / turn), rise_ / duration_ * (1.0 - std::cos(turn * s)),
            rise_ / (duration_ * duration_) * turn * std::sin(turn * s)};
  }

 private:
  double rise_, start_, duration_;
};

class Sum final : public TimeFunction {
 public:
  explicit Sum(std::vector<TimeFunctionPtr> terms) : terms_(std::move(terms)) {}

  Signal<double> evaluate(double t) const override {
    Signal<double> out{0.0, 0.0, 0.0};
    for (const TimeFunctionPtr& term : terms_) {
      const Signal<double> part = term->evaluate(t);
      out.value += part.value;
      out.rate += part.rate;
      out.acceleration += part.acceleration;
    }
    return out;
  }
  bool has_derivatives() const override {
    return std::all_of(terms_.begin(), terms_.end(), [](const auto& term) { return term->has_derivatives(); });
  }

 private:
  std::vector<TimeFunctionPtr> terms_;
};

class Callback final : public TimeFunction {
 public:
  using Function = std::function<double(double)>;
  Callback(Function value, Function rate, Function acceleration)
      : value_(std::move(value)), rate_(std::move(rate)), acceleration_(std::move(acceleration)) {}

  Signal<double> evaluate(double t) const override {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {value_(t), rate_ ? rate_(t) : unknown, acceleration_ ? acceleration_(t) : unknown};
  }
  bool has_derivatives() const override { return rate_ && acceleration_; }

 private:
  Function value_, rate_, acceleration_;
};

}  // namespace

TimeFunctionPtr polynomial(std::vector<double> coefficients) {
  return std::make_shared<Polynomial>(std::move(coefficients));
}

TimeFunctionPtr harmonic(double amplitude, double frequency, double phase, double offset) {
  return std::make_shared<Harmonic>(amplitude, frequency, phase, offset);
}

TimeFunctionPtr piecewise_polynomial(std::vector<double> breaks, std::vector<double> coefficients) {
  return std::make_shared<PiecewisePolynomial>(std::move(breaks), std::move(coefficients));
}

TimeFunctionPtr cycloidal(double rise, double start, double duration) {
  return std::make_shared<Cycloidal>(rise, start, duration);
}

TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms) { return std::make_shared<Sum>(std::move(terms)); }

TimeFunctionPtr characteristic(TimeFunctionPtr function) {
  return std::make_shared<Characteristic>(std::move(function));
}

TimeFunctionPtr callback(std::function<double(double)> value, std::function<double(double)> rate,
                         std::function<double(double)> acceleration) {
  return std::make_shared<Callback>(std::move(value), std::move(rate), std::move(acceleration));
}

}  // namespace linkwork
