#include "linkwork/assembly/body_forces.hpp"

#include "support.hpp"

using namespace support;

TEST_CASE("gyroscopic torques are -omega x J omega and do no work") {
  Random random(21);
  Model model(Vec3<double>::Zero());
  const Body body = random_body(random);
  model.add_body("a", body);
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const Vec3<double> expected = -body.omega.cross(body.inertia * body.omega);
  CHECK(at.g.head<3>().norm() == 0.0);
  CHECK((at.g.segment<3>(3) - expected).norm() < 1e-15);
  CHECK(std::abs(at.g.segment<3>(3).dot(body.omega)) < 1e-15);
}

TEST_CASE("gravity gives g = m gravity and the potential -m gravity . r") {
  Random random(25);
  Model model(random.vec3(9.81));
  const Body body = random_body(random);
  model.add_body("a", body);
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  CHECK((at.g.head<3>() - body.mass * model.gravity()).norm() < 1e-14);
  CHECK(at.potential == doctest::Approx(-body.mass * model.gravity().dot(body.position)).epsilon(1e-14));
}
