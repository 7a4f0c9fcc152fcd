#include "linkwork/integration/simulation.hpp"

#include "integrators.hpp"

using namespace support;

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

TEST_CASE("an integrator of the user's own gets the same steps and states as a built-in one") {
  const Model model = spherical_pendulum();
  Dynamics dynamics(model, unstabilized());
  Simulation simulation(dynamics, nullptr, {0.25, 0.1, 1});
  VectorXd y_dot(14);
  while (const double h = simulation.begin_step()) {
    dynamics.rates(y_dot);
    simulation.accept(simulation.y().head<13>() + h * y_dot.head<13>());
  }
  const Frames own = simulation.take_frames(true);
  const Frames built_in = run(model, make_runge_kutta(euler()), {0.25, 0.1, 1}, unstabilized());
  CHECK(own.t == built_in.t);
  CHECK((last(own.q, 7) - last(built_in.q, 7)).norm() < 1e-15);
  CHECK((last(own.v, 6) - last(built_in.v, 6)).norm() < 1e-14);
}

TEST_CASE("a schedule with a step, an end or a recording that makes no sense is refused") {
  const auto code = [](const Schedule& schedule) {
    return error_code([&] { run(free_body(), make_runge_kutta(rk4()), schedule); });
  };
  for (const double step : {0.0, -0.1, double(NAN), double(INFINITY), 1e-300}) CHECK(code({1.0, step, 1}) == "step");
  for (const double t_end : {-1.0, double(NAN), double(INFINITY)}) CHECK(code({t_end, 0.1, 1}) == "t_end");
  CHECK(code({1.0, 0.1, 0}) == "record_every");
}
