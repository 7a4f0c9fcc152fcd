#include "linkwork/integration/singular_pose_search.hpp"

#include "integrators.hpp"
#include "mechanisms.hpp"

using namespace support;

TEST_CASE("the zero of a value that comes down like |t| is found in few guesses, also where it is curved") {
  for (const double zero : {0.12, 0.5, 0.77})
    for (const double curvature : {0.0, 0.1, 0.3}) {
      int guesses = 0;
      const auto value = [&](double t) {
        guesses += 1;
        return std::abs(t - zero) * (1.0 + curvature * t);
      };
      const SingularValueAt a{0.0, value(0.0)}, b{zero + 0.05, value(zero + 0.05)}, c{1.0, value(1.0)};
      guesses = 0;
      const SingularValueAt least = least_value(a, b, c, value);
      CHECK(std::abs(least.at - zero) < 1e-6);
      CHECK(vanishes(a, least, c));
      CHECK(guesses <= 12);
    }
}

TEST_CASE("a least that is no zero is none, and costs few guesses") {
  int guesses = 0;
  const auto value = [&](double t) {
    guesses += 1;
    return std::hypot(t - 0.4, 0.45);
  };
  const SingularValueAt a{0.0, value(0.0)}, b{0.5, value(0.5)}, c{1.0, value(1.0)};
  guesses = 0;
  CHECK(!vanishes(a, least_value(a, b, c, value), c));
  CHECK(guesses <= 6);
}

TEST_CASE("a pose that a motion passes is listed once, at its time") {
  const double rate = 1.0, passes = 0.3;  // the parallelogram comes into line at 0.3 s
  Dynamics dynamics(parallelogram(-rate * passes, rate), {});
  SingularPoseSearch search(dynamics);
  VectorXd y_dot(dynamics.y_size());
  for (int n = 0; n <= 12; ++n) {
    const double t = 0.05 * n + 0.013;
    const Model there = parallelogram(rate * (t - passes), rate);
    VectorXd y(dynamics.y_size());
    y << there.initial_q(), there.initial_v(), 0.0;
    dynamics.evaluate(t, y);
    dynamics.rates(y_dot);  // from which the watch knows the usual pivots
    search.pass(t, search.value_at(t, y), y);
  }
  CHECK(search.last_listed() == doctest::Approx(passes).epsilon(1e-4));
  CHECK(dynamics.watch().singular_poses() == 1);
}

TEST_CASE("of zeros beside each other all are found, of one motion that turns round or of two that are independent") {
  for (const double other : {0.03, 0.1, 0.3, 0.62, 0.9, -0.05, -0.4, -0.8})
    for (const bool independent : {false, true}) {
      const auto value = [&](double t) {
        return independent ? std::min(std::abs(t), std::abs(t - other)) : std::abs(t * (t - other));
      };
      const SingularValueAt before{-1.0, value(-1.0)}, zero{0.0, 0.0}, after{1.1, value(1.1)};
      const std::vector<SingularValueAt> zeros = zeros_around(zero, before, after, value);
      REQUIRE(zeros.size() == 2);
      CHECK(zeros[0].at == doctest::Approx(std::min(0.0, other)).epsilon(1e-5));
      CHECK(zeros[1].at == doctest::Approx(std::max(0.0, other)).epsilon(1e-5));
    }
}
