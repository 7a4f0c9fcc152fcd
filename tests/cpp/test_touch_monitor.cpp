#include "linkwork/integration/touch_monitor.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// Of ten steps of 0.3 m as if nothing were in the way.
std::vector<PassedTouch> passed(double beside) {
  Dynamics dynamics(two_balls(100.0, {1, beside, 0}), {});
  TouchMonitor monitor(dynamics);
  VectorXd y = dynamics.initial_y(), y_new = y;
  dynamics.evaluate(0.0, y);
  monitor.restart(dynamics.evaluation().switches);
  for (int step = 0; step < 10; ++step) {
    y_new[0] = y[0] + 0.3;
    dynamics.evaluate(3e-3 * (step + 1), y_new);
    monitor.pass(3e-3 * step, 3e-3, y, y_new, dynamics.evaluation().switches);
    y = y_new;
  }
  return monitor.passed();
}

}  // namespace

TEST_CASE("a step in which a ball goes through another is told once, with its time and speed") {
  const auto found = passed(0.005);
  REQUIRE(found.size() == 1);
  CHECK(found[0].t == doctest::Approx(9e-3));  // from 0.9 m
  CHECK(found[0].until == doctest::Approx(12e-3));
  CHECK(found[0].steps == 1);
  CHECK(found[0].speed == doctest::Approx(100.0).epsilon(1e-2));
  CHECK(found[0].change > 0.0);
}

TEST_CASE("one in which it goes by is not") {
  CHECK(passed(0.0201).empty());
  CHECK(passed(1.0).empty());
}
