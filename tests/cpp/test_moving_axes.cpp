#include "linkwork/integration/moving_axes.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

/// Two bodies of 1 and 3 kg, with a spring between them, where they are connected.
Model pair(bool connected) {
  Model model(Vec3<double>::Zero());
  for (const double mass : {1.0, 3.0}) {
    Body body;
    body.mass = mass;
    model.add_body(mass > 1.0 ? "heavy" : "light", body);
  }
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  const auto spring = [&](const char* name, int i, int j) {
    model.add_force("spring_damper", name, i, j, at, {{100.0, -1}, {0.0, -1}, {1.0, -1}, {0.0, -1}});
  };
  for (const int body : {0, 1}) spring(body == 0 ? "first" : "second", ground, body);
  if (connected) spring("between", 0, 1);
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
  const System system(pair(true));
  const KeptStep first = step(1.0, 0.5, {0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0});
  const KeptStep last = step(2.5, 0.5, {9.0, 9.0}, {4.0, 8.0}, {0.0, 0.0});
  const MovingAxes axes = MovingAxes::of(system, {&last, &first});
  CHECK(axes.t == 1.0);
  REQUIRE(axes.velocity.cols() == 1);
  CHECK(axes.velocity(0, 0) == doctest::Approx((1.0 * 4.0 + 3.0 * 8.0) / 4.0 / 2.0));
  CHECK(axes.velocity.col(0).tail<2>().norm() == 0.0);
}

TEST_CASE("each of two bodies that the ground alone connects has axes and a box of its own") {
  const System system(pair(false));
  const KeptStep all = step(1.0, 2.0, {0.0, 50.0}, {6.0, 50.0}, {0.0, 0.0});
  KeptStep half = step(1.0, 1.0, {0.0, 50.0}, {4.0, 50.0}, {0.0, 0.0});
  const MovingAxes axes = MovingAxes::of(system, {&all, &half});
  REQUIRE(axes.velocity.cols() == 2);
  CHECK(axes.velocity(0, axes.part[0]) == doctest::Approx(3.0));
  CHECK(axes.velocity(0, axes.part[1]) == doctest::Approx(0.0));
  const VectorXd diagonals = axes.diagonals({&all, &half});
  CHECK(diagonals[axes.part[0]] == doctest::Approx(1.0));  // 4 m where the mean velocity gives 3 m
  CHECK(diagonals[axes.part[1]] == doctest::Approx(0.0));
}

TEST_CASE("at the start they have the velocity of the center of mass") {
  const System system(pair(true));
  const MovingAxes axes = MovingAxes::at_start(system, step(2.0, 0.1, {0.0, 0.0}, {0.0, 0.0}, {2.0, -2.0}));
  CHECK(axes.t == 2.0);
  CHECK(axes.velocity(0, 0) == doctest::Approx(-1.0));
}

TEST_CASE("what the axes see is a state in which the common motion is left out, and there is a way back") {
  MovingAxes axes;
  axes.t = 1.0;
  axes.part = {0, 0};
  axes.velocity = Vec3<double>(2.0, 0.0, 0.0);
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
