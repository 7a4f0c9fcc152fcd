#include "linkwork/integration/moving_axes.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

/// Two bodies of 1 and 3 kg.
Model pair() {
  Model model(Vec3<double>::Zero());
  for (const double mass : {1.0, 3.0}) {
    Body body;
    body.mass = mass;
    model.add_body(mass > 1.0 ? "heavy" : "light", body);
  }
  return model;
}

/// From t to t + h, with centers of mass x m along x then and after it, and velocities (m/s) at the beginning.
KeptStep step(double t, double h, std::vector<double> x, std::vector<double> x_new, std::vector<double> v) {
  KeptStep out;
  out.t = t;
  out.h = h;
  out.y = out.y_new = VectorXd::Zero(27);  // q, v, work
  for (const int body : {0, 1}) {
    out.y[7 * body] = x[body];
    out.y_new[7 * body] = x_new[body];
    out.y[14 + 6 * body] = v[body];
  }
  return out;
}

}  // namespace

TEST_CASE("axes move with the center of mass from the first kept step to the end of the last") {
  const System system(pair());
  const KeptStep first = step(1.0, 0.5, {0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0});
  const KeptStep last = step(2.5, 0.5, {9.0, 9.0}, {4.0, 8.0}, {0.0, 0.0});
  const MovingAxes axes = MovingAxes::of(system, {&last, &first});
  CHECK(axes.t == 1.0);
  CHECK(axes.velocity.x() == doctest::Approx((1.0 * 4.0 + 3.0 * 8.0) / 4.0 / 2.0));
  CHECK(axes.velocity.tail<2>().norm() == 0.0);
  CHECK(MovingAxes::of(system, {}).velocity.norm() == 0.0);
}

TEST_CASE("at the start they have the velocity of the center of mass") {
  const System system(pair());
  const MovingAxes axes = MovingAxes::at_start(system, step(2.0, 0.1, {0.0, 0.0}, {0.0, 0.0}, {2.0, -2.0}));
  CHECK(axes.t == 2.0);
  CHECK(axes.velocity.x() == doctest::Approx(-1.0));
}

TEST_CASE("what the axes see is a state in which the common motion is left out, and there is a way back") {
  const System system(pair());
  const MovingAxes axes{1.0, {2.0, 0.0, 0.0}};
  VectorXd y = step(1.0, 0.5, {5.0, 7.0}, {0.0, 0.0}, {3.0, 2.0}).y;
  const VectorXd before = y;
  axes.see(2.5, y);
  CHECK(y[0] == 2.0);
  CHECK(y[7] == 4.0);
  CHECK(y[14] == 1.0);
  CHECK(y[20] == 0.0);
  axes.carry(2.5, y);
  CHECK(y == before);
}
