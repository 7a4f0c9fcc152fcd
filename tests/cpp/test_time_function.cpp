#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "linkwork/math/error.hpp"
#include "linkwork/model/time_function.hpp"

using namespace linkwork;

namespace {

/// Rate and acceleration against differences of the value.
void check_derivatives(const TimeFunction& f, double t) {
  const double h = 1e-3;
  const auto value = [&](double s) { return f.evaluate(t + s).value; };
  const double rate = (8 * (value(h) - value(-h)) - (value(2 * h) - value(-2 * h))) / (12 * h);
  const double acceleration =
      (16 * (value(h) + value(-h)) - (value(2 * h) + value(-2 * h)) - 30 * value(0)) / (12 * h * h);
  CAPTURE(t);
  CHECK(f.evaluate(t).rate == doctest::Approx(rate).epsilon(1e-9));
  CHECK(f.evaluate(t).acceleration == doctest::Approx(acceleration).epsilon(1e-7));
}

/// The C1 cubic through (0, 1), (1, 3), (3, -1) with slopes 0.5, -1, 2.
TimeFunctionPtr cubic_table() { return piecewise_polynomial({0, 1, 3}, {1, 0.5, 6, -4.5, 3, -1, -3, 1.25}); }

}  // namespace

TEST_CASE("a polynomial has its closed form") {
  const Signal<double> f = polynomial({1, -2, 3, 0.5})->evaluate(2.0);
  CHECK(f.value == 1 - 4 + 12 + 4);
  CHECK(f.rate == -2 + 12 + 6);
  CHECK(f.acceleration == 6 + 6);
}

TEST_CASE("the derivatives of a polynomial are those of its value") {
  for (const double t : {-1.5, 0.2, 2.0}) check_derivatives(*polynomial({1, -2, 3, 0.5, -0.7}), t);
}

TEST_CASE("the derivatives of a harmonic are those of its value") {
  for (const double t : {-1.5, 0.2, 2.0}) check_derivatives(*harmonic(0.7, 3.0, 0.4, 2.0), t);
}

TEST_CASE("a harmonic is offset + amplitude sin(frequency t + phase)") {
  CHECK(harmonic(0.7, 3.0, 0.4, 2.0)->evaluate(1.1).value == doctest::Approx(2.0 + 0.7 * std::sin(3.7)).epsilon(1e-15));
}

TEST_CASE("the derivatives of a piecewise polynomial are those of its value") {
  for (const double t : {0.3, 0.9, 1.5, 2.7}) check_derivatives(*cubic_table(), t);
}

TEST_CASE("a piecewise polynomial meets its points and is as smooth as its coefficients") {
  const auto f = cubic_table();
  CHECK(f->evaluate(0.0).value == 1.0);
  CHECK(f->evaluate(1.0).value == 3.0);
  CHECK(f->evaluate(3.0).value == doctest::Approx(-1.0).epsilon(1e-14));
  CHECK(f->evaluate(1.0 - 1e-12).value == doctest::Approx(f->evaluate(1.0).value).epsilon(1e-11));
  CHECK(f->evaluate(1.0 - 1e-12).rate == doctest::Approx(f->evaluate(1.0).rate).epsilon(1e-10));
}

TEST_CASE("a piecewise polynomial refuses a time outside of its table, which the error names") {
  for (const double t : {-0.5, 3.25, std::nan("")}) {
    CAPTURE(t);
    try {
      cubic_table()->evaluate(t);
      FAIL("no error");
    } catch (const OptionError& error) {
      CHECK(error.code() == "time_function_range");
      CHECK(std::string(error.what()).find("t = " + std::to_string(t)) != std::string::npos);
    }
  }
}

TEST_CASE("a piecewise polynomial allows the roundoff of a last step") {
  CHECK(cubic_table()->evaluate(3.0 + 1e-10).value == doctest::Approx(-1.0).epsilon(1e-8));
}

TEST_CASE("a piecewise polynomial refuses breaks that do not increase and coefficients that do not fit") {
  CHECK_THROWS_AS(piecewise_polynomial({0, 1, 1}, {1, 2}), ModelError);
  CHECK_THROWS_AS(piecewise_polynomial({0}, {1}), ModelError);
  CHECK_THROWS_AS(piecewise_polynomial({0, 1, 2}, {1, 2, 3}), ModelError);
  CHECK_THROWS_AS(piecewise_polynomial({0, 1}, {}), ModelError);
}

TEST_CASE("a callback without derivatives says so and gives NaN for them") {
  const auto f = callback([](double t) { return t * t; });
  CHECK_FALSE(f->has_derivatives());
  CHECK(f->evaluate(3.0).value == 9.0);
  CHECK(std::isnan(f->evaluate(3.0).rate));
  CHECK(std::isnan(f->evaluate(3.0).acceleration));
}

TEST_CASE("a callback has derivatives only where both are given") {
  const auto f = [](double t) { return std::exp(2 * t); };
  const auto df = [](double t) { return 2 * std::exp(2 * t); };
  const auto ddf = [](double t) { return 4 * std::exp(2 * t); };
  CHECK_FALSE(callback(f, df)->has_derivatives());
  CHECK(callback(f, df, ddf)->has_derivatives());
  check_derivatives(*callback(f, df, ddf), 0.3);
}

TEST_CASE("the rate of an integral is the function, and it begins at 0 or at the end of the table next to that") {
  const auto table = cubic_table();
  for (const TimeFunctionPtr& f :
       {polynomial({1, -2, 3, 0.5}), harmonic(0.7, 3.0, 0.4, 2.0), harmonic(0.7, 0.0, 0.4, 2.0), table,
        with_breaks(table, {0.5}), sum({table, harmonic(0.7, 3.0, 0.4, 0.0)}), sum({})}) {
    const TimeFunctionPtr integral = f->integral();
    REQUIRE(integral);
    CHECK(integral->evaluate(0.0).value == doctest::Approx(0.0));
    for (const double t : {0.3, 0.9, 1.5, 2.7}) {
      check_derivatives(*integral, t);
      CHECK(integral->evaluate(t).rate == doctest::Approx(f->evaluate(t).value).epsilon(1e-14));
    }
  }
  for (const double start : {1.5, -3.5, -1.2}) {
    const auto integral = piecewise_polynomial({start, start + 1, start + 2}, {1, 0.5, -1, 2})->integral();
    CHECK(integral->evaluate(std::clamp(0.0, start, start + 2)).value == doctest::Approx(0.0));
    CHECK(integral->evaluate(start + 2).value - integral->evaluate(start).value == doctest::Approx(1.25));
  }
}

TEST_CASE("an integral has its digits near 0 however far its table reaches") {
  const double far = 1e6, below = 60.0, above = 90.0;
  const auto integral = piecewise_polynomial({-far, 0, far}, {-far * below, below, 0, above})->integral();
  for (const double x : {-0.1, -1e-4, 1e-4, 0.1})
    CHECK(integral->evaluate(x).value == doctest::Approx((x < 0 ? below : above) / 2 * x * x).epsilon(1e-14));
}

TEST_CASE("an integral of a harmonic has its digits near 0") {
  const auto integral = harmonic(30.0, 2.0, 0.0, 0.0)->integral();
  for (const double x : {1e-8, -1e-6, 1e-3})
    CHECK(integral->evaluate(x).value == doctest::Approx(30.0 * std::sin(x) * std::sin(x)).epsilon(1e-15));
}

TEST_CASE("a function of which one term has no known integral has none") {
  const auto unknown = callback([](double t) { return t * t; });
  CHECK_FALSE(unknown->integral());
  CHECK_FALSE(sum({polynomial({1}), unknown})->integral());
}

TEST_CASE("neither a change nor a second derivative is beyond its bound, and most of these are near") {
  struct Case {
    TimeFunctionPtr function;
    double looseness;  ///< of the bound
  };
  const auto wave = [](double t) { return std::sin(40.0 * t); };
  const auto rate = [](double t) { return 40.0 * std::cos(40.0 * t); };
  const auto acceleration = [](double t) { return -1600.0 * std::sin(40.0 * t); };
  const Case cases[] = {{polynomial({1, -2, 3, 0.5, -0.7}), 1.5},
                        {harmonic(-0.7, 30.0, 0.4, 2.0), 1.1},
                        {harmonic(-0.7, 30.0, 0.4, 2.0)->integral(), 1.1},
                        {cubic_table(), 1.5},
                        {cycloidal(-2.0, 0.5, 1.5), 2.6},
                        {sum({harmonic(0.3, 20.0, 0.0, 0.0), polynomial({1, 0, 5})}), 1.1},
                        {with_breaks(cubic_table(), {0.7}), 1.5},
                        {callback(wave, rate, acceleration), 2.2}};
  constexpr int looks = 2000;
  for (std::size_t k = 0; k < std::size(cases); ++k) {
    CAPTURE(k);
    for (const double from : {0.0, 0.3, 1.1, 2.3}) {
      double largest = 0.0;
      for (int look = 0; look < looks; ++look) {
        const double t = from + 0.6 * look / looks, h = 1e-4;
        const auto value = [&](double s) { return cases[k].function->evaluate(t + s).value; };
        if (t - h > 0.0 && t + h < 3.0)
          largest = std::max(largest, std::abs(value(h) - 2 * value(0) + value(-h)) / (h * h));
      }
      const auto apart = [&](double s) {
        return cases[k].function->evaluate(s).value - cases[k].function->evaluate(from).value;
      };
      CHECK(std::abs(apart(from + 0.37)) <= cases[k].function->amplitude());
      const double bound = cases[k].function->largest_acceleration(from, from + 0.6);
      CHECK(bound >= 0.999 * largest);
      CHECK(bound <= cases[k].looseness * largest + 1e-6);
    }
  }
}
