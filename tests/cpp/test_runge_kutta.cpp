#include "linkwork/integration/runge_kutta.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a free asymmetric body keeps its energy and its angular momentum in space") {
  const Model model = free_body();
  const Frames frames = run(model, make_runge_kutta(rk4()), {5.0, 1e-3, 5000});
  const auto momentum = [&](std::size_t frame) {
    const Vec4<double> p(frames.q.data() + 7 * frame + 3);
    const Vec3<double> omega(frames.v.data() + 6 * frame + 3);
    return Vec3<double>(rotation_matrix<double>(p) * model.bodies()[0].inertia * omega);
  };
  CHECK((momentum(1) - momentum(0)).norm() < 1e-11);
  CHECK(std::abs(frames.kinetic[1] - frames.kinetic[0]) < 1e-11);
}

TEST_CASE("omega of a free symmetric body turns about its axis at (J_3 - J_1) / J_1 omega_3") {
  Model model(Vec3<double>::Zero());
  Body body;
  body.inertia = Vec3<double>(2.0, 2.0, 3.0).asDiagonal();
  body.omega = {1.0, 0.0, 4.0};
  model.add_body("top", body);
  const double t = 3.0, angle = (3.0 - 2.0) / 2.0 * 4.0 * t;
  const Vec3<double> omega = last(run(model, make_runge_kutta(rk4()), {t, 1e-3, 1000}).v, 3);
  CHECK((omega - Vec3<double>(std::cos(angle), std::sin(angle), 4.0)).norm() < 1e-10);
}

TEST_CASE("a driven and damped mechanism keeps energy less work") {
  Model model = spherical_pendulum();
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> none = Vec3<double>::Zero();
  Body second;
  second.position = model.bodies()[0].position + Vec3<double>::UnitX();
  second.velocity = model.bodies()[0].velocity + 0.3 * Vec3<double>::UnitX();
  model.add_body("second", second);
  const int length = model.add_signal(harmonic(0.1, 3.0, 0.0, 1.0));  // 1 m, growing with 0.3 m/s
  model.add_joint("distance", "telescope", 0, 1, {none, none, I, I}, {{0.0, length}});
  model.add_force("spring_damper", "damper", ground, 1, {none, none, I, I},
                  {{5.0, -1}, {0.3, -1}, {1.0, -1}, {0.0, -1}});
  const Frames frames = run(model, make_runge_kutta(rk4()), {2.0, 1e-3, 2000});
  const double error =
      frames.kinetic[1] + frames.potential[1] - frames.work[1] - frames.kinetic[0] - frames.potential[0];
  CHECK(std::abs(frames.work[1]) > 0.1);
  CHECK(std::abs(error) < 1e-9);
}

TEST_CASE("a tableau that is implicit, inconsistent or misshapen is refused") {
  const auto code = [](const ButcherTableau& method) { return error_code([&] { make_runge_kutta(method); }); };
  CHECK(code(rk4()) == "none");
  CHECK(code(tableau("implicit", 1, {{1}}, {1}, {0})) == "tableau");
  CHECK(code(tableau("weights", 2, {{}, {1}}, {0.5, 0.6}, {0, 1})) == "tableau");
  CHECK(code(tableau("first stage", 2, {{}, {1}}, {0.5, 0.5}, {0.5, 1})) == "tableau");
  CHECK(code(tableau("not finite", 2, {{}, {NAN}}, {0.5, 0.5}, {0, 1})) == "tableau");
  CHECK(code({"empty", 1, {}, {}, {}}) == "tableau");
  ButcherTableau misshapen = rk4();
  misshapen.c.conservativeResize(3);
  CHECK(code(misshapen) == "tableau");
}

TEST_CASE("the stages of a method are f(t + c_i h, y + h sum_j a_ij k_j)") {
  Dynamics dynamics(spherical_pendulum(), unstabilized());
  const VectorXd y = dynamics.initial_y();
  const double h = 0.1;
  VectorXd stage(y.size()), k_1(y.size()), k_2(y.size());
  MatrixXd k(y.size(), 2);
  dynamics.evaluate(0.0, y);
  dynamics.rates(k_1);
  dynamics.evaluate(0.0, y);
  evaluate_stages(heun(), dynamics, {0.0, h}, y, k, stage);
  dynamics.evaluate(h, y + h * k_1);
  dynamics.rates(k_2);
  CHECK((k.col(0) - k_1).norm() == 0.0);
  CHECK((k.col(1) - k_2).norm() <= 1e-14 * k_2.norm());
}
