#include "linkwork/integration/integrator.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("observed order on a free asymmetric body") {
  for (const Method& method : all_methods()) {
    INFO(method.name);
    CHECK(std::abs(observed_order(free_body(), method, 2.0, method.order > 2 ? 100 : 800) - method.order) < 0.2);
  }
}

TEST_CASE("observed order on a spherical pendulum with sampled stabilization") {
  for (const Method& method : all_methods()) {
    INFO(method.name);
    CHECK(std::abs(observed_order(spherical_pendulum(), method, 1.0, method.order > 2 ? 100 : 800) - method.order) <
          0.2);
  }
}

TEST_CASE("sampled stabilization annuls the violation of linear constraints in two steps of a one-step method") {
  for (const Method& method : one_step_methods) {
    INFO(method.name);
    const Frames frames = run(displaced_slider(), method.make(), {0.03, 0.01, 1});
    CHECK(frames.violation[0] == doctest::Approx(2e-2).epsilon(1e-14));
    CHECK(frames.violation[1] == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(frames.violation[6] < 1e-15);
    CHECK(frames.violation[7] < 1e-13);
  }
}

TEST_CASE("sampled stabilization reduces the violation of a pendulum to second order in two steps of RK4") {
  Model model;
  Body body = spherical_pendulum().bodies()[0];
  const Vec3<double> s = -body.position, shift(1e-4, 2e-4, -1e-4);
  body.position += shift;
  model.add_body("bob", body);
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_joint("spherical", "hook", ground, 0, {Vec3<double>::Zero(), s, I, I});
  const Frames frames = run(model, make_runge_kutta(rk4()), {2e-4, 1e-4, 1});
  CHECK(frames.violation[0] == doctest::Approx(2e-4));
  CHECK(frames.violation[6] < 10 * 2e-4 * 2e-4);
}

TEST_CASE("a multistep method annuls the violation of linear constraints") {
  for (const Method& method : all_methods()) {
    INFO(method.name);
    const Frames frames = run(displaced_slider(), method.make(), {0.2, 0.01, 20});
    CHECK(frames.violation[3] < 1e-13);
    CHECK(frames.violation[4] < 1e-11);
  }
}

TEST_CASE("every method integrates over a shortened last step with its length") {
  for (const Method& method : all_methods()) {
    INFO(method.name);
    Model model(Vec3<double>::Zero());
    Body body;
    body.velocity = {1.0, 0.0, 0.0};
    model.add_body("stone", body);
    CHECK(last(run(model, method.make(), {1.05, 0.1, 100}).q, 7)[0] == doctest::Approx(1.05).epsilon(1e-14));
  }
}
