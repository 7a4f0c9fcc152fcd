#include "linkwork/integration/violation_monitor.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// A ball on a rod of 1 m, off by so much, evaluated.
struct Ball {
  Dynamics dynamics;
  VectorXd y;

  explicit Ball(const std::array<double, 3>& limits) : dynamics(model(), options(limits)), y(dynamics.initial_y()) {}
  void evaluate(double off, double speed) {
    y[0] = 1.0 + off;
    y[7] = speed;
    dynamics.evaluate(0.0, y);
  }

  static Model model() {
    Model model;
    model.add_body("ball", body_at({1, 0, 0}));
    const Mat3<double> I = Mat3<double>::Identity();
    const Vec3<double> O = Vec3<double>::Zero();
    model.add_joint("distance", "rod", ground, 0, {O, O, I, I}, {{1.0, -1}});
    return model;
  }
  static Options options(const std::array<double, 3>& limits) {
    Options options;
    options.violation_limit = limits;
    return options;
  }
};

constexpr double none = INFINITY;

}  // namespace

TEST_CASE("an excess lasts from where the limit is passed to where it is met again, and counts once") {
  Ball ball({1e-3, none, none});
  ViolationMonitor monitor(ball.dynamics);
  double t = 0.0;
  std::vector<int> found;
  for (const double off : {0.0, 2e-3, 5e-3, 3e-3, 0.5e-3, -4e-3, 0.0}) {
    ball.evaluate(off, 0.0);
    found.push_back(monitor.exceeded(t));
    t += 0.1;
  }
  CHECK(found == std::vector<int>{0, 1, 1, 1, 0, 1, 0});
  REQUIRE(monitor.count() == 2);
  CHECK(monitor.excesses()[0].t == doctest::Approx(0.1));
  CHECK(monitor.excesses()[0].largest == doctest::Approx(5e-3).epsilon(1e-2));
  CHECK(monitor.excesses()[1].t == doctest::Approx(0.5));
  CHECK(monitor.excesses()[1].largest == doctest::Approx(4e-3).epsilon(1e-2));
}

TEST_CASE("levels are judged each by its own limit") {
  Ball ball({1e-3, 1e-2, none});
  ViolationMonitor monitor(ball.dynamics);
  ball.evaluate(0.0, 5e-2);
  CHECK(monitor.exceeded(0.0));
  REQUIRE(monitor.count() == 1);
  CHECK(monitor.excesses()[0].level == 1);
  CHECK(monitor.excesses()[0].largest == doctest::Approx(5e-2).epsilon(1e-6));
}

TEST_CASE("accelerations of the method itself violate nothing") {
  Ball ball({none, none, 1e-6});
  ViolationMonitor monitor(ball.dynamics);
  ball.evaluate(0.0, 0.0);
  CHECK(!monitor.exceeded(0.0));
  CHECK(monitor.count() == 0);
}

TEST_CASE("without a limit nothing is looked at") {
  Ball ball({none, none, none});
  ViolationMonitor monitor(ball.dynamics);
  ball.evaluate(10.0, 10.0);
  CHECK(!monitor.exceeded(0.0));
}
