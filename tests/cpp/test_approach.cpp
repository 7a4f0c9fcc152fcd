#include "linkwork/integration/approach.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// Of the first of two balls with this velocity along x, in a step of 2 s from 0 to x_new.
double change(double x_new, double v, double v_new, const double* v_dot = nullptr) {
  const Model model = two_balls(v, {5, 0, 0});
  const System system(model);
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
  y.head(system.q_size()) = model.initial_q();
  y.segment(system.q_size(), system.v_size()) = model.initial_v();
  VectorXd y_new = y;
  y_new[0] = x_new;
  y_new[system.q_size()] = v_new;
  return Approach(model).largest_change(0, {0.0, 2.0, y, y_new, v_dot, v_dot});
}

}  // namespace

TEST_CASE("a ball comes nearer by its way, uniform or accelerated") {
  CHECK(change(6.0, 3.0, 3.0) == doctest::Approx(6.0));
  CHECK(change(4.0, 0.0, 4.0) == doctest::Approx(8.0));  // as fast as at the end
}

TEST_CASE("one that is back at the same speed may have been elsewhere as far as its accelerations say") {
  double v_dot[12] = {7.0};
  CHECK(change(0.0, 0.0, 0.0) == 0.0);
  CHECK(change(0.0, 0.0, 0.0, v_dot) == doctest::Approx(14.0));
}
