#include "linkwork/assembly/force_elements.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

constexpr double stiffness = 7.0, damping = 0.3, length = 0.8;  // N/m, N s/m, m

/// A spring with damper from the ground at (0, 0, 1) to a corner of a moving body.
Model sprung() {
  Model model;
  Random random(3);
  Body body = body_at({1.0, 0.4, -0.2});
  body.velocity = random.vec3();
  body.omega = random.vec3();
  model.add_body("block", body);
  const Vec3<double> hook(0, 0, 1), corner(0.3, -0.2, 0.1);
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring", ground, 0, {hook, corner, I, I},
                  {{stiffness, -1}, {damping, -1}, {length, -1}, {0.0, -1}});
  return model;
}

}  // namespace

TEST_CASE("a spring with damper pulls along its line, stores and gives what its law says") {
  const System system(sprung());
  const VectorXd q = system.model().initial_q(), v = system.model().initial_v();
  ForceElement spring(system, 0);
  const ForceOnBody found = spring.evaluate(0.0, q, v, VectorXd::Zero(v.size()), VectorXd());
  const Vec3<double> corner(0.3, -0.2, 0.1), end = q.head<3>() + corner;  // not turned at the start
  const Vec3<double> d = end - Vec3<double>(0, 0, 1);
  const Vec3<double> speed = v.head<3>() + Vec3<double>(v.segment<3>(3)).cross(corner);
  const double rate = d.normalized().dot(speed);
  const double pull = stiffness * (d.norm() - length) + damping * rate;
  CHECK((found.force + pull * d.normalized()).norm() < 1e-13);
  CHECK(found.torque.norm() < 1e-13);  // at its point there is none
  CHECK(found.power == doctest::Approx(-pull * rate));
  CHECK(found.potential == doctest::Approx(0.5 * stiffness * std::pow(d.norm() - length, 2)));
}

TEST_CASE("what it gives is what the energies of the mechanism lose") {
  const System system(sprung());
  const VectorXd q = system.model().initial_q(), v = system.model().initial_v();
  const Evaluation at = evaluate_initially(system);
  ForceElement spring(system, 0);
  const ForceOnBody found = spring.evaluate(0.0, q, v, VectorXd::Zero(v.size()), VectorXd());
  const double weight = system.model().gravity().dot(v.head<3>());  // of 1 kg
  CHECK(at.g.head(v.size()).dot(v) == doctest::Approx(found.power + weight));
}

TEST_CASE("an inerter gives what the energies of the mechanism lose, and its own grows by") {
  Random random(321);
  Model model = random_tree(random, 3);
  for (const char* kind : {"inerter", "rotational_inerter", "translational_inerter"})
    model.add_force(kind, kind, 0, 2, random_attachment(random), {{0.7, -1}});
  const System system(model);
  const VectorXd q = model.initial_q(), v = model.initial_v(), v_dot = random.vector(system.v_size());
  const Evaluation at = evaluate_initially(system);
  VectorXd inertial(v.size()), bodies(v.size());
  system.multiply_mass(at, v_dot, inertial);
  const System without(model.without_forces());
  without.multiply_mass(evaluate_initially(without), v_dot, bodies);
  double power = 0.0;
  for (int k = 0; k < 3; ++k) {
    const ForceOnBody found = ForceElement(system, k).evaluate(0.0, q, v, v_dot, VectorXd());
    power += found.power;
    CHECK(found.potential == 0.0);
  }
  // M v_dot - g of all and of the bodies alone differ by the forces of the inerters.
  const VectorXd g = at.g.head(v.size()), g_bodies = evaluate_initially(without).g.head(v.size());
  CHECK(power == doctest::Approx(v.dot((bodies - g_bodies) - (inertial - g))).epsilon(1e-12));
}
