#include <doctest/doctest.h>

#include "linkwork/integration/simulation.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

ButcherTableau tableau(const std::string& name, int order, const std::vector<std::vector<double>>& A,
                       const std::vector<double>& b, const std::vector<double>& c) {
  const auto s = static_cast<Eigen::Index>(b.size());
  ButcherTableau out{name, order, MatrixXd::Zero(s, s), Eigen::Map<const VectorXd>(b.data(), s),
                     Eigen::Map<const VectorXd>(c.data(), s)};
  for (std::size_t row = 0; row < A.size(); ++row)
    for (std::size_t column = 0; column < A[row].size(); ++column)
      out.A(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = A[row][column];
  return out;
}

ButcherTableau euler() { return tableau("euler", 1, {}, {1}, {0}); }
ButcherTableau heun() { return tableau("heun", 2, {{}, {1}}, {0.5, 0.5}, {0, 1}); }
ButcherTableau rk4() {
  return tableau("rk4", 4, {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1 / 6., 1 / 3., 1 / 3., 1 / 6.}, {0, 0.5, 0.5, 1});
}

MultistepCoefficients multistep(const std::string& name, int order, std::vector<double> predictor,
                                std::vector<double> corrector) {
  const auto vector = [](const std::vector<double>& x) {
    return VectorXd(Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
  };
  return {name, order, vector(predictor), vector(corrector), rk4()};
}

MultistepCoefficients ab2() { return multistep("ab2", 2, {1.5, -0.5}, {}); }
MultistepCoefficients ab4() { return multistep("ab4", 4, {55 / 24., -59 / 24., 37 / 24., -9 / 24.}, {}); }
MultistepCoefficients abm4() {
  return multistep("abm4", 4, {55 / 24., -59 / 24., 37 / 24., -9 / 24.}, {9 / 24., 19 / 24., -5 / 24., 1 / 24.});
}

struct Method {
  std::string name;
  int order;
  std::unique_ptr<Integrator> (*make)();
};

const std::vector<Method> one_step_methods = {
    {"euler", 1, [] { return make_runge_kutta(euler()); }},
    {"heun", 2, [] { return make_runge_kutta(heun()); }},
    {"rk4", 4, [] { return make_runge_kutta(rk4()); }},
    {"semi-implicit euler", 1, [] { return make_semi_implicit_euler(); }},
};

std::vector<Method> all_methods() {
  std::vector<Method> all = one_step_methods;
  all.push_back({"ab2", 2, [] { return make_multistep(ab2()); }});
  all.push_back({"ab4", 4, [] { return make_multistep(ab4()); }});
  all.push_back({"abm4", 4, [] { return make_multistep(abm4()); }});
  return all;
}

/// An asymmetric body that nothing holds and no torque acts on.
Model free_body() {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = 2.0;
  body.inertia = Vec3<double>(1.0, 2.0, 2.5).asDiagonal();
  body.velocity = {0.3, -0.2, 0.1};
  body.omega = {1.0, 2.0, -0.5};
  model.add_body("brick", body);
  return model;
}

/// An asymmetric body on a ball joint at the origin, moving consistently.
Model spherical_pendulum() {
  Model model;
  Body body;
  body.mass = 2.0;
  body.inertia = Vec3<double>(0.10, 0.20, 0.25).asDiagonal();
  body.position = {0.8, 0.0, -0.3};
  body.omega = {0.5, -0.4, 1.5};
  body.velocity = body.omega.cross(body.position);
  model.add_body("bob", body);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> none = Vec3<double>::Zero();
  model.add_joint("spherical", "hook", ground, 0, place(model, ground, 0, none, none, I, I));
  return model;
}

Options unstabilized() {
  Options options;
  options.stabilization = "none";
  return options;
}

Frames run(const Model& model, std::unique_ptr<Integrator> integrator, const Schedule& schedule,
           const Options& options = {}) {
  Dynamics dynamics(model, options);
  Simulation simulation(dynamics, std::move(integrator), schedule);
  return simulation.advance(1 << 30, 1e9);
}

VectorXd last(const std::vector<double>& frames, Eigen::Index size) {
  return Eigen::Map<const VectorXd>(frames.data() + frames.size() - static_cast<std::size_t>(size), size);
}

/// (q, v, work) of a one-body model at the end.
VectorXd final_state(const Model& model, const Method& method, double t_end, int steps) {
  const Frames frames = run(model, method.make(), {t_end, t_end / steps, steps});
  VectorXd y(14);
  y << last(frames.q, 7), last(frames.v, 6), frames.work.back();
  return y;
}

/// From three runs, without a reference: log2 |y_h - y_h/2| / |y_h/2 - y_h/4|.
double observed_order(const Model& model, const Method& method, double t_end, int steps) {
  const VectorXd coarse = final_state(model, method, t_end, steps);
  const VectorXd middle = final_state(model, method, t_end, 2 * steps);
  const VectorXd fine = final_state(model, method, t_end, 4 * steps);
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

}  // namespace

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

TEST_CASE("a step of semi-implicit Euler is v' = v + h v_dot, q' = q + h N(q) v'") {
  const Model model = spherical_pendulum();
  const double h = 0.01;
  Dynamics dynamics(model, unstabilized());
  VectorXd y = dynamics.initial_y(), v_dot(6), lambda(3), q_dot(7);
  dynamics.evaluate(0.0, y);
  dynamics.accelerations(v_dot, lambda);
  const VectorXd v = y.segment<6>(7) + h * v_dot;
  dynamics.system().position_rates(y.head<7>(), v, q_dot);
  VectorXd q = y.head<7>() + h * q_dot;
  q.tail<4>().normalize();
  const Frames frames = run(model, make_semi_implicit_euler(), {h, h, 1}, unstabilized());
  CHECK((last(frames.v, 6) - v).norm() < 1e-15);
  CHECK((last(frames.q, 7) - q).norm() < 1e-15);
}

namespace {

/// A body that slides along the ground's z axis, begun off the axis and moving off it: linear constraints.
Model displaced_slider() {
  Model model;
  Body body;
  body.position = {1e-2, -2e-2, 0.3};
  body.velocity = {0.5, 0.2, -1.0};
  model.add_body("slider", body);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> none = Vec3<double>::Zero();
  model.add_joint("translational", "rail", ground, 0, {none, none, I, I});
  return model;
}

}  // namespace

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

TEST_CASE("step n begins at n h exactly, and a shortened last step ends at t_end") {
  const double h = 0.1, t_end = 1.05;
  const Frames frames = run(free_body(), make_runge_kutta(heun()), {t_end, h, 1});
  CHECK(frames.t.size() == 12);
  for (std::size_t n = 0; n < 11; ++n) CHECK(frames.t[n] == static_cast<double>(n) * h);
  CHECK(frames.t.back() == t_end);
}

TEST_CASE("roundoff of t_end / step does not make another step") {
  const Frames frames = run(free_body(), make_runge_kutta(euler()), {0.3, 0.1, 1});
  CHECK(frames.t.size() == 4);
  CHECK(frames.t.back() == 0.3);
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

TEST_CASE("record_every keeps every k-th state, the first and the last") {
  const Frames frames = run(free_body(), make_runge_kutta(heun()), {1.1, 0.1, 4});
  CHECK(frames.t == std::vector<double>{0.0, 4 * 0.1, 8 * 0.1, 1.1});
  CHECK(frames.q.size() == 4 * 7);
  CHECK(frames.violation.size() == 4 * 3);
}

TEST_CASE("t_end = 0 records the initial state alone") {
  const Frames frames = run(spherical_pendulum(), make_runge_kutta(rk4()), {0.0, 0.1, 1});
  CHECK(frames.t == std::vector<double>{0.0});
  CHECK((last(frames.q, 7) - spherical_pendulum().initial_q()).norm() == 0.0);
}

TEST_CASE("advance returns with max_frames frames and goes on where it was") {
  Dynamics dynamics(spherical_pendulum(), {});
  Simulation simulation(dynamics, make_runge_kutta(rk4()), {1.0, 0.1, 1});
  std::vector<double> t;
  while (!simulation.finished()) {
    const Frames frames = simulation.advance(3, 1e9);
    CHECK(frames.t.size() <= 3);
    t.insert(t.end(), frames.t.begin(), frames.t.end());
  }
  CHECK(t == run(spherical_pendulum(), make_runge_kutta(rk4()), {1.0, 0.1, 1}).t);
  CHECK(simulation.steps_done() == 10);
}

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

TEST_CASE("an integrator of the user's own gets the same steps and states as a built-in one") {
  const Model model = spherical_pendulum();
  Dynamics dynamics(model, unstabilized());
  Simulation simulation(dynamics, nullptr, {0.25, 0.1, 1});
  VectorXd y_dot(14);
  while (const double h = simulation.begin_step()) {
    dynamics.rates(y_dot);
    simulation.accept(simulation.y().head<13>() + h * y_dot.head<13>());
  }
  const Frames own = simulation.take_frames();
  const Frames built_in = run(model, make_runge_kutta(euler()), {0.25, 0.1, 1}, unstabilized());
  CHECK(own.t == built_in.t);
  CHECK((last(own.q, 7) - last(built_in.q, 7)).norm() < 1e-15);
  CHECK((last(own.v, 6) - last(built_in.v, 6)).norm() < 1e-14);
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

TEST_CASE("multistep coefficients that are inconsistent are refused") {
  const auto code = [](const MultistepCoefficients& method) { return error_code([&] { make_multistep(method); }); };
  CHECK(code(abm4()) == "none");
  CHECK(code(multistep("none", 1, {}, {})) == "multistep");
  CHECK(code(multistep("predictor", 2, {1.5, -0.6}, {})) == "multistep");
  CHECK(code(multistep("corrector", 2, {1.5, -0.5}, {0.5, 0.6})) == "multistep");
  CHECK(code(multistep("reach", 2, {1.0}, {0.5, 0.25, 0.25})) == "multistep");
}

TEST_CASE("a schedule with a step, an end or a recording that makes no sense is refused") {
  const auto code = [](const Schedule& schedule) {
    return error_code([&] { run(free_body(), make_runge_kutta(rk4()), schedule); });
  };
  for (const double step : {0.0, -0.1, double(NAN), double(INFINITY), 1e-300}) CHECK(code({1.0, step, 1}) == "step");
  for (const double t_end : {-1.0, double(NAN), double(INFINITY)}) CHECK(code({t_end, 0.1, 1}) == "t_end");
  CHECK(code({1.0, 0.1, 0}) == "record_every");
}

TEST_CASE("a run that diverges ends with an error that names a body and the time") {
  for (const bool held : {false, true}) {
    CAPTURE(held);
    Model model = held ? spherical_pendulum() : free_body();
    const std::string name = model.body_name(0);
    const Mat3<double> I = Mat3<double>::Identity();
    const Vec3<double> s(1.0, 0.5, 0.0);
    model.add_force("spring_damper", "stiff", ground, 0, {s, s, I, I}, {{1e60, -1}, {0.0, -1}, {0.1, -1}, {0.0, -1}});
    try {
      run(model, make_runge_kutta(rk4()), {100.0, 0.5, 1});
      FAIL("no error");
    } catch (const NotFiniteError& error) {
      INFO(std::string(error.what()));
      CHECK((error.details.bodies.empty() ? "no body" : error.details.bodies.front()) == name);
      CHECK(error.details.time > 0.0);
      CHECK(error.details.time < 100.0);
    }
  }
}
