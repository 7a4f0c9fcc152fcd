#include "linkwork/integration/history_watch.hpp"

#include <cstring>

#include "integrators.hpp"

using namespace support;

namespace {

constexpr double spin = 4.0;  // rad/s

/// A wheel that turns about z against a rotational spring, whose angle is continued over full turns.
Model wheel() {
  Model model(Vec3<double>::Zero());
  Body body;
  body.omega = {0, 0, spin};
  model.add_body("wheel", body);
  const Vec3<double> O = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("rotational_spring_damper", "spring", ground, 0, {O, O, I, I},
                  {{0.1, -1}, {0.0, -1}, {0.0, -1}, {0.0, -1}});
  return model;
}

/// A ball at height `above` a floor that touches it at 0, falling at 1 m/s without weight.
Model falling(double above) {
  Model model(Vec3<double>::Zero());
  Body body;
  body.position = {0, 0, above};
  body.velocity = {0, 0, -1};
  model.add_body("ball", body);
  const Vec3<double> O = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  Random random(1);
  const KindInfo& info = force_kinds()[force_kind_index("translational_stop")].info;
  std::vector<Parameter> parameters;
  for (const ParameterInfo& it : info.parameters) {
    const std::string& name = it.name;
    parameters.push_back({name == "lower" ? 0.0 : name == "upper" ? 100.0 : it.value.usual.value_or(1e3), -1});
  }
  model.add_force("translational_stop", "floor", ground, 0, {O, O, I, I}, parameters);
  return model;
}

}  // namespace

TEST_CASE("an angle turns in a step by its rate times the step, and half a turn is too far") {
  Dynamics dynamics(wheel(), {});
  TurnGuard guard(dynamics);
  dynamics.evaluate(0.0, dynamics.initial_y());
  dynamics.advance_history();
  guard.accept();
  CHECK(guard.largest(0.1) == doctest::Approx(0.1 * spin).epsilon(1e-14));
  CHECK(!TurnGuard::too_far(guard.largest(0.5)));
  CHECK(TurnGuard::too_far(guard.largest(0.7)));
  CHECK(TurnGuard::too_far(NAN));
}

TEST_CASE("a run whose step turns an angle by half a turn is refused, with the element and a step that does") {
  try {
    run(wheel(), make_runge_kutta(rk4()), {10.0, 0.7, 1});
    FAIL("no error");
  } catch (const StepSizeError& error) {
    CHECK(error.details.forces == std::vector<std::string>{"spring"});
    CHECK(std::strstr(error.what(), "use a step of 0.3 s or less") != nullptr);  // 0.5 * 2.5 rad / 4 rad/s
  }
}

TEST_CASE("a stop that is met in a step is found where its distance is zero") {
  Dynamics dynamics(falling(0.03), {});
  REQUIRE(!dynamics.system().switches().empty());
  PairStepper stepper(bs32());
  stepper.start(dynamics.y_size());
  const VectorXd y = dynamics.initial_y();
  const double h = 0.1;
  dynamics.evaluate(0.0, y);
  dynamics.take_sides(0.0);
  stepper.take(dynamics, {0.0, 0.2 * h}, y);
  SwitchWatch watch(dynamics, 1e-12);
  CHECK(!watch.first(stepper, 0.0, 0.2 * h, {}));
  dynamics.evaluate(0.0, y);
  stepper.take(dynamics, {0.0, 0.301 * h}, y);
  const auto found = watch.first(stepper, 0.0, 0.301 * h, {});
  REQUIRE(found.has_value());
  CHECK(found->theta == doctest::Approx(0.03 / 0.0301).epsilon(1e-3));
  CHECK(found->until == 1.0);
}

TEST_CASE("what touches by no more than is as good as zero keeps its side") {
  Dynamics dynamics(falling(1e-13), {});
  const auto sides_at = [&](double above) {
    VectorXd y = dynamics.initial_y();
    y[2] = above;
    dynamics.evaluate(0.0, y);
    dynamics.take_sides(1e-12);
    return dynamics.sides();
  };
  const auto outside = sides_at(1e-3), inside = sides_at(-1e-3);
  CHECK(outside != inside);
  for (const double least : {1e-13, -1e-13, 0.0}) {
    CHECK(sides_at(least) == inside);
    CHECK(sides_at(1e-3) == outside);
    CHECK(sides_at(least) == outside);
    CHECK(sides_at(-1e-3) == inside);
  }
}
