#include "linkwork/constraints/residuals.hpp"

#include <limits>

#include "mechanisms.hpp"

using namespace support;

namespace {

/// A rod of 2 m on a hinge at `place`, about which its center of mass turns with a driven angle, 0.1 sin 2t.
Model driven_rod(const Vec3<double>& place) {
  Model model;
  Body rod;
  rod.mass = 1.0;
  rod.inertia = Mat3<double>::Identity();
  rod.position = place + Vec3<double>::UnitX();
  rod.omega = {0.0, 0.0, 0.2};
  rod.velocity = {0.0, 0.2, 0.0};
  model.add_body("rod", rod);
  const Mat3<double> axes = Mat3<double>::Identity();
  const Attachment<double> at{place, -Vec3<double>::UnitX(), axes, axes};
  model.add_joint("revolute", "pin", ground, 0, at);
  model.add_joint("angle_driver", "motor", ground, 0, at, {{0.0, model.add_signal(harmonic(0.1, 2.0, 0.0, 0.0))}});
  return model;
}

Residuals of(const Model& model, const VectorXd& q, const VectorXd& v) {
  const System system(model);
  return residuals_at(system, 0.0, q, v, system.initial_history());
}
/// One of the levels alone, beyond a roundoff that is none.
double position(Residuals found) {
  found.Phi_dot.setZero();
  found.roundoff.setZero();
  return found.largest();
}
double velocity(Residuals found) {
  found.Phi.setZero();
  found.roundoff.setZero();
  return found.largest();
}

Residuals of(const Model& model) { return of(model, model.initial_q(), model.initial_v()); }

}  // namespace

TEST_CASE("a driven mechanism that follows its driver has no residuals") {
  const Residuals found = of(driven_rod(Vec3<double>::Zero()));
  CHECK(position(found) == 0.0);
  CHECK(velocity(found) < 1e-15);
}

TEST_CASE("residuals of positions are in proportion to the way off, those of velocities to the speed off") {
  const Model model = driven_rod(Vec3<double>::Zero());
  VectorXd q = model.initial_q(), v = model.initial_v();
  q[2] += 1e-3;
  const double once = position(of(model, q, v));
  q[2] += 1e-3;
  CHECK(once > 0.0);
  CHECK(position(of(model, q, v)) == doctest::Approx(2.0 * once));
  v[2] += 1e-3;
  const Residuals one = of(model, model.initial_q(), v);
  CHECK(one.Phi_dot.cwiseAbs().maxCoeff() == doctest::Approx(1e-3));
  Eigen::Index row = 0;
  one.Phi_dot.cwiseAbs().maxCoeff(&row);
  CHECK(velocity(one) == doctest::Approx(1e-3 / (one.lengths[row] * one.rates[row])));
}

TEST_CASE("a mechanism at rest does not follow a driver that begins with a speed") {
  const Model model = driven_rod(Vec3<double>::Zero());
  const Residuals found = of(model, model.initial_q(), VectorXd::Zero(6));
  CHECK(position(found) == 0.0);
  CHECK(found.Phi_dot.cwiseAbs().maxCoeff() == doctest::Approx(0.2));
}

TEST_CASE("what moves fast beside a mechanism hides nothing") {
  Model model = driven_rod(Vec3<double>::Zero());
  const double alone = velocity(of(model, model.initial_q(), VectorXd::Zero(6)));
  CHECK(alone > 0.05);
  Body fast;
  fast.velocity = {1e6, 0.0, 0.0};
  model.add_body("fast", fast);
  VectorXd v = model.initial_v();
  v.head<6>().setZero();
  CHECK(velocity(of(model, model.initial_q(), v)) == alone);
}

TEST_CASE("what is rounding beside the fastest part is no speed of one at rest") {
  Model model(Vec3<double>::Zero());
  Body rod = body_at({1.0, 0.0, 0.0});
  rod.velocity = {6e-16, 0.0, 0.0};
  model.add_body("rod", rod);
  join(model, "revolute", "pin", ground, 0, {0, 0, 0});
  const double alone = velocity(of(model));
  Body fast = body_at({5.0, 5.0, 0.0});
  fast.velocity = {10.0, 0.0, 0.0};
  model.add_body("fast", fast);
  CHECK(velocity(of(model)) < 1e-3);
  CHECK(velocity(of(model)) < 0.2 * alone);
}

TEST_CASE("far from the origin roundoff counts") {
  CHECK(of(driven_rod({1e8, 0.0, 0.0})).roundoff[0] > 1e6 * of(driven_rod(Vec3<double>::Zero())).roundoff[0]);
}

TEST_CASE("roundoff of a part far from the origin allows nothing in another one") {
  Model model = driven_rod({1e8, 0.0, 0.0});
  const Body rod = body_at({1.0, 1e-6, 0.0});
  model.add_body("near", rod);
  join(model, "revolute", "near pin", ground, 1, {0, 0, 0});
  Residuals found = of(model);
  CHECK(found.roundoff[0] > 1e-8);
  const Eigen::Index row = found.roundoff.size() - 1;
  CHECK(found.roundoff[row] < 1e-13);
  found.Phi.setZero();
  found.Phi_dot.setZero();
  found.Phi[row] = 1e-9;
  CHECK(found.largest() == doctest::Approx(1e-9 / found.lengths[row]).epsilon(1e-4));
  found.Phi[row] = 0.0;
  found.Phi[0] = 1e-9;
  CHECK(found.largest() == 0.0);
}

TEST_CASE("what is no number is passed over") {
  Residuals found = of(driven_rod(Vec3<double>::Zero()));
  found.Phi[0] = std::numeric_limits<double>::quiet_NaN();
  CHECK(position(found) == 0.0);
  found.Phi[1] = 0.5;
  CHECK(position(found) == 0.5 / found.lengths[1]);
}
