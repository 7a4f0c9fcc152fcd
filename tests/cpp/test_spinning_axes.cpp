#include "linkwork/integration/spinning_axes.hpp"

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/rotation.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

Body disc(double about, double across, double other) {
  Body body;
  body.inertia = Vec3<double>(across, other, about).asDiagonal();
  return body;
}

/// On a hinge about z, its center of mass so far beside the axis.
Model on_bearing(const Body& body, double beside, const std::string& kind = "revolute") {
  Model model;
  model.add_body("rotor", body);
  Attachment<double> at{Vec3<double>::Zero(), {-beside, 0.0, 0.3}, Mat3<double>::Identity(), Mat3<double>::Identity()};
  at.s_i = body.position + at.s_j;
  model.add_joint(kind, "bearing", ground, 0, at);
  return model;
}

}  // namespace

TEST_CASE("a rotor is symmetric about the only hinge or sleeve that holds it, and nothing else acts on it") {
  const auto axis = [](const Model& model) { return Vec3<double>(rotor_axes(System(model)).col(0)); };
  const Body symmetric = disc(0.3, 0.2, 0.2);
  CHECK(axis(on_bearing(symmetric, 0.0)) == Vec3<double>(0, 0, 1));
  CHECK(axis(on_bearing(symmetric, 0.0, "cylindrical")) == Vec3<double>(0, 0, 1));
  CHECK(axis(on_bearing(symmetric, 0.0, "spherical")).isZero(0.0));
  CHECK(axis(on_bearing(symmetric, 1e-3)).isZero(0.0));
  CHECK(axis(on_bearing(disc(0.3, 0.2, 0.21), 0.0)).isZero(0.0));
  Model held_twice = on_bearing(symmetric, 0.0);
  held_twice.add_joint("revolute", "other bearing", ground, 0, held_twice.joints()[0].at);
  CHECK(axis(held_twice).isZero(0.0));
}

TEST_CASE("what is seen from spinning axes comes back, and its rates are those of what is seen") {
  Random random(3);
  const double time = 0.7, h = 1e-5;
  SpinningAxes axes{MatrixXd::Zero(3, 2)};
  axes.Omega.col(1) = Vec3<double>(0.3, -0.2, 4.0);
  VectorXd y = random.vector(27, 1.0);
  for (const int body : {0, 1}) y.segment<4>(7 * body + 3).normalize();
  VectorXd seen = y;
  axes.see(time, seen);
  CHECK((seen.head(3) - y.head(3)).norm() == 0.0);
  VectorXd back = seen;
  axes.carry(time, back);
  CHECK((back - y).norm() < 1e-14);
  VectorXd y_dot = random.vector(27, 1.0), after = y + h * y_dot, before = y - h * y_dot;
  axes.see(time + h, after);
  axes.see(time - h, before);
  VectorXd rates = y_dot;
  axes.see_rates(time, y, rates);
  CHECK(((after - before) / (2 * h) - rates).norm() < 1e-8);
  VectorXd accelerations = rates.segment(14, 12);
  axes.carry_accelerations(time, y, accelerations);
  CHECK((accelerations - y_dot.segment(14, 12)).norm() < 1e-13);
}

TEST_CASE("the multipliers of the bearing of a rotor are those of all equations") {
  Body body = disc(0.3, 0.2, 0.2);
  body.omega = {0.0, 0.0, 50.0};
  Dynamics dynamics(on_bearing(body, 0.0), {});
  dynamics.evaluate(0.0, dynamics.initial_y());
  VectorXd v_dot(6), expected(5), found = VectorXd::Zero(5);
  dynamics.refined_accelerations(v_dot, expected);
  hold_rotor(dynamics.system(), dynamics.evaluation(), 0, v_dot, found);
  CHECK((found - expected).norm() < 1e-12 * expected.norm());
  CHECK(expected.norm() > 1.0);
}
