#include "linkwork/integration/hermite_step.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a body in free fall is where the parabola has it") {
  const System system(free_body());
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1), y_new = y, y_between = y;
  y[3] = y_new[3] = 1.0;
  constexpr double g = 9.81, h = 0.7;
  const int v = system.q_size();
  y[v + 2] = 2.0;
  y_new[v + 2] = 2.0 - g * h;
  y_new[2] = 2.0 * h - 0.5 * g * h * h;
  HermiteStep(system, y, y_new, h).interpolate(system, 0.3, y_between);
  CHECK(y_between[2] == doctest::Approx(2.0 * 0.3 * h - 0.5 * g * 0.09 * h * h).epsilon(1e-14));
  CHECK(y_between[v + 2] == doctest::Approx(2.0 - g * 0.3 * h).epsilon(1e-14));
}
