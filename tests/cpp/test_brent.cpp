#include "linkwork/math/brent.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace linkwork;

TEST_CASE("Brent's method finds zeros to its tolerance in few evaluations") {
  struct Problem {
    double (*f)(double);
    double a, b, zero;
    int most;
  };
  const Problem problems[] = {
      {[](double x) { return x - 0.3; }, 0, 1, 0.3, 4},
      {[](double x) { return std::cos(x) - x; }, 0, 1, 0.73908513321516064, 10},
      {[](double x) { return std::exp(x) - 2; }, -5, 10, std::log(2.0), 20},
      {[](double x) { return std::pow(x - 1, 3); }, 0, 3, 1, 150},
      {[](double x) { return x < 0.7 ? -1.0 : 1.0; }, 0, 1, 0.7, 60},
      {[](double x) { return 1e-300 * (x * x - 2); }, 0, 2, std::sqrt(2.0), 15},
  };
  for (const Problem& problem : problems) {
    CAPTURE(problem.zero);
    int evaluations = 0;
    const auto f = [&](double x) { return evaluations += 1, problem.f(x); };
    const double zero = brent(f, problem.a, problem.f(problem.a), problem.b, problem.f(problem.b), 1e-13);
    CHECK(std::abs(zero - problem.zero) < (problem.most > 100 ? 1e-4 : 2e-13));
    CHECK(evaluations <= problem.most);
  }
}

TEST_CASE("a zero at an end of the bracket is found") {
  const auto f = [](double x) { return x; };
  CHECK(brent(f, 0.0, 0.0, 1.0, 1.0, 1e-12) == doctest::Approx(0.0));
  CHECK(brent(f, -1.0, -1.0, 0.0, 0.0, 1e-12) == 0.0);
}
