#include "linkwork/constraints/length_scale.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// The four-bar, lengths in another unit.
Model four_bar_in(double unit) {
  Model model;
  const Model given = four_bar();
  for (Body body : given.bodies()) {
    body.position *= unit;
    body.inertia *= unit * unit;
    model.add_body("body" + std::to_string(model.bodies().size()), body);
  }
  for (Element joint : given.joints()) {
    joint.at.s_i *= unit;
    joint.at.s_j *= unit;
    model.add_joint("revolute", "joint" + std::to_string(model.joints().size()), joint.i, joint.j, joint.at);
  }
  return model;
}

}  // namespace

TEST_CASE("bodies that joints connect have one length, that of the longest arm from a center to a joint") {
  const System system(four_bar());
  const double coupler = 0.5 * std::hypot(2.0, 0.5);  // half of the coupler is the longest
  CHECK((characteristic_lengths(system).array() - coupler).abs().maxCoeff() < 1e-15);
}

TEST_CASE("without arms it is a radius of gyration, and 1 where there is no length at all") {
  Model model;
  Body body = body_at({1, 2, 3});
  body.mass = 2.0;
  body.inertia = 8.0 * Mat3<double>::Identity();
  model.add_body("alone", body);
  body.inertia.setZero();
  body.mass = 0.0;
  model.add_body("nothing", body);
  const VectorXd lengths = characteristic_lengths(System(model));
  CHECK(lengths[0] >= 2.0);  // between sqrt(J / m) and sqrt(trace J / m)
  CHECK(lengths[0] <= std::sqrt(12.0) + 1e-15);
  CHECK(lengths[1] == 1.0);
}

TEST_CASE("lengths are as many units as the mechanism, and relative residuals do not depend on the unit") {
  for (const double unit : {1e-3, 1e4}) {
    const System one(four_bar()), other(four_bar_in(unit));
    CHECK(relative_error(characteristic_lengths(other), VectorXd(unit * characteristic_lengths(one))) < 1e-14);
    const Evaluation at = evaluate_initially(one), scaled = evaluate_initially(other);
    const VectorXd lengths = row_lengths(one, at), of_other = row_lengths(other, scaled);
    const std::vector<char> rotations = rows_of_rotations(one, at);
    for (int row = 0; row < one.row_count(); ++row)
      CHECK(of_other[row] == doctest::Approx((rotations[row] ? 1.0 : unit) * lengths[row]).epsilon(1e-12));
  }
}

TEST_CASE("row lengths are those of D in velocities of natural size") {
  const System system(four_bar());
  const Evaluation at = evaluate_initially(system);
  const VectorXd expected = (dense_D(system, at) * velocity_scale(system).asDiagonal()).rowwise().norm();
  CHECK(relative_error(row_lengths(system, at), expected) < 1e-14);
}

TEST_CASE("the rate of a mechanism is that of its velocities: twice as fast, twice the rate") {
  Model model(Vec3<double>::Zero());
  Body body = body_at({0.5, 0, 0});
  body.omega = {0, 0, 3};
  body.velocity = {0, 1.5, 0};
  model.add_body("arm", body);
  join(model, "revolute", "pin", ground, 0, {0, 0, 0});
  const System system(model);
  const VectorXd v = model.initial_v();
  Evaluation at = system.make_evaluation();
  const auto rate = [&](double factor) {
    system.evaluate(0.0, model.initial_q(), factor * v, system.initial_history(), at);
    return characteristic_rates(system, at, factor * v)[0];
  };
  CHECK(rate(2.0) == doctest::Approx(2.0 * rate(1.0)).epsilon(1e-12));
  CHECK(rate(1.0) >= 3.0);
}

TEST_CASE("the rate of a mechanism at rest is what its forces and torques would give it") {
  Model model(Vec3<double>::Zero());
  Body wheel = body_at({0, 0, 0});
  wheel.mass = 2.0;
  wheel.inertia = Vec3<double>(1.0, 2.0, 2.0).asDiagonal();
  model.add_body("wheel", wheel);
  join(model, "revolute", "pin", ground, 0, {0.25, 0, 0});
  const System system(model);
  Evaluation at = system.make_evaluation();
  const auto rate = [&](const Vec3<double>& force, const Vec3<double>& torque) {
    system.evaluate(0.0, model.initial_q(), model.initial_v(), system.initial_history(), at);
    at.g.head<velocity_size>() << force, torque;  // the ground's follow
    return characteristic_rates(system, at, model.initial_v())[0];
  };
  const double length = 0.25, inertia = 2.0 * length + 5.0 / (2.0 * length);  // kg m
  CHECK(rate({0, 0, 0}, {0, 0, 3}) == doctest::Approx(std::sqrt(3.0 / length / inertia)).epsilon(1e-12));
  CHECK(rate({0, 4, 0}, {0, 0, 3}) == doctest::Approx(std::sqrt((4.0 + 3.0 / length) / inertia)).epsilon(1e-12));
}
