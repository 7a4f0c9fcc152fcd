#include "linkwork/integration/log_smoothness.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// What is asked of a body that moves along x so, by what x and v are at each of so many times up to 1 s.
struct Asked {
  Model model = free_body();
  System system{model};
  StateLog log{1, 0};
  MovingAxes axes;
  VectorXd lengths = VectorXd::Ones(1), speeds = VectorXd::Ones(1);

  template <class Motion>
  Asked(int states, Motion motion) {
    for (int k = 0; k <= states; ++k) {
      const double t = 1.0 * k / states;
      VectorXd y = VectorXd::Zero(14);
      y[3] = 1.0;
      std::tie(y[0], y[7]) = motion(t);
      log.add(t, y, VectorXd());
    }
  }
  LogSmoothness smoothness() const { return {system, log, axes, lengths, speeds}; }
};

std::pair<double, double> falls(double t) { return {t - 0.5 * t * t, 1.0 - t}; }

/// A stop that turns the velocity around, for so long about a time.
std::pair<double, double> bounces(double t, double at, double lasts, double change) {
  const double in = std::clamp(t - at, 0.0, lasts), after = std::max(t - at - lasts, 0.0);
  return {t - change * (0.5 * in * in / lasts + after), 1.0 - change * in / lasts};
}

}  // namespace

TEST_CASE("what falls is smooth, from any state to any other") {
  const Asked it(100, falls);
  for (const std::size_t end : {1, 2, 3, 10, 100}) {
    CHECK(it.smoothness().halfway(0, end));
    CHECK(it.smoothness().everywhere(0, end));
  }
}

TEST_CASE("what happens halfway is seen there") {
  const Asked it(100, [](double t) { return bounces(t, 0.45, 0.1, 2.0); });
  CHECK_FALSE(it.smoothness().halfway(0, 80));
  CHECK(it.smoothness().halfway(0, 40));
}

TEST_CASE("a small stop is seen wherever it is, in few states or in many") {
  for (const int states : {40, 400, 4000})
    for (const double at : {0.05, 0.3, 0.5, 0.7, 0.85}) {
      CAPTURE(states);
      CAPTURE(at);
      const Asked it(states, [&](double t) { return bounces(t, at, 0.1, 0.02); });
      CHECK_FALSE(it.smoothness().everywhere(0, static_cast<std::size_t>(states)));
      CHECK(it.smoothness().everywhere(0, static_cast<std::size_t>(at * states)));
    }
}

TEST_CASE("a vibration is smooth in a part of its period, not in all of it") {
  const Asked it(1000, [](double t) { return std::pair(std::sin(20.0 * t) / 20.0, std::cos(20.0 * t)); });
  CHECK(it.smoothness().everywhere(0, 60));
  CHECK(it.smoothness().halfway(0, 30));
  CHECK_FALSE(it.smoothness().everywhere(0, 400));
}

TEST_CASE("between neighbors there is nothing to see") {
  const Asked it(10, [](double t) { return std::pair(t > 0.5 ? 1.0 : 0.0, t > 0.5 ? -1.0 : 1.0); });
  CHECK(it.smoothness().everywhere(5, 6));
  CHECK(it.smoothness().halfway(5, 6));
}
