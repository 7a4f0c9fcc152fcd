#include "linkwork/integration/driven_motion.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

constexpr double amplitude = 0.8, frequency = 3.0, arm = 0.5;  // rad, rad/s, m

/// A rod on a hinge about z, whose angle is amplitude sin(frequency t); its weight acts along z.
Model driven_rod() {
  Model model;
  model.add_body("rod", body_at({arm, 0, 0}));
  join(model, "revolute", "hinge", ground, 0, {0, 0, 0});
  const Element& hinge = model.joints()[0];
  model.add_joint("angle_driver", "motor", ground, 0, hinge.at,
                  {{0.0, model.add_signal(harmonic(amplitude, frequency, 0.0, 0.0))}});
  return model;
}

struct Driven {
  Dynamics dynamics{driven_rod(), {}};
  DrivenMotion motion{dynamics, arm, VectorXd::Ones(6), 1e-14, 0.1, {}};
};

}  // namespace

TEST_CASE("a driven rod moves, and is driven, as its driver says") {
  Driven it;
  REQUIRE(it.motion.start(it.dynamics.system().model().initial_q(), it.dynamics.history()));
  const std::vector<double> times = {0.0, 0.1, 0.25, 0.6, 1.3};
  const DrivenFrames frames = it.motion.follow(times, 1e9);
  REQUIRE(frames.count == 5);
  for (std::size_t n = 0; n < times.size(); ++n) {
    const double phase = frequency * times[n];
    const double angle = amplitude * std::sin(phase), rate = amplitude * frequency * std::cos(phase);
    const double acceleration = -amplitude * frequency * frequency * std::sin(phase);
    CHECK(frames.t[n] == times[n]);
    CHECK(2.0 * std::atan2(frames.q[7 * n + 6], frames.q[7 * n + 3]) == doctest::Approx(angle).epsilon(1e-12));
    CHECK(std::abs(frames.q[7 * n + 1] - arm * std::sin(angle)) < 1e-13);
    CHECK(frames.v[6 * n + 5] == doctest::Approx(rate).epsilon(1e-12));
    CHECK(std::abs(frames.v_dot[6 * n + 5] - acceleration) < 1e-11);
    // Unit inertia about the center of mass, and 1 kg at the arm.
    CHECK(std::abs(std::abs(frames.lambda[6 * n + 5]) - std::abs((1.0 + arm * arm) * acceleration)) < 1e-10);
    for (int level = 0; level < 3; ++level) CHECK(frames.violation[3 * n + level] < 1e-11);
  }
}

TEST_CASE("a motion that is taken up where another one was goes on with its frames") {
  Driven whole, part;
  const VectorXd q = whole.dynamics.system().model().initial_q();
  REQUIRE(whole.motion.start(q, whole.dynamics.history()));
  REQUIRE(whole.motion.follow({0.2}, 1e9).count == 1);
  const DrivenState state = whole.motion.state();
  REQUIRE(part.motion.begin(state.t, state.q, state.v, state.v_dot, state.history));
  const DrivenFrames on = whole.motion.follow({0.3}, 1e9), again = part.motion.follow({0.3}, 1e9);
  REQUIRE(on.count == 1);
  REQUIRE(again.count == 1);
  for (std::size_t k = 0; k < on.q.size(); ++k) CHECK(std::abs(on.q[k] - again.q[k]) < 1e-13);
}

TEST_CASE("a motion that pauses on the way to a frame goes on to it") {
  Driven it;
  REQUIRE(it.motion.start(it.dynamics.system().model().initial_q(), it.dynamics.history()));
  int pauses = 0;
  DrivenFrames found = it.motion.follow({1.3}, 0.0);
  for (; found.count == 0; ++pauses) {
    REQUIRE(found.paused);
    found = it.motion.follow({1.3}, 0.0);
  }
  CHECK(pauses > 3);
  const double angle = amplitude * std::sin(frequency * 1.3);
  CHECK(2.0 * std::atan2(found.q[6], found.q[3]) == doctest::Approx(angle).epsilon(1e-12));
}

TEST_CASE("a pose that cannot be brought onto its joints is no start") {
  Driven it;
  VectorXd q = it.dynamics.system().model().initial_q();
  q[0] = NAN;
  CHECK(!it.motion.start(q, it.dynamics.history()));
}
