#include "linkwork/integration/embedded_pair.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a pair with an estimate or an interpolant that cannot be is refused") {
  const auto code = [](auto alter) {
    EmbeddedPair pair = bs32();
    alter(pair);
    return error_code([&] { PairStepper stepper(pair); });
  };
  CHECK(code([](EmbeddedPair&) {}) == "none");
  CHECK(code([](EmbeddedPair& pair) { pair.error[0] += 0.1; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.error.conservativeResize(3); }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.error_order = 0; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.interpolant(0, 0) = 2.0; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.interpolant.conservativeResize(3, 3); }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.extra_c.setZero(1); }) == "tableau");
}

TEST_CASE("an interpolant begins in y, ends in the new state, and is of third order between") {
  Dynamics dynamics(spherical_pendulum(), unstabilized());
  PairStepper stepper(bs32());
  stepper.start(dynamics.y_size());
  const VectorXd y = dynamics.initial_y();
  const ErrorMeasure measure(dynamics.system(), {});
  VectorXd at(y.size());
  double last_estimate = 0.0, last_error = 0.0;
  for (const double h : {0.04, 0.02, 0.01}) {
    dynamics.evaluate(0.0, y);
    const double estimate = stepper.trial(dynamics, measure, {0.0, h}, y).value;
    stepper.interpolate(dynamics.system(), 0.0, at);
    CHECK((at - y).norm() < 1e-15);
    stepper.interpolate(dynamics.system(), 1.0, at);
    CHECK((at - stepper.y_new()).norm() < 1e-14);
    stepper.interpolate(dynamics.system(), 0.5, at);
    const Frames exact = run(spherical_pendulum(), make_runge_kutta(rk4()), {0.5 * h, h / 64, 100}, unstabilized());
    const double error = (at.head<7>() - last(exact.q, 7)).norm();
    if (last_error > 0.0) {
      CHECK(std::log2(last_error / error) == doctest::Approx(4.0).epsilon(0.1));
      CHECK(std::log2(last_estimate / estimate) == doctest::Approx(3.0).epsilon(0.1));
    }
    last_estimate = estimate;
    last_error = error;
  }
}
