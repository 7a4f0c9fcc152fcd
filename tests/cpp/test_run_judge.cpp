#include "linkwork/integration/run_judge.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// Accelerations of the model by rk4 with step h, whose largest difference in a second take is that of the error.
double largest_error(const Model& model, double h, std::vector<double> breaks) {
  Dynamics dynamics(model, Options());
  Simulation run(dynamics, make_runge_kutta(rk4()), {20.0 * h, h});
  run.expect_breaks(std::move(breaks));
  run.advance(1000000, 1e9);
  double largest = 0.0;
  for (const StepError& step : judge_run(run.sampling(), dynamics, in_parts(make_runge_kutta(rk4()))).steps)
    largest = std::max(largest, step.of_part[0].end.velocity);
  return largest;
}

}  // namespace

TEST_CASE(
    "a force in step with the parts of a step is seen, and a pulse between its stages where its times are known") {
  const double h = 0.04, two_pi = 6.283185307179586;
  const auto pushed = [](TimeFunctionPtr force) {
    Model model;
    Body body;
    body.mass = 1.0;
    body.inertia = 0.1 * Mat3<double>::Identity();
    model.add_body("ball", body);
    Attachment<double> at;
    at.s_i.setZero();
    at.s_j.setZero();
    at.C_i = at.C_j = Mat3<double>::Identity();
    std::vector<Parameter> parameters(6);
    parameters[0].signal = model.add_signal(std::move(force));
    model.add_force("applied", "push", ground, 0, at, parameters);
    return model;
  };
  for (const int periods : {1, 2, 4, 8, 12})
    CHECK(largest_error(pushed(harmonic(10.0, two_pi * periods / h, 0.25 * two_pi, 0.0)), h, {}) > 1e-2);
  const auto pulse = [](double t) { return t >= 0.3701 && t < 0.3711 ? 50.0 : 0.0; };
  const Model model = pushed(callback(pulse));
  CHECK(largest_error(model, h, {}) < 1e-12);
  CHECK(largest_error(model, h, {0.3701, 0.3711}) == doctest::Approx(0.05).epsilon(1e-3));
}

TEST_CASE("every kept step of a run is judged, and belongs to a part of it") {
  Dynamics dynamics(pendulum(), Options());
  Simulation run(dynamics, make_runge_kutta(rk4()), {2.0, 0.01});
  run.advance(1 << 30, 1e9);
  const RunErrors errors = judge_run(run.sampling(), dynamics, in_parts(make_runge_kutta(rk4())));
  REQUIRE(errors.steps.size() > 10);
  REQUIRE(errors.part_of.size() == errors.steps.size());
  CHECK(std::is_sorted(errors.part_of.begin(), errors.part_of.end()));
  REQUIRE(errors.connected_parts.size() == 1);
  CHECK(errors.connected_parts[0].resolved >= 1.0);
  CHECK(errors.connected_parts[0].resolved < 1.1);  // a smooth motion in short steps: Richardson has it right
  double steps = 0.0;
  for (std::size_t k = 0; k < errors.steps.size(); ++k) {
    const RunPart& part = errors.parts[errors.part_of[k]];
    CHECK(errors.steps[k].t >= part.t);
    CHECK(errors.steps[k].t < part.t + part.seconds);
    CHECK(errors.steps[k].of_part[0].end.position < 1e-8);
  }
  for (const RunPart& part : errors.parts) steps += double(part.steps);
  CHECK(steps == 200.0);
}

TEST_CASE("bodies that fly along make no motion larger, and a body that only flies rests") {
  const auto flying = [](double speed, bool vibrates) {
    Model model(Vec3<double>::Zero());
    for (const double z : {0.0, 1.0}) {
      Body body;
      body.mass = 1.0;
      body.inertia = 0.1 * Mat3<double>::Identity();
      body.position = {0.0, 0.0, z};
      body.velocity = {speed, 0.0, vibrates && z > 0.0 ? 0.1 : 0.0};
      model.add_body(z > 0.0 ? "upper" : "lower", body);
    }
    Attachment<double> at;
    at.s_i.setZero();
    at.s_j.setZero();
    at.C_i = at.C_j = Mat3<double>::Identity();
    model.add_force("spring_damper", "spring", 0, 1, at, {{100.0, -1}, {0.0, -1}, {1.0, -1}, {0.0, -1}});
    Dynamics dynamics(model, Options());
    Simulation run(dynamics, make_runge_kutta(rk4()), {2.0, 0.01});
    run.advance(1 << 30, 1e9);
    return judge_run(run.sampling(), dynamics, in_parts(make_runge_kutta(rk4())));
  };
  const RunErrors slow = flying(0.0, true), fast = flying(7600.0, true);
  REQUIRE(slow.steps.size() == fast.steps.size());
  CHECK(fast.connected_parts[0].length == doctest::Approx(slow.connected_parts[0].length).epsilon(1e-6));
  for (std::size_t k = 0; k < slow.steps.size(); ++k)
    CHECK(fast.steps[k].of_part[0].speed == doctest::Approx(slow.steps[k].of_part[0].speed).epsilon(1e-6));
  CHECK(fast.kinetic_share < 1e-9);
  CHECK(!fast.connected_parts[0].rest);
  CHECK(flying(7600.0, false).connected_parts[0].rest);
}

TEST_CASE("the share of a verdict that is done grows from none to all but its last step") {
  Dynamics dynamics(pendulum(), Options());
  Simulation run(dynamics, make_runge_kutta(rk4()), {2.0, 0.01});
  run.advance(1 << 30, 1e9);
  std::vector<double> shares;
  const auto report = [&](double share) { shares.push_back(share); };
  const RunErrors errors = judge_run(run.sampling(), dynamics, in_parts(make_runge_kutta(rk4())), report);
  REQUIRE(shares.size() == errors.steps.size() + 3);
  CHECK(shares.front() == 0.0);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  const double parts = 2.0 * double(errors.steps.size()) + 3.0 * 8.0;
  CHECK(shares.back() == doctest::Approx(1.0 - 8.0 / parts));
}
