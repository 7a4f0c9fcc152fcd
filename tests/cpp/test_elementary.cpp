#include "linkwork/math/elementary.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace linkwork::elementary;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nothing = std::numeric_limits<double>::quiet_NaN();

/// Difference to a value of long double, in units of the last place of that.
double units(double found, long double right) {
  const double near = static_cast<double>(right);
  const double unit = std::nextafter(std::abs(near), infinity) - std::abs(near);
  return static_cast<double>(std::abs(static_cast<long double>(found) - right)) / unit;
}

/// The largest difference at arguments between these, or at 2^x and -2^x of them.
template <class Own, class Right>
double worst(Own own, Right right, double least, double most, bool powers = false) {
  std::mt19937_64 random(7);
  double largest = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double u = least + (most - least) * (static_cast<double>(random() >> 11) * 0x1p-53);
    const double x = powers ? std::ldexp(random() & 1 ? 1.3 : -1.9, static_cast<int>(u)) : u;
    largest = std::max(largest, units(own(x), right(static_cast<long double>(x))));
  }
  return largest;
}

}  // namespace

TEST_CASE("sine and cosine are right to a unit in the last place, also of large arguments") {
  const auto sin = [](long double x) { return std::sin(x); };
  const auto cos = [](long double x) { return std::cos(x); };
  for (const double most : {1.0, 10.0, 1e3, 1e6, 1e9}) {
    CHECK(worst(sine, sin, -most, most) < 0.85);
    CHECK(worst(cosine, cos, -most, most) < 0.85);
  }
  CHECK(worst(sine, sin, -40, 1000, true) < 0.85);
  CHECK(worst(cosine, cos, -40, 1000, true) < 0.85);
}

TEST_CASE("sine and cosine together have the bits of each") {
  for (const double x : {0.0, 1e-9, 0.5, -1.0, 1.6, 3.0, -4.5, 6.0, 1e3, -7e8, 1e300, infinity}) {
    const auto [together_sine, together_cosine] = sine_and_cosine(x);
    CAPTURE(x);
    CHECK(std::bit_cast<std::uint64_t>(together_sine) == std::bit_cast<std::uint64_t>(sine(x)));
    CHECK(std::bit_cast<std::uint64_t>(together_cosine) == std::bit_cast<std::uint64_t>(cosine(x)));
  }
}

// The doubles next to multiples of pi / 2 (Muller, Elementary Functions, section 11.1, and one of 2^24), values by mpmath.
TEST_CASE("sine and cosine keep their digits where they all but vanish") {
  struct Near {
    double (*f)(double);
    double x, value;
  };
  for (const auto& [f, x, value] : {Near{cosine, 0x1.6ac5b262ca1ffp+849, -4.6871659242546277e-19},
                                    Near{sine, 28922353.340556760, 3.3970076597972008e-18}})
    CHECK(std::abs(f(x) / value - 1.0) < 2.3e-16);
}

TEST_CASE("arc tangent, exponential, logarithm and powers are right to a unit in the last place") {
  for (const double x : {1.0, -1.0, 0.3, -7e150, 1e-200}) {
    const auto own = [x](double y) { return arc_tangent(y, x); };
    const auto right = [x](long double y) { return std::atan2(y, static_cast<long double>(x)); };
    CHECK(worst(own, right, -60, 60, true) < 0.6);
    CHECK(worst(own, right, -3, 3) < 0.6);
  }
  CHECK(worst(exponential, [](long double x) { return std::exp(x); }, -700, 700) < 0.7);
  CHECK(worst(logarithm, [](long double x) { return std::log(x); }, 1e-3, 1e3) < 0.6);
  for (const double y : {1.5, 2.2, -0.2, -0.14})
    CHECK(worst([y](double x) { return power(x, y); },
                [y](long double x) { return std::pow(x, static_cast<long double>(y)); }, 1e-6, 1e6) < 0.8);
  CHECK(worst(hyperbolic_tangent, [](long double x) { return std::tanh(x); }, -20, 5, true) < 3.0);
}

TEST_CASE("exact cases are exact") {
  CHECK(power(-2.0, 3.0) == -8.0);
  CHECK(power(3.0, 0.0) == 1.0);
  CHECK(power(0.0, 2.0) == 0.0);
  CHECK(std::isnan(power(-2.0, 0.5)));
  CHECK(arc_tangent(0.0, -1.0) == std::atan2(0.0, -1.0));
  CHECK(arc_tangent(1.0, 1.0) == std::atan2(1.0, 1.0));
  CHECK(exponential(0.0) == 1.0);
  CHECK(exponential(1e3) == infinity);
  CHECK(exponential(-1e3) == 0.0);
  CHECK(logarithm(1.0) == 0.0);
  CHECK(logarithm(0.0) == -infinity);
  CHECK(hyperbolic_tangent(-50.0) == -1.0);
  for (const auto f : {sine, cosine}) {
    CHECK(f(0.0) == (f == cosine ? 1.0 : 0.0));
    CHECK(std::isnan(f(infinity)));
    CHECK(std::isnan(f(nothing)));
  }
}
