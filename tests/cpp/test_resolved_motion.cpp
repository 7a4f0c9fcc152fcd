#include "linkwork/integration/resolved_motion.hpp"

#include "mechanisms.hpp"

using namespace support;

TEST_CASE("a motion away from poses is that of one long step") {
  Dynamics dynamics(parallelogram(0.6, 1.0), {});
  CollocationStep step(dynamics, 1.0);
  const Unwatched unwatched(dynamics);
  REQUIRE(step.begin(0.0, dynamics.initial_y(), true));
  REQUIRE(step.attempt(0.1).good());
  ResolvedMotion motion(dynamics, step);
  REQUIRE(motion.follow(0.0, dynamics.initial_y(), 0.1));
  CHECK((motion.y() - step.leap().y_new).cwiseAbs().maxCoeff() < 1e-6);
  CHECK(motion.nearest_t() == 0.0);
}

TEST_CASE("a pose in the way is not gone over, but come to") {
  const double from = -0.05, rate = 2.0;
  Dynamics dynamics(parallelogram(from, rate), {});
  CollocationStep step(dynamics, 1.0);
  ResolvedMotion motion(dynamics, step);
  CHECK(!motion.follow(0.0, dynamics.initial_y(), -2.0 * from / rate));
  CHECK(motion.in_pose());
  CHECK(2.0 * std::atan2(motion.nearest_y()[6], motion.nearest_y()[3]) == doctest::Approx(0.0).epsilon(1e-5));
}
