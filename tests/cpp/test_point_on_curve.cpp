#include "linkwork/model/special/point_on_curve.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// A ball whose center stays on c(s) = (s, bend s^2, 0) of the ground, between s = -1 and 1; z is across.
Model on_parabola(double bend, const Vec3<double>& position, const Vec3<double>& velocity = Vec3<double>::Zero()) {
  Model model;
  Body ball = body_at(position);
  ball.velocity = velocity;
  ball.omega = {0.3, -0.5, 0.7};
  model.add_body("ball", ball);
  const Vec3<double> O = Vec3<double>::Zero(), X = Vec3<double>::UnitX(), Y = Vec3<double>::UnitY();
  const Attachment<double> at{O, O, Mat3<double>::Identity(), Mat3<double>::Identity()};
  Curve curve;
  curve.knots = {-1.0, 1.0};
  curve.c = {{bend * Y - X, X - 2.0 * bend * Y, bend * Y, O}};
  curve.e = {{Vec3<double>::UnitZ(), O, O, O}};
  model.add_special_joint("point_on_curve", "wire", ground, 0, at,
                          std::make_shared<PointOnCurve>(ground, 0, at, std::move(curve)), {});
  return model;
}

VectorXd Phi(const Model& model) { return evaluate_initially(System(model)).Phi; }

}  // namespace

TEST_CASE("a point on the curve violates nothing, one beside it does by its distance, along both normals") {
  CHECK(Phi(on_parabola(0.5, {0.4, 0.08, 0.0})).cwiseAbs().maxCoeff() < 1e-15);
  const VectorXd beside = Phi(on_parabola(0.5, {0.0, -0.3, 0.2}));  // nearest to the vertex
  CHECK(std::abs(beside[0]) == doctest::Approx(0.2).epsilon(1e-14));
  CHECK(std::abs(beside[1]) == doctest::Approx(0.3).epsilon(1e-14));
}

TEST_CASE("a curve goes on straight beyond its ends") {
  CHECK(Phi(on_parabola(0.5, {3.0, 2.5, 0.0})).cwiseAbs().maxCoeff() < 1e-14);  // from (1, 0.5) on with slope 1
}

TEST_CASE("Phi_dot and gamma are the derivatives of Phi along a motion") {
  const Model model = on_parabola(0.8, {0.5, 0.15, 0.1}, {1.2, -0.4, 0.3});
  const System system(model);
  const VectorXd q = model.initial_q(), v = model.initial_v(), none = VectorXd::Zero(6);
  const Evaluation at = evaluate_initially(system);
  Evaluation there = system.make_evaluation();
  const auto along = [&](double s) {
    system.evaluate(0.0, moved(q, v, none, s), v, system.initial_history(), there);
    return there.Phi;
  };
  CHECK(relative_error(at.Phi_dot, first_difference(along, 1e-3)) < 1e-9);
  CHECK(relative_error(dense_D(system, at) * v, at.Phi_dot) < 1e-14);
  CHECK(relative_error(VectorXd(-at.gamma), second_difference(along, 1e-3)) < 1e-7);
}

TEST_CASE("a curve without pieces, or with knots that do not ascend, is refused") {
  const Attachment<double> at{};
  CHECK_THROWS_AS(PointOnCurve(ground, 0, at, {}), ModelError);
  Curve backward;
  backward.knots = {1.0, 0.0};
  backward.c.resize(1);
  backward.e.resize(1);
  CHECK_THROWS_AS(PointOnCurve(ground, 0, at, backward), ModelError);
}
