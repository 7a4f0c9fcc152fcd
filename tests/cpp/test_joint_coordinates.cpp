#include "linkwork/model/joint_coordinates.hpp"

#include <numbers>

#include "linkwork/model/primitives.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// Two bodies whose joint frames agree, the second then turned by an angle about the joint's z and shifted along it.
struct Pair {
  BodyState<double> i = BodyState<double>::ground(), j = BodyState<double>::ground();
  Attachment<double> at;
};

Pair turned(Random& random, double angle, double shift) {
  Pair out;
  out.at = random_attachment(random);
  out.i.r = random.vec3();
  out.i.A = random.frame();
  const Mat3<double> F = out.i.A * out.at.C_i;  // the joint's axes in space
  const Mat3<double> R = rotation_matrix<double>(exponential(angle * F.col(2)));
  out.j.A = R * F * out.at.C_j.transpose();
  out.j.r = out.i.r + out.i.A * out.at.s_i + shift * F.col(2) - out.j.A * out.at.s_j;
  return out;
}

double value(const FreeCoordinate& coordinate, const Pair& pair) {
  Equation<double> out;
  coordinate.evaluate(pair.at, pair.i, pair.j, out);
  return out.Phi;
}

}  // namespace

TEST_CASE("a hinge that was turned and shifted has that angle and that displacement") {
  Random random(51);
  for (const double angle : {-3.0, -0.4, 0.0, 1.2, 3.1})
    for (const double shift : {-0.7, 0.0, 2.0}) {
      const Pair pair = turned(random, angle, shift);
      CHECK(std::abs(value(turn_about_axis, pair) - angle) < 1e-14);
      CHECK(std::abs(value(shift_along_axis, pair) - shift) < 1e-14);
    }
}

TEST_CASE("D of a coordinate is its derivative along every motion of the two bodies") {
  Random random(52);
  for (const FreeCoordinate* coordinate :
       {&turn_about_axis, &shift_along_axis, &turn_about_axis_a, &turn_about_axis_b}) {
    CAPTURE(std::string(coordinate->name));
    Pair pair = turned(random, 0.6, 0.3);
    pair.j.A = pair.j.A * rotation_matrix<double>(exponential(random.vec3(0.3)));  // off the constraints, too
    for (BodyState<double>* body : {&pair.i, &pair.j}) {
      body->r_dot = random.vec3();
      body->omega = random.vec3();
    }
    Equation<double> at_rest;
    coordinate->evaluate(pair.at, pair.i, pair.j, at_rest);
    const auto after = [&](double s) {
      Pair now = pair;
      for (BodyState<double>* body : {&now.i, &now.j}) {
        body->r += s * body->r_dot;
        body->A = body->A * rotation_matrix<double>(exponential(s * body->omega));
      }
      return VectorXd::Constant(1, value(*coordinate, now));
    };
    CHECK(std::abs(first_difference(after, 1e-3)[0] - at_rest.rate(pair.i, pair.j)) < 1e-9);
  }
}

TEST_CASE("a continued angle differs by full turns and by less than half a turn from the last") {
  constexpr double pi = std::numbers::pi;
  for (const double last : {-20.0, -0.1, 3.0, 50.0})
    for (const double angle : {-3.0, 0.0, 2.5}) {
      const double found = continued(angle, last);
      const double turns = (found - angle) / (2.0 * pi);
      CHECK(std::abs(turns - std::round(turns)) < 1e-14);
      CHECK(std::abs(found - last) <= pi + 1e-12);
    }
}
