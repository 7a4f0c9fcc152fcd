#include "linkwork/constraints/initial_conditions.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// The center of a body on a sphere of radius 1 about the origin.
Model on_a_sphere(const Vec3<double>& position) {
  Model model;
  model.add_body("ball", body_at(position));
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_joint("distance", "rod", ground, 0, {O, O, I, I}, {{1.0, -1}});
  return model;
}

}  // namespace

TEST_CASE("the nearest position on a sphere is the radial one, and its distance m d^2") {
  const Vec3<double> start(0.8, -0.5, 0.9);
  const Model model = on_a_sphere(start);
  const System system(model);
  InitialConditions conditions(system, {}, {});
  const VectorXd given = model.initial_q();
  VectorXd q = given;
  REQUIRE(conditions.positions(given, q));
  CHECK((q.head<3>() - start.normalized()).norm() < 1e-9);
  CHECK((q.tail<4>() - given.tail<4>()).norm() < 1e-12);  // nothing turns it
  const double d = start.norm() - 1.0;
  CHECK(conditions.distance(given, q) == doctest::Approx(model.bodies()[0].mass * d * d).epsilon(1e-9));
}

TEST_CASE("the nearest velocity on a sphere is the tangential one") {
  const Vec3<double> position = Vec3<double>(2, 1, -2) / 3.0;
  const Model model = on_a_sphere(position);
  const System system(model);
  InitialConditions conditions(system, {}, {});
  Random random(91);
  const VectorXd given = random.vector(6);
  VectorXd v = given;
  REQUIRE(conditions.velocities(model.initial_q(), v));
  const Vec3<double> expected = given.head<3>() - position * position.dot(given.head<3>());
  CHECK((v.head<3>() - expected).norm() < 1e-13);
  CHECK(v.tail<3>() == given.tail<3>());
}

TEST_CASE("of two bodies on a rod the heavy one moves less, and a held one not at all") {
  Model model;
  Body light = body_at({0, 0, 0}), heavy = body_at({1.3, 0, 0});
  heavy.mass = 3.0;
  model.add_body("light", light);
  model.add_body("heavy", heavy);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_joint("distance", "rod", 0, 1, {O, O, I, I}, {{1.0, -1}});
  const System system(model);
  const VectorXd given = model.initial_q();
  VectorXd q = given;
  REQUIRE(InitialConditions(system, {}, {}).positions(given, q));
  CHECK(q[0] == doctest::Approx(0.225).epsilon(1e-8));  // 0.3 m in the ratio 3 : 1
  CHECK(1.3 - q[7] == doctest::Approx(0.075).epsilon(1e-8));
  q = given;
  REQUIRE(InitialConditions(system, {}, {0}).positions(given, q));
  CHECK(q[0] == 0.0);
  CHECK(q[7] == doctest::Approx(1.0).epsilon(1e-9));
}

TEST_CASE("constraints that cannot be met are said to be, and are violated least") {
  Model model = on_a_sphere({1.0, 0, 0});
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_joint("distance", "other", ground, 0, {O, O, I, I}, {{2.0, -1}});
  const System system(model);
  InitialConditions conditions(system, {}, {});
  const VectorXd given = model.initial_q();
  VectorXd q = given;
  CHECK(!conditions.positions(given, q));
  const double r = q.head<3>().norm();
  CHECK(r > 1.0);
  CHECK(r < 2.0);
}

TEST_CASE("rates that contradict each other are refused, and leave velocities as small as what is given") {
  Model model = on_a_sphere({1.0, 0, 0});
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_joint("distance", "growing", ground, 0, {O, O, I, I}, {{0.0, model.add_signal(polynomial({1.0, 0.5}))}});
  const System system(model);
  VectorXd v = VectorXd::Zero(6);
  CHECK(!InitialConditions(system, {}, {}).velocities(model.initial_q(), v));
  CHECK(v.norm() < 1.0);
}
