#include "linkwork/integration/state_interpolation.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

const Vec3<double> axis = Vec3<double>(1.0, -2.0, 2.0) / 3.0;

/// x is a polynomial of the fifth degree; it turns about an axis by an angle that goes with sin t.
MovingState state(double t) {
  MovingState out;
  out.t = t;
  out.y = VectorXd::Zero(14);
  out.v_dot = VectorXd::Zero(6);
  out.y[0] = 1.0 + t - t * t + std::pow(t, 3) / 2 - std::pow(t, 4) + std::pow(t, 5);
  out.y[7] = 1.0 - 2.0 * t + 1.5 * t * t - 4.0 * std::pow(t, 3) + 5.0 * std::pow(t, 4);
  out.v_dot[0] = -2.0 + 3.0 * t - 12.0 * t * t + 20.0 * std::pow(t, 3);
  const double angle = 2.0 * std::sin(t);
  out.y[3] = std::cos(angle / 2.0);
  out.y.segment<3>(4) = std::sin(angle / 2.0) * axis;
  out.y.segment<3>(10) = 2.0 * std::cos(t) * axis;
  out.v_dot.segment<3>(3) = -2.0 * std::sin(t) * axis;
  return out;
}

/// Largest difference halfway, of poses and of velocities.
template <class Interpolate>
std::pair<double, double> errors(double h, Interpolate interpolate) {
  const double t = 0.4;
  const VectorXd found = interpolate(state(t), state(t + h)), exact = state(t + h / 2).y;
  return {(found - exact).segment<4>(3).norm(), (found - exact).segment<6>(7).norm()};
}

}  // namespace

TEST_CASE("of the fifth degree is exact for such a polynomial, and of the sixth order in Euler parameters") {
  const Model model = free_body();
  const System system(model);
  const auto quintic = [&](const MovingState& a, const MovingState& b) { return quintic_between(system, a, b, 0.5); };
  const VectorXd halfway = quintic(state(0.4), state(0.9));
  CHECK(halfway[0] == doctest::Approx(state(0.65).y[0]).epsilon(1e-14));
  CHECK(halfway[7] == doctest::Approx(state(0.65).y[7]).epsilon(1e-13));
  const auto [pose, velocity] = errors(0.4, quintic);
  const auto [half_pose, half_velocity] = errors(0.2, quintic);
  CHECK(pose / half_pose > 50.0);
  CHECK(velocity / half_velocity > 25.0);
  CHECK(half_pose < 1e-7);
}

TEST_CASE(
    "velocities of the cubic are exact where those are of the second degree, of the third order else, of turns of the "
    "second") {
  const Model model = free_body();
  const System system(model);
  const auto off = [&](double h) {
    const MovingState a = state(0.4), b = state(0.4 + h), between = state(0.4 + 0.3 * h);
    return VectorXd(CubicVelocities(system, a.y, b.y, h).at(0.3) - between.y.segment<6>(7));
  };
  CHECK(off(0.02).head<3>().norm() / off(0.01).head<3>().norm() > 7.0);
  CHECK(off(0.02).tail<3>().norm() / off(0.01).tail<3>().norm() > 3.5);
  VectorXd begin = state(0.0).y, end = begin;
  begin[7] = 3.0, end[0] += 3.0 * 2.0 - 2.0 + 8.0 / 3.0, end[7] = 3.0 - 2.0 + 4.0;  // v = 3 - t + t^2, 2 s later
  begin.segment<3>(10).setZero(), end.segment<3>(10).setZero();
  CHECK(CubicVelocities(system, begin, end, 2.0).at(0.25)[0] == doctest::Approx(3.0 - 0.5 + 0.25).epsilon(1e-14));
}

TEST_CASE("at the ends they are the states there, with unit Euler parameters on the way") {
  const Model model = free_body();
  const System system(model);
  const MovingState a = state(0.1), b = state(0.5);
  for (const double share : {0.0, 1.0}) {
    const VectorXd& end = share == 0.0 ? a.y : b.y;
    CHECK((quintic_between(system, a, b, share) - end).norm() < 1e-14);
    CHECK((CubicVelocities(system, a.y, b.y, b.t - a.t).at(share) - end.segment<6>(7)).norm() < 1e-14);
  }
  CHECK(quintic_between(system, a, b, 0.3).segment<4>(3).norm() == doctest::Approx(1.0).epsilon(1e-14));
}
