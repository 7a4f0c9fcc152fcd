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

/// The rotor at an angle, with a rate, at times, and who counts how often it goes round.
struct Rotor {
  Model model = rotor();
  System system{model};
  TurnCounter counter{system};
  VectorXd q = VectorXd::Zero(position_size), v = VectorXd::Zero(velocity_size);

  void pass(double t, double angle, double rate, bool records) {
    q[3] = std::cos(angle / 2), q[6] = std::sin(angle / 2);
    v[5] = rate;
    counter.pass(t, q, v);
    if (records) counter.record(t, q, v);
  }
};

/// Frames every so many of 1000 steps of a second in which it turns to and fro by 3 turns, or on by them, from rest to
/// rest.
std::vector<TurnCounter::Turned> turned(int every, bool on, int first = 0) {
  Rotor it;
  for (int k = 0; k <= 1000; ++k) {
    const double t = k / 1000.0, phase = 2.0 * pi * t;
    const double angle = on ? 3.0 * (phase - std::sin(phase)) : 3.0 * pi * (1.0 - std::cos(phase));
    const double rate = on ? 6.0 * pi * (1.0 - std::cos(phase)) : 6.0 * pi * pi * std::sin(phase);
    it.pass(t, angle, rate, k >= first && k % every == 0);
  }
  return it.counter.found();
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

TEST_CASE("rest before and after turns counts for nothing, however long") {
  for (const double before : {0.0, 1.0, 30.0})
    for (const double after : {1.0, 30.0}) {
      Rotor it;
      it.pass(0.0, 0.0, 0.0, true);
      if (before > 0.0) it.pass(before, 0.0, 0.0, false);
      for (int k = 1; k <= 100; ++k) {
        const double part = k / 100.0, phase = 2.0 * pi * part;
        it.pass(before + part, 2.0 * (phase - std::sin(phase)), 4.0 * pi * (1.0 - std::cos(phase)), false);
      }
      it.pass(before + 1.0 + after, 4.0 * pi, 0.0, true);
      REQUIRE(it.counter.found().size() == 1);
      CHECK(it.counter.found()[0].angle == doctest::Approx(4.0 * pi).epsilon(1e-12));
    }
}

TEST_CASE("long steps turn by the mean of the rates at their ends, or nobody knows") {
  Rotor steady, braked;
  for (int k = 0; k <= 10; ++k) steady.pass(k, 8.0 * k, 8.0, k % 10 == 0);
  REQUIRE(steady.counter.found().size() == 1);
  CHECK(steady.counter.found()[0].angle == doctest::Approx(80.0).epsilon(1e-12));
  for (int k = 0; k <= 10; ++k) braked.pass(k, 6.0 * k, k % 2 ? 12.0 : 0.0, k % 10 == 0);
  REQUIRE(braked.counter.found().size() == 1);
  CHECK(std::isnan(braked.counter.found()[0].angle));
  for (int k = 1; k <= 10; ++k) braked.pass(10 + k, 60.0 + 8.0 * k, 8.0, k == 1 || k == 10);
  CHECK(braked.counter.found().back().angle == doctest::Approx(72.0).epsilon(1e-12));  // of what is sure since
}

TEST_CASE("of steps that a run gives up nothing is counted, also where it goes back without a word") {
  for (const bool told : {true, false}) {
    Rotor it;
    it.pass(0.0, 0.0, 4.0, true);
    const TurnCounter::Way way = it.counter.way();
    for (int k = 1; k <= 40; ++k) it.pass(k / 20.0, k / 5.0, 4.0, false);
    if (told) it.counter.go_back(way);
    for (int k = 1; k <= 100; ++k) it.pass(k / 20.0, k / 5.0, 4.0, k == 100);
    REQUIRE(it.counter.found().size() == 1);
    CHECK(it.counter.found()[0].angle == doctest::Approx(20.0).epsilon(1e-12));
  }
}

TEST_CASE("turns are counted between as many frames as there are") {
  Rotor it;
  for (int k = 0; k <= 60000; ++k) it.pass(k / 4.0, 0.4 * pi * k, 1.6 * pi, k % 4 == 0);
  CHECK(it.counter.found().size() == 15000);
}
