#include "linkwork/integration/recorder.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a frame holds the state, its energies and how far it is off the constraints") {
  const Model model = displaced_slider();  // 1 kg, off the z axis by (1e-2, -2e-2) m, moving off it
  Dynamics dynamics(model, unstabilized());
  const VectorXd y = dynamics.initial_y();
  Recorder recorder(dynamics);
  dynamics.evaluate(0.0, y);
  recorder.record(0.5, y);
  CHECK(recorder.count() == 1);
  const Frames frames = recorder.take();
  CHECK(recorder.count() == 0);
  CHECK(frames.t == std::vector<double>{0.5});
  CHECK((last(frames.q, 7) - y.head<7>()).norm() == 0.0);
  CHECK((last(frames.v, 6) - y.segment<6>(7)).norm() == 0.0);
  CHECK(frames.kinetic[0] == doctest::Approx(0.5 * (0.25 + 0.04 + 1.0)).epsilon(1e-14));
  CHECK(frames.potential[0] == doctest::Approx(0.3 * 9.81).epsilon(1e-14));
  CHECK(frames.violation[0] == doctest::Approx(2e-2).epsilon(1e-14));
  CHECK(frames.violation[1] == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(frames.violation[2] < 1e-13);
  CHECK(frames.lambda.size() == 5);
}

TEST_CASE("accelerations that are not finite are an error, never a frame") {
  Dynamics dynamics(free_body(), {});
  Recorder recorder(dynamics);
  const VectorXd y = dynamics.initial_y(), v_dot = VectorXd::Constant(6, NAN);
  dynamics.evaluate(0.0, y);
  CHECK_THROWS_AS(recorder.record(0.0, y, v_dot, VectorXd(0)), NotFiniteError);
  CHECK(recorder.count() == 0);
}

TEST_CASE("recording in the course of a step changes no bit of it, and waits for its first solution") {
  Dynamics watched(spherical_pendulum(), {}), alone(spherical_pendulum(), {});
  const VectorXd y = watched.initial_y();
  VectorXd a(y.size()), b(y.size());
  Recorder recorder(watched);
  watched.evaluate(0.0, y);
  alone.evaluate(0.0, y);
  recorder.record_in_step(0.0, y);
  CHECK(recorder.count() == 0);
  watched.rates(a);
  alone.rates(b);
  CHECK(recorder.count() == 1);
  CHECK((a - b).norm() == 0.0);
}

TEST_CASE("a frame that waits for a step which does not come is recorded at the end") {
  Dynamics dynamics(spherical_pendulum(), {});
  Recorder recorder(dynamics);
  dynamics.evaluate(0.0, dynamics.initial_y());
  recorder.record_in_step(0.0, dynamics.initial_y());
  recorder.finish();
  CHECK(recorder.count() == 1);
}
