#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "linkwork/model/body_state.hpp"

namespace linkwork {

/// A quantity given as a function of time [s], with its first two derivatives.
class TimeFunction {
 public:
  virtual ~TimeFunction() = default;
  virtual Signal<double> evaluate(double t) const = 0;
  /// False where `rate` and `acceleration` are not known: then it cannot drive a constraint.
  virtual bool has_derivatives() const { return true; }
  /// False for a function of something else, such as a length: it is evaluated by the elements that it belongs to.
  virtual bool of_time() const { return true; }
};

using TimeFunctionPtr = std::shared_ptr<const TimeFunction>;

/// f(t) = sum c_k t^k.
TimeFunctionPtr polynomial(std::vector<double> coefficients);

/// f(t) = offset + amplitude sin(frequency t + phase); frequency in rad/s.
TimeFunctionPtr harmonic(double amplitude, double frequency, double phase, double offset);

/// f(t) = sum_k c[i][k] (t - t_i)^k on [t_i, t_{i+1}); coefficients hold `pieces` rows of equal length, ascending
/// powers. Outside of [t_0, t_n] an evaluation throws an OptionError.
TimeFunctionPtr piecewise_polynomial(std::vector<double> breaks, std::vector<double> coefficients);

/// Rises by `rise` from `start` on within `duration`, smoothly up to the second derivative: rise (s - sin(2 pi s) / 2
/// pi), s = (t - start) / duration; constant before and after.
TimeFunctionPtr cycloidal(double rise, double start, double duration);

TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms);

/// The same function, of a coordinate or a velocity of a force element instead of time. Outside of a table an
/// evaluation throws an OptionError.
TimeFunctionPtr characteristic(TimeFunctionPtr function);

/// Any functions of time; without `rate` and `acceleration` it has no derivatives.
TimeFunctionPtr callback(std::function<double(double)> value, std::function<double(double)> rate = {},
                         std::function<double(double)> acceleration = {});

}  // namespace linkwork
