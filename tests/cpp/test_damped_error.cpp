#include "linkwork/integration/damped_error.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double mass = 2.0, h = 1e-3;  // kg, s

/// A body that only forces of this kind hold, along x to the ground.
Model held(const char* kind, const std::vector<Parameter>& parameters) {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = mass;
  body.inertia = 0.1 * Mat3<double>::Identity();
  model.add_body("body", body);
  Attachment<double> at;
  at.s_i = Vec3<double>(-1.0, 0.0, 0.0);
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  model.add_force(kind, "force", ground, 0, at, parameters);
  return model;
}

Model damper(double stiffness, double damping) {
  return held("spring_damper", {{stiffness, -1}, {damping, -1}, {1.0, -1}, {0.0, -1}});
}

/// Of a state with the velocity v beside one with v + e, both in space.
std::vector<DampedError> separated(const Model& model, const Vec3<double>& v, const Vec3<double>& e) {
  Dynamics dynamics(model, Options());
  VectorXd b = dynamics.initial_y();
  b.segment<3>(position_size) = v;
  VectorXd a = b;
  a.segment<3>(position_size) += e;
  return find_damped_errors(dynamics, 0.0, h, a, b);
}

}  // namespace

TEST_CASE("what a stiff damper takes back of a velocity fades, what is across it lasts") {
  const double rate = 2.0 / h;
  const auto found = separated(damper(0.0, rate * mass), {0.1, 0.0, 0.0}, {1e-3, 1e-5, 0.0});
  REQUIRE(found.size() == 1);
  CHECK(found[0].fading.velocity == doctest::Approx(1e-3));
  CHECK(found[0].lasting.velocity == doctest::Approx(1e-5));
  CHECK(found[0].lasting.position == doctest::Approx(1e-3 / rate));
}

TEST_CASE("what a damper takes back in two steps comes to twice of it, and more than that adds up") {
  const auto found = separated(damper(0.0, 0.5001 / h * mass), {0.1, 0.0, 0.0}, {1e-3, 0.0, 0.0});
  REQUIRE(found.size() == 1);
  CHECK(found[0].fading.velocity == doctest::Approx(2e-3).epsilon(1e-3));
  CHECK(separated(damper(0.0, 0.4 / h * mass), {0.1, 0.0, 0.0}, {1e-3, 0.0, 0.0}).empty());
}

TEST_CASE("a stiff spring takes nothing back, nor does what pushes") {
  CHECK(separated(damper(1e9, 0.0), Vec3<double>::Zero(), {1e-3, 0.0, 0.0}).empty());
  CHECK(separated(damper(0.0, -2.0 / h * mass), {0.1, 0.0, 0.0}, {1e-3, 0.0, 0.0}).empty());
}

TEST_CASE("without forces all lasts") {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = mass;
  model.add_body("body", body);
  CHECK(separated(model, Vec3<double>::Zero(), {1e-3, 0.0, 0.0}).empty());
}
