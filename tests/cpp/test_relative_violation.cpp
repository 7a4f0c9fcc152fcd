#include "linkwork/integration/relative_violation.hpp"

#include "linkwork/assembly/connected_components.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// A rod of `length` from the ground to the center of a body that hangs `off` too low; all in units of `unit`.
double violation(double length, double off, double unit) {
  Model model;
  Body body = body_at({0, 0, -(length + off) * unit});
  body.inertia *= unit * unit;
  model.add_body("bob", body);
  const Mat3<double> I = Mat3<double>::Identity();
  Attachment<double> at{Vec3<double>(0, 0, 0.5 * unit), Vec3<double>(0, 0, 0.5 * unit), I, I};
  model.add_joint("distance", "rod", ground, 0, at, {{length * unit, -1}});
  const System system(model);
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
  y.head(system.q_size()) = model.initial_q();
  return RelativeViolation(system).largest(0.0, y, system.initial_history());
}

}  // namespace

TEST_CASE("a rod that is too short by e counts as e over the size of the mechanism, in any unit of length") {
  for (const double unit : {1.0, 1e-3, 1e3}) {
    CHECK(violation(2.0, 1e-4, unit) == doctest::Approx(1e-4 / 2.0).epsilon(1e-6));  // longer than the arm to it, 0.5
    CHECK(violation(2.0, 0.0, unit) < 1e-15);
  }
}

TEST_CASE("a state on the constraints violates nothing, one whose body is displaced does by its displacement") {
  const System system(four_bar());
  RelativeViolation relative(system);
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
  y.head(system.q_size()) = system.model().initial_q();
  CHECK(relative.largest(0.0, y, system.initial_history()) < 1e-15);
  y[0] += 1e-3;
  const double found = relative.largest(0.0, y, system.initial_history());
  CHECK(found <= 1e-3 / relative.lengths()[0]);
  CHECK(found >= 0.3e-3 / relative.lengths()[0]);  // the hinges share it
}

TEST_CASE("a violation is relative to the size of its own part, however large others are beside it") {
  const auto rods = [](bool large) {
    Model model;
    const Mat3<double> I = Mat3<double>::Identity();
    for (const double length : {1.0, 1e4}) {
      if (length > 1.0 && !large) break;
      const double off = length > 1.0 ? 0.0 : 1e-4;
      const int body = model.add_body(length > 1.0 ? "large" : "small", body_at({0, 0, -(length + off)}));
      Attachment<double> at{Vec3<double>::Zero(), Vec3<double>::Zero(), I, I};
      model.add_joint("distance", length > 1.0 ? "boom" : "rod", ground, body, at, {{length, -1}});
    }
    return model;
  };
  for (const bool large : {false, true}) {
    const System system(rods(large));
    VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
    y.head(system.q_size()) = system.model().initial_q();
    CHECK(RelativeViolation(system).largest(0.0, y, system.initial_history()) == doctest::Approx(1e-4).epsilon(1e-3));
  }
}

TEST_CASE("the size is that of the arms, or the radius of gyration where joints are next to centers of mass") {
  const auto size = [](double arm, double mass, double inertia) {
    Model model;
    Body body = body_at({arm, 0, 0});
    body.mass = mass;
    body.inertia = inertia * Mat3<double>::Identity();
    model.add_body("rotor", body);
    join(model, "revolute", "hinge", ground, 0, Vec3<double>::Zero());
    return RelativeViolation::lengths_of(System(model))[0];
  };
  const double gyration = std::sqrt(3.0 * 0.25);  // of the trace
  for (const double mass : {1e-6, 1.0, 1e6})
    for (const double arm : {0.0, 1e-17, 1e-4})
      CHECK(size(arm, mass, 0.25 * mass) == doctest::Approx(gyration).epsilon(1e-12));
  CHECK(size(0.1, 1.0, 0.25) == doctest::Approx(0.1).epsilon(1e-12));
  CHECK(size(0.1, 1e-3, 1.0) == doctest::Approx(0.1).epsilon(1e-12));  // the inertia is that of a rotor elsewhere
}

TEST_CASE("velocities miss the constraints by the speed that would satisfy them, of each part by its own") {
  Model model = four_bar();
  const int free = model.add_body("free", body_at({9, 9, 9}));
  const System system(model);
  RelativeViolation relative(system);
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
  y.head(system.q_size()) = system.model().initial_q();
  relative.largest(0.0, y, system.initial_history());
  CHECK(relative.speeds().isZero());
  y[system.q_size() + velocity_size * free] = 5.0;  // nothing holds it
  y[system.q_size() + 2] = 1e-3;                    // out of the plane
  relative.largest(0.0, y, system.initial_history());
  const ConnectedParts& parts = ConnectedParts::of(system);
  CHECK(relative.speeds()[parts.of_body(free)] == 0.0);
  CHECK(relative.speeds()[parts.of_body(0)] <= 1e-3);
  CHECK(relative.speeds()[parts.of_body(0)] > 5e-4);
}
