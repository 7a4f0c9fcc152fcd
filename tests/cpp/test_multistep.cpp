#include "integrators.hpp"

using namespace support;

TEST_CASE("Adams methods evaluate once and Adams-Bashforth-Moulton twice a step, however long the run") {
  const int steps = 20000, starter_stages = 3 * 3;
  for (const auto& [method, per_step] : {std::pair{ab4(), 1}, std::pair{abm4(), 2}}) {
    INFO(method.name);
    Dynamics dynamics(free_body(), {});
    Simulation simulation(dynamics, make_multistep(method), {steps * 1e-3, 1e-3, steps});
    simulation.advance(1 << 30, 1e9);
    CHECK(dynamics.statistics().evaluations <= per_step * steps + 1 + starter_stages);
  }
}

TEST_CASE("multistep coefficients that are inconsistent are refused") {
  const auto code = [](const MultistepCoefficients& method) { return error_code([&] { make_multistep(method); }); };
  CHECK(code(abm4()) == "none");
  CHECK(code(multistep("none", 1, {}, {})) == "multistep");
  CHECK(code(multistep("predictor", 2, {1.5, -0.6}, {})) == "multistep");
  CHECK(code(multistep("corrector", 2, {1.5, -0.5}, {0.5, 0.6})) == "multistep");
  CHECK(code(multistep("reach", 2, {1.0}, {0.5, 0.25, 0.25})) == "multistep");
}

namespace {

/// A ball that a force sum c_k t^k pushes along x.
Model pushed(const std::vector<double>& coefficients) {
  Model model(Vec3<double>::Zero());
  Body ball;
  ball.mass = 2.0;
  model.add_body("ball", ball);
  std::vector<Parameter> parameters(6);
  parameters[0].signal = model.add_signal(polynomial(coefficients));
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("applied", "push", ground, 0, {Vec3<double>::Zero(), Vec3<double>::Zero(), I, I}, parameters);
  return model;
}

}  // namespace

TEST_CASE("a method of order k integrates polynomials of degree k - 1 exactly, and not those of degree k") {
  const double t = 1.0;
  for (const MultistepCoefficients& method : {ab2(), ab4(), abm4()}) {
    INFO(method.name);
    std::vector<double> coefficients(method.order, 1.0);
    const auto error = [&] {
      double exact = 0.0;
      for (std::size_t k = 0; k < coefficients.size(); ++k) exact += 0.5 * coefficients[k] / double(k + 1);
      return std::abs(last(run(pushed(coefficients), make_multistep(method), {t, 0.1, 10}).v, 6)[0] - exact);
    };
    CHECK(error() < 1e-14);
    coefficients.push_back(1.0);
    CHECK(error() > 1e-6);
  }
}

TEST_CASE("a step of another size begins anew with the starter") {
  Dynamics dynamics(spherical_pendulum(), unstabilized());
  const auto adams = make_multistep(ab4()), starter = make_runge_kutta(rk4());
  for (const auto* method : {&adams, &starter}) (*method)->start(dynamics.y_size());
  VectorXd y = dynamics.initial_y();
  double t = 0.0;
  const auto step = [&](Integrator& method, double h, VectorXd from) {
    dynamics.evaluate(t, from);
    method.step(dynamics, {t, h}, from);
    return from;
  };
  for (int n = 0; n < 6; ++n, t += 0.01) y = step(*adams, 0.01, y);
  CHECK((step(*starter, 0.01, y) - step(*adams, 0.01, y)).norm() > 1e-12);
  CHECK((step(*starter, 0.007, y) - step(*adams, 0.007, y)).norm() == 0.0);
}
