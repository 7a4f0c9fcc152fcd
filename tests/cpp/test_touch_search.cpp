#include "linkwork/integration/touch_search.hpp"

#include "integrators.hpp"
#include "linkwork/integration/hermite_step.hpp"

using namespace support;

namespace {

constexpr double radius = 0.01;

/// In one step of a second as if nothing were in the way, from y to y_new.
std::vector<TouchSearch::Touch> touches(const Model& model, const VectorXd& y, const VectorXd& y_new) {
  Dynamics dynamics(model, {});
  TouchSearch search(dynamics, 1e-12);
  dynamics.evaluate(0.0, y);
  search.begin(y, dynamics.evaluation().switches);
  dynamics.evaluate(1.0, y_new);
  if (!search.suspects({0.0, 1.0, y, y_new}, dynamics.evaluation().switches)) return {};
  return search.find(HermiteStep(dynamics.system(), y, y_new, 1.0));
}

/// Over 10 m, far longer than the spheres take to pass.
std::vector<TouchSearch::Touch> touches(double beside) {
  const Model model = two_balls(10.0, {5, beside, 0});
  const VectorXd y = Dynamics(model, {}).initial_y();
  VectorXd y_new = y;
  y_new[0] = 10.0;
  return touches(model, y, y_new);
}

/// Of a fall by g = 10 m/s^2 from rest, over a ball that waits `below` and so far beside the way.
std::vector<TouchSearch::Touch> touches_of_fall(double below, double beside) {
  const Model model = two_balls(0.0, {-below, beside, 0});
  const VectorXd y = Dynamics(model, {}).initial_y();
  VectorXd y_new = y;
  y_new[0] = -5.0;
  y_new[2 * position_size] = -10.0;
  return touches(model, y, y_new);
}

}  // namespace

TEST_CASE("spheres that meet in the middle of a step have touched there, head-on or barely") {
  for (const double beside : {0.0, 0.5 * radius, 1.9 * radius, 1.999 * radius}) {
    CAPTURE(beside);
    const auto found = touches(beside);
    REQUIRE(found.size() == 1);
    CHECK(found[0].which == 0);
    CHECK(std::abs(10.0 * found[0].theta - 5.0) < 2.0 * radius);
  }
}

TEST_CASE("spheres that pass each other have not") {
  for (const double beside : {2.0001 * radius, 2.1 * radius, 1.0, 100.0}) {
    CAPTURE(beside);
    CHECK(touches(beside).empty());
  }
}

TEST_CASE("a fall from rest touches what is in its way, whose distance changes least where the step begins") {
  for (const double below : {0.03, 0.5, 2.0, 4.9})
    for (const double beside : {0.0, 1.99 * radius}) {
      CAPTURE(below);
      CAPTURE(beside);
      const auto found = touches_of_fall(below, beside);
      REQUIRE(found.size() == 1);
      const double height = 5.0 * found[0].theta * found[0].theta;
      CHECK(std::hypot(height - below, beside) < 2.0 * radius);
    }
  CHECK(touches_of_fall(2.0, 2.001 * radius).empty());
}

namespace {

/// A slider at rest for a second, 0.5 m above a stop, whose end goes by `limit`.
std::vector<TouchSearch::Touch> touches_of_end(const TimeFunctionPtr& limit) {
  Model model(Vec3<double>::Zero());
  model.add_body("slider", Body{});
  const Vec3<double> O = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("translational_stop", "stop", ground, 0, {O, O, I, I},
                  {{0.0, model.add_signal(limit)}, {10.0, -1}, {1e4, -1}, {0.0, -1}});
  const VectorXd y = Dynamics(model, {}).initial_y();
  return touches(model, y, y);
}

}  // namespace

TEST_CASE("the end of a stop that comes and goes many times within a step is met when it first comes") {
  for (const double frequency : {20.0, 333.0}) {
    CAPTURE(frequency);
    const auto found = touches_of_end(harmonic(0.51, frequency, 0.0, -0.5));
    REQUIRE(found.size() == 1);
    const double first = std::asin(0.5 / 0.51), angle = frequency * found[0].theta;
    CHECK(angle > first);
    CHECK(angle < 3.1416 - first);
    CHECK(touches_of_end(harmonic(0.49999, frequency, 0.0, -0.5)).empty());
  }
}

TEST_CASE("the end of a stop that comes and goes between the knots of a table is met") {
  const std::vector<double> knots = {0.0, 0.62, 0.64, 0.66, 1.0}, pieces = {-0.5, 0, -0.5, 30, 0.1, -30, -0.5, 0};
  const auto found = touches_of_end(piecewise_polynomial(knots, pieces));
  REQUIRE(found.size() == 1);
  CHECK(std::abs(found[0].theta - 0.64) < 0.02);
}

TEST_CASE("an end that never comes so far is left alone however fast it moves") {
  CHECK(touches_of_end(harmonic(0.1, 1e9, 0.0, -0.5)).empty());
}
