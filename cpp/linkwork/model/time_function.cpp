#include "linkwork/model/time_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr int looks = 8;                       // at functions of the user's own in an interval,
constexpr double golden = 0.6180339887498949;  // where they are in step with no period
constexpr double last_step = 1e-9;             // of a table: roundoff by which a run may end behind it

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

/// Taylor's shift of a polynomial.
void shift(std::vector<double>& c, double by) {
  for (std::size_t k = 0; by != 0.0 && k + 1 < c.size(); ++k)
    for (std::size_t j = c.size() - 1; j-- > k;) c[j] += by * c[j + 1];
}

/// A bound of the second derivative of a polynomial up to `reach` from its origin.
double largest_second_derivative(const std::vector<double>& c, double reach) {
  double sum = 0.0;
  for (std::size_t k = c.size(); k-- > 2;) sum = sum * reach + static_cast<double>(k * (k - 1)) * std::abs(c[k]);
  return sum;
}

/// The coefficients of an antiderivative but for the first.
void append_integrated(const std::vector<double>& c, std::vector<double>& out) {
  for (std::size_t k = 0; k < c.size(); ++k) out.push_back(c[k] / static_cast<double>(k + 1));
}

class Polynomial final : public TimeFunction {
 public:
  explicit Polynomial(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {}
  Signal<double> evaluate(double t) const override { return horner(coefficients_.data(), coefficients_.size(), t); }
  TimeFunctionPtr integral() const override {
    std::vector<double> out{0.0};
    append_integrated(coefficients_, out);
    return polynomial(std::move(out));
  }
  double amplitude() const override { return coefficients_.size() > 1 ? INFINITY : 0.0; }
  double largest_acceleration(double from, double to) const override {
    std::vector<double> c = coefficients_;
    shift(c, 0.5 * (from + to));
    return largest_second_derivative(c, 0.5 * std::abs(to - from));
  }

 private:
  std::vector<double> coefficients_;
};

/// From 0, where the two cosines that it is the difference of are equal.
class IntegratedHarmonic final : public TimeFunction {
 public:
  IntegratedHarmonic(double amplitude, double frequency, double phase, double offset)
      : amplitude_(amplitude), frequency_(frequency), phase_(phase), offset_(offset) {}

  Signal<double> evaluate(double t) const override {
    const double half = 0.5 * frequency_ * t;
    const elementary::SineAndCosine of_half = elementary::sine_and_cosine(half);
    const elementary::SineAndCosine of_middle = elementary::sine_and_cosine(half + phase_);
    const elementary::SineAndCosine of_angle = elementary::sine_and_cosine(frequency_ * t + phase_);
    const double way = half == 0.0 ? t : of_half.sine / half * t;
    return {offset_ * t + amplitude_ * (way * of_middle.sine), offset_ + amplitude_ * of_angle.sine,
            frequency_ * (amplitude_ * of_angle.cosine)};
  }
  double largest_acceleration(double, double) const override { return std::abs(frequency_ * amplitude_); }

 private:
  double amplitude_, frequency_, phase_, offset_;
};

class Harmonic final : public TimeFunction {
 public:
  Harmonic(double amplitude, double frequency, double phase, double offset)
      : amplitude_(amplitude), frequency_(frequency), phase_(phase), offset_(offset) {}

  Signal<double> evaluate(double t) const override {
    const elementary::SineAndCosine of_angle = elementary::sine_and_cosine(frequency_ * t + phase_);
    const double sine = amplitude_ * of_angle.sine;
    return {offset_ + sine, frequency_ * (amplitude_ * of_angle.cosine), -frequency_ * frequency_ * sine};
  }
  TimeFunctionPtr integral() const override {
    return std::make_shared<IntegratedHarmonic>(amplitude_, frequency_, phase_, offset_);
  }
  double amplitude() const override { return 2.0 * std::abs(amplitude_); }
  double largest_acceleration(double, double) const override { return frequency_ * frequency_ * std::abs(amplitude_); }

 private:
  double amplitude_, frequency_, phase_, offset_;
};

class Characteristic final : public TimeFunction {
 public:
  Characteristic(TimeFunctionPtr function, std::string of)
      : function_(std::move(function)), integral_(function_->integral()), of_(std::move(of)) {}
  Signal<double> evaluate(double x) const override {
    try {
      return function_->evaluate(x);
    } catch (const OptionError& error) {
      throw OptionError(outside_table,
                        of_ + " has no value at " + std::to_string(x) + ": the motion leaves its table; extend it");
    }
  }
  bool has_derivatives() const override { return function_->has_derivatives(); }
  bool of_time() const override { return false; }
  void add_breaks(std::vector<Break>& out) const override { function_->add_breaks(out); }
  TimeFunctionPtr integral() const override { return integral_; }

 private:
  TimeFunctionPtr function_, integral_;
  std::string of_;
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
    origins_.assign(breaks_.begin(), breaks_.end() - 1);
  }

  Signal<double> evaluate(double t) const override {
    const double slack = last_step * (breaks_.back() - breaks_.front());
    if (!(t >= breaks_.front() - slack && t <= breaks_.back() + slack))
      throw OptionError("time_function_range", "table of a time function covers " + std::to_string(breaks_.front()) +
                                                   " to " + std::to_string(breaks_.back()) + " s, not t = " +
                                                   std::to_string(t) + " s; extend the table or shorten the run");
    const std::size_t piece = piece_at(t);
    return horner(coefficients_.data() + piece * count_, count_, t - origins_[piece]);
  }

  TimeFunctionPtr integral() const override { return integrated().shared(); }
  double largest_acceleration(double from, double to) const override {
    double largest = 0.0;
    const std::size_t last = piece_at(to);
    for (std::size_t piece = piece_at(from); piece <= last; ++piece) {
      const double begin = std::max(from, breaks_[piece]), end = std::min(to, breaks_[piece + 1]);
      const std::vector<double> c = about(0.5 * (begin + end), piece);
      largest = std::max(largest, largest_second_derivative(c, 0.5 * std::abs(end - begin)));
    }
    return largest;
  }

  /// First and last knots, and those at which the value or a derivative jumps by more than roundoff.
  void add_breaks(std::vector<Break>& out) const override {
    std::vector<std::pair<double, Jump>> found;
    Jump largest{count_, 0.0};
    for (std::size_t knot = 1; knot + 1 < breaks_.size(); ++knot) {
      const Jump it = jump(knot);
      if (it.order == count_) continue;
      found.emplace_back(breaks_[knot], it);
      if (it.order < largest.order || (it.order == largest.order && it.size > largest.size)) largest = it;
    }
    out.push_back({breaks_.front()});
    for (const auto& [t, it] : found)
      out.push_back({t, it.order < smooth, it.order == largest.order ? it.size / largest.size : 0.0});
    out.push_back({breaks_.back()});
  }

  void add_watched(bool driven, std::vector<TimeFunctionPtr>& out) const override {
    std::vector<Break> breaks;
    add_breaks(breaks);
    if (std::all_of(breaks.begin(), breaks.end(), [](const Break& it) { return it.ends_step; })) return;
    out.push_back(driven ? std::make_shared<PiecewisePolynomial>(*this) : integrated().integrated().shared());
  }

 private:
  static constexpr std::size_t smooth = 3;   // continuous: value, first and second derivative
  static constexpr double roundoff = 1e-11;  // of the terms of a polynomial

  std::size_t piece_at(double t) const {
    return static_cast<std::size_t>(std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, t) - breaks_.begin()) - 1;
  }

  std::shared_ptr<const PiecewisePolynomial> shared() const { return std::make_shared<PiecewisePolynomial>(*this); }

  struct Jump {
    std::size_t order;
    double size;
  };

  /// Of the lowest derivative that jumps at a knot; as many as there are coefficients: none. Over the shorter one of the
  /// two intervals a jump counts by what it makes of the value.
  Jump jump(std::size_t knot) const {
    const double left = breaks_[knot] - breaks_[knot - 1], right = breaks_[knot + 1] - breaks_[knot];
    const double shorter = std::min(left, right);
    std::vector<double> before = about(breaks_[knot - 1], knot - 1);
    const std::vector<double> after = about(breaks_[knot], knot);
    double size = 0.0, power = 1.0;
    for (std::size_t k = 0; k < count_; ++k, power *= shorter) size = std::max(size, std::abs(after[k]) * power);
    power = 1.0;
    for (std::size_t k = 0; k < count_; ++k, power *= left) size = std::max(size, std::abs(before[k]) * power);
    shift(before, left);
    power = 1.0;
    for (std::size_t k = 0; k < count_; ++k, power *= shorter)
      if (const double by = std::abs(after[k] - before[k]); by * power > roundoff * size) return {k, by};
    return {count_, 0.0};
  }

  /// Coefficients of a piece in powers of t - origin.
  std::vector<double> about(double origin, std::size_t piece) const {
    const auto first = coefficients_.begin() + static_cast<std::ptrdiff_t>(piece * count_);
    std::vector<double> out(first, first + static_cast<std::ptrdiff_t>(count_));
    shift(out, origin - origins_[piece]);
    return out;
  }

  /// Integrated piece by piece from 0, or the end next to that, in both directions; each about its end that is nearer:
  /// tables may reach very far on both sides.
  PiecewisePolynomial integrated() const {
    const std::size_t pieces = origins_.size(), each = count_ + 1;
    const double start = std::clamp(0.0, breaks_.front(), breaks_.back());
    const std::size_t first = piece_at(start);
    std::vector<double> origins, out;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      origins.push_back(piece < first ? breaks_[piece + 1] : piece > first ? breaks_[piece] : start);
      out.push_back(0.0);
      append_integrated(about(origins.back(), piece), out);
    }
    const auto at = [&](std::size_t piece, double t) {
      return horner(out.data() + piece * each, each, t - origins[piece]).value;
    };
    for (std::size_t k = first + 1; k < pieces; ++k) out[k * each] = at(k - 1, breaks_[k]);
    for (std::size_t k = first; k-- > 0;) out[k * each] = at(k + 1, breaks_[k + 1]);
    PiecewisePolynomial integral(breaks_, std::move(out));
    integral.origins_ = std::move(origins);
    return integral;
  }

  std::vector<double> breaks_, coefficients_;
  std::vector<double> origins_;  ///< of the powers of each piece
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
    const auto [sine, cosine] = elementary::sine_and_cosine(turn * s);
    return {rise_ * (s - sine / turn), rise_ / duration_ * (1.0 - cosine),
            rise_ / (duration_ * duration_) * turn * sine};
  }
  void add_breaks(std::vector<Break>& out) const override {
    out.push_back({start_});
    out.push_back({start_ + duration_});
  }
  double amplitude() const override { return std::abs(rise_); }
  double largest_acceleration(double from, double to) const override {
    if (to <= start_ || from >= start_ + duration_) return 0.0;
    return 2.0 * std::numbers::pi * std::abs(rise_) / (duration_ * duration_);
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
  void add_breaks(std::vector<Break>& out) const override {
    for (const TimeFunctionPtr& term : terms_) term->add_breaks(out);
  }
  void add_watched(bool driven, std::vector<TimeFunctionPtr>& out) const override {
    for (const TimeFunctionPtr& term : terms_) term->add_watched(driven, out);
  }
  TimeFunctionPtr integral() const override {
    std::vector<TimeFunctionPtr> out;
    for (const TimeFunctionPtr& term : terms_) out.push_back(term->integral());
    return std::find(out.begin(), out.end(), nullptr) == out.end() ? sum(std::move(out)) : nullptr;
  }
  double amplitude() const override {
    double sum = 0.0;
    for (const TimeFunctionPtr& term : terms_) sum += term->amplitude();
    return sum;
  }
  double largest_acceleration(double from, double to) const override {
    double largest = 0.0;
    for (const TimeFunctionPtr& term : terms_) largest += term->largest_acceleration(from, to);
    return largest;
  }

 private:
  std::vector<TimeFunctionPtr> terms_;
};

class WithBreaks final : public TimeFunction {
 public:
  WithBreaks(TimeFunctionPtr function, std::vector<double> times)
      : function_(std::move(function)), times_(std::move(times)) {
    if (!std::all_of(times_.begin(), times_.end(), [](double t) { return std::isfinite(t); }))
      throw ModelError("breaks", "breaks must be finite times [s]");
  }

  Signal<double> evaluate(double t) const override { return function_->evaluate(t); }
  double amplitude() const override { return function_->amplitude(); }
  double largest_acceleration(double from, double to) const override {
    return function_->largest_acceleration(from, to);
  }
  bool has_derivatives() const override { return function_->has_derivatives(); }
  bool of_time() const override { return function_->of_time(); }
  void add_breaks(std::vector<Break>& out) const override {
    function_->add_breaks(out);
    for (const double t : times_) out.push_back({t});
  }
  void add_watched(bool driven, std::vector<TimeFunctionPtr>& out) const override {
    function_->add_watched(driven, out);
  }
  TimeFunctionPtr integral() const override { return function_->integral(); }

 private:
  TimeFunctionPtr function_;
  std::vector<double> times_;
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
  double largest_acceleration(double from, double to) const override {
    if (!acceleration_) return INFINITY;
    double largest = 0.0;
    for (int k = 0; k < looks; ++k)
      largest = std::max(largest, std::abs(acceleration_(from + (k + golden) / looks * (to - from))));
    return 2.0 * largest;
  }

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

TimeFunctionPtr with_breaks(TimeFunctionPtr function, std::vector<double> times) {
  return std::make_shared<WithBreaks>(std::move(function), std::move(times));
}

TimeFunctionPtr characteristic(TimeFunctionPtr function, std::string of) {
  return std::make_shared<Characteristic>(std::move(function), std::move(of));
}

TimeFunctionPtr callback(std::function<double(double)> value, std::function<double(double)> rate,
                         std::function<double(double)> acceleration) {
  return std::make_shared<Callback>(std::move(value), std::move(rate), std::move(acceleration));
}

}  // namespace linkwork
