#include "linkwork/integration/crossing.hpp"

#include "integrators.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// Without weight a parallelogram turns at a constant rate: its bars turn alike, and its rod does not turn.
Model turning(double from, double rate) {
  const Model placed = parallelogram(from, rate);
  Model model(Vec3<double>::Zero());
  for (int body = 0; body < 3; ++body) model.add_body(placed.body_name(body), placed.bodies()[body]);
  for (int joint = 0; joint < 4; ++joint) {
    const Element& it = placed.joints()[joint];
    model.add_joint("revolute", placed.joint_name(joint), it.i, it.j, it.at);
  }
  return model;
}

}  // namespace

TEST_CASE("a parallelogram goes on at its rate through the line, in which it could go on in two ways") {
  const double rate = 2.0, from = -0.5, t_end = 0.5;  // in line at 0.25 s
  for (const double h : {1e-2, 1e-3}) {
    Dynamics dynamics(turning(from, rate), {});
    Simulation simulation(dynamics, make_runge_kutta(rk4()), {t_end, h, 1});
    const Frames frames = simulation.advance(1 << 30, 1e9);
    const Vec3<double> omega = last(frames.v, 18).segment<3>(3);
    CHECK((omega - Vec3<double>(0, 0, rate)).norm() < 1e-6);
    CHECK(std::abs(2 * std::atan2(last(frames.q, 21)[6], last(frames.q, 21)[3]) - (from + rate * t_end)) < 1e-6);
    REQUIRE(dynamics.watch().singular_poses() == 1);
    CHECK(dynamics.watch().crossings()[0].t == doctest::Approx(0.25).epsilon(1e-4));
  }
}

TEST_CASE("no leap is due far from singular poses") {
  Dynamics dynamics(turning(1.0, 0.1), {});
  Crossing crossing(dynamics);
  const VectorXd y = dynamics.initial_y();
  dynamics.evaluate(0.0, y);
  VectorXd y_dot(y.size());
  dynamics.rates(y_dot);
  CHECK(!crossing.due(0.0, 1e-3, y, false));
}
