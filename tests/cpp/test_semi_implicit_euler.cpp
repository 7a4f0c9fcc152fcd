#include "integrators.hpp"

using namespace support;

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
