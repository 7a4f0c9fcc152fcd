#include "linkwork/assembly/mass_ratios.hpp"

#include "support.hpp"

using namespace support;

namespace {

Body ball(double mass, double moment) {
  Body body;
  body.mass = mass;
  body.inertia = moment * Mat3<double>::Identity();
  return body;
}

}  // namespace

TEST_CASE("inertias are compared among bodies that joints connect, without massless ones") {
  Model model;
  model.add_body("heavy", ball(1e3, 50.0));
  model.add_body("light", ball(10.0, 1.0));
  model.add_body("massless", ball(0.0, 0.0));
  model.add_body("speck", ball(1e-9, 1e-12));
  CHECK(MassRatios(System(model)).mass == 1.0);
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  model.add_joint("spherical", "one", 0, 1, at, {});
  model.add_joint("spherical", "two", 1, 2, at, {});
  CHECK(MassRatios(System(model)).mass == doctest::Approx(100.0));
  CHECK(MassRatios(System(model)).moment == doctest::Approx(50.0));
  model.add_joint("spherical", "three", 2, 3, at, {});
  CHECK(MassRatios(System(model)).mass == doctest::Approx(1e12));
}

TEST_CASE("inertances are compared with the mass or the moment of what they move") {
  Model model;
  model.add_body("body", ball(2.0, 0.5));
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  model.add_force("rotational_inerter", "rotor", ground, 0, at, {{5.0, -1}});
  CHECK(MassRatios(System(model)).inertance == doctest::Approx(10.0));
  model.add_force("translational_inerter", "linear drive", ground, 0, at, {{100.0, -1}});
  CHECK(MassRatios(System(model)).inertance == doctest::Approx(50.0));
}
