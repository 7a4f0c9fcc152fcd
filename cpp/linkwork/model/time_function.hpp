#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/model/body_state.hpp"

namespace linkwork {

/// A time [s] at which a function is not smooth. What `ends_step` is a step's end, always; the others are knots of
/// tables with two continuous derivatives, of which there may be thousands: a step may go over several, where
/// TimeFunction::watched says that it sees what is between them.
struct Break {
  double t;
  bool ends_step = true;
  double share = 1.0;  ///< of the largest jump of its function; 1 where that is not known
};

class TimeFunction;
using TimeFunctionPtr = std::shared_ptr<const TimeFunction>;

/// A quantity given as a function of time [s], with its first two derivatives.
class TimeFunction {
 public:
  virtual ~TimeFunction() = default;
  virtual Signal<double> evaluate(double t) const = 0;
  /// False where `rate` and `acceleration` are not known: then it cannot drive a constraint.
  virtual bool has_derivatives() const { return true; }
  /// By how much any two values differ at most; infinite where nobody knows.
  virtual double amplitude() const { return std::numeric_limits<double>::infinity(); }
  /// A bound of the second derivative from `from` to `to`; of functions of the user's own twice what is seen at a few
  /// times in between. Between breaks only, and infinite where nobody knows.
  virtual double largest_acceleration(double from, double to) const {
    static_cast<void>(from), static_cast<void>(to);
    return std::numeric_limits<double>::infinity();
  }
  /// False for a function of something else, such as a length: it is evaluated by the elements that it belongs to.
  virtual bool of_time() const { return true; }
  /// Appends the times, or the other arguments, at which it is not smooth, as far as they are known in advance.
  virtual void add_breaks(std::vector<Break>& out) const { static_cast<void>(out); }
  /// The antiderivative that is zero at 0, or at the end of a table next to that; null where it is not known.
  virtual TimeFunctionPtr integral() const { return nullptr; }
  /// Appends, for each table in it that has breaks which end no step, a function whose second derivative is what the
  /// accelerations feel: the table itself where it drives (`driven`), else its second integral. Its first derivative
  /// tells the integral over a step without quadrature.
  virtual void add_watched(bool driven, std::vector<TimeFunctionPtr>& out) const {
    static_cast<void>(driven), static_cast<void>(out);
  }
};

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

/// The same function, not smooth at these times [s], either.
TimeFunctionPtr with_breaks(TimeFunctionPtr function, std::vector<double> times);

/// The same function, of a coordinate or a velocity of a force element instead of time. Outside of a table an
/// evaluation throws an OptionError, which says of what it is: the element and its parameter.
TimeFunctionPtr characteristic(TimeFunctionPtr function, std::string of);
inline constexpr const char* outside_table = "outside_table";  ///< code of that error

/// Any functions of time; without `rate` and `acceleration` it has no derivatives.
TimeFunctionPtr callback(std::function<double(double)> value, std::function<double(double)> rate = {},
                         std::function<double(double)> acceleration = {});

}  // namespace linkwork
