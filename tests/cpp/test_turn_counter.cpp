#include "linkwork/integration/turn_counter.hpp"

#include <cmath>
#include <numbers>

#include "integrators.hpp"

using namespace support;

namespace {

constexpr double pi = std::numbers::pi;

/// A body on a hinge about z through its center of mass.
Model rotor() {
  Model model;
  model.add_body("rotor", body_at(Vec3<double>::Zero()));
  join(model, "revolute", "hinge", ground, 0, Vec3<double>::Zero());
  return model;
}

/// Frames every so many of 1000 steps of a second in which it turns to and fro by 3 turns, or on by them, from rest to
/// rest.
std::vector<TurnCounter::Turned> turned(int every, bool on, int first = 0) {
  const Model model = rotor();
  const System system(model);
  TurnCounter counter(system);
  VectorXd q = VectorXd::Zero(position_size), v = VectorXd::Zero(velocity_size);
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0, phase = 2.0 * pi * t;
    const double angle = on ? 3.0 * (phase - std::sin(phase)) : 3.0 * pi * (1.0 - std::cos(phase));
    v[5] = on ? 6.0 * pi * (1.0 - std::cos(phase)) : 6.0 * pi * pi * std::sin(phase);
    q[3] = std::cos(angle / 2), q[6] = std::sin(angle / 2);
    counter.pass(t, q, v);
    if (k >= first && k % every == 0) counter.record(t, q, v);
  }
  return counter.found();
}

}  // namespace

TEST_CASE("turns of which frames show nothing are counted in the steps between them") {
  const auto found = turned(1000, true);
  REQUIRE(found.size() == 1);
  CHECK(found[0].before == 0.0);
  CHECK(found[0].t == 1.0);
  CHECK(found[0].coordinate == "angle");
  CHECK(std::abs(found[0].angle - 6.0 * pi) < 1e-12);
}

TEST_CASE("what turns to and fro has not turned, and frames that tell turns need no counting") {
  CHECK(turned(1000, false).empty());
  CHECK(turned(10, true).empty());
}

TEST_CASE("nothing is counted before the first frame") {
  CHECK(turned(1000, true, 1000).empty());
  const auto found = turned(400, true, 1);
  REQUIRE(found.size() == 1);
  CHECK(found[0].before == 0.4);
}
