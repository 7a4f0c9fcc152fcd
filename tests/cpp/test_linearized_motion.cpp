#include "linkwork/integration/linearized_motion.hpp"

#include "swinging_rod.hpp"

using namespace linkwork;
using namespace support::swinging_rod;

namespace {

const VectorXd one = VectorXd::Ones(1), none;

}  // namespace

TEST_CASE("what an error makes of accelerations is the derivative of the equation of the pendulum") {
  for (const double angle : {0.0, 0.7, 2.0, M_PI}) {
    Dynamics dynamics(pendulum(), Options());
    LinearizedMotion motion(dynamics, one, one);
    motion.afford(100);
    REQUIRE(motion.go_to(0.0, state(angle, 1.5), none));
    auto error = motion.error({0.0, state(angle + 1e-6, 1.5), state(angle, 1.5)});
    REQUIRE(error);
    CHECK(error->way[4] == doctest::Approx(1e-6).epsilon(1e-6));
    CHECK(error->acceleration[4] == doctest::Approx(-1e-6 * pace * pace * std::cos(angle)).epsilon(1e-5));
  }
}

TEST_CASE("of an error it keeps what the joints allow") {
  Dynamics dynamics(pendulum(), Options());
  LinearizedMotion motion(dynamics, one, one);
  motion.afford(100);
  REQUIRE(motion.go_to(0.0, state(0.3, 0.0), none));
  VectorXd off = state(0.3, 0.0);
  off[1] += 1e-6;  // along the hinge
  off[8] += 1e-5;
  off += state(0.3 + 1e-6, 0.0) - state(0.3, 0.0);
  const auto error = motion.error({0.0, off, state(0.3, 0.0)});
  REQUIRE(error);
  CHECK(std::abs(error->way[1]) < 1e-12);
  CHECK(std::abs(error->velocity[1]) < 1e-11);
  CHECK(error->way[4] == doctest::Approx(1e-6).epsilon(1e-4));
  CHECK(error->first[0] == doctest::Approx(1e-5 / 4).epsilon(0.02));
}

TEST_CASE("what steps leave of energy and of the joints is taken back") {
  Dynamics dynamics(pendulum(), Options());
  LinearizedMotion motion(dynamics, one, one);
  motion.afford(100);
  REQUIRE(motion.go_to(0.0, state(0.3, 2.0), none));
  auto error = motion.error({0.0, state(0.3 + 1e-6, 2.0), state(0.3, 2.0)});
  REQUIRE(error);
  const Perturbation before = *error;
  error->velocity += 1e-7 * state(0.3, 2.0).segment<6>(7);  // along the motion: of energy
  error->way[1] += 1e-8;
  REQUIRE(motion.find_acceleration(*error));
  motion.take_back(*error);
  CHECK(std::abs(error->way[1]) < 1e-13);
  CHECK((error->velocity - before.velocity).norm() < 1e-11);
}

TEST_CASE("next to rest, where differences of energies are rounding, they change nothing") {
  for (const double rate : {1e-7, 1e-9, 1e-11}) {
    Dynamics dynamics(pendulum(), Options());
    LinearizedMotion motion(dynamics, one, one);
    motion.afford(100);
    REQUIRE(motion.go_to(0.0, state(M_PI - 1.0, rate), none));
    auto error = motion.error({0.0, state(M_PI - 1.0 + 1e-6, rate), state(M_PI - 1.0, rate)});
    REQUIRE(error);
    const VectorXd before = error->velocity;
    error->way[2] += 1e-15;  // as much as differences of evaluations leave
    REQUIRE(motion.find_acceleration(*error));
    motion.take_back(*error);
    CHECK((error->velocity - before).norm() < 1e-9);
  }
}

TEST_CASE("it ends where evaluations do, and goes back without any") {
  Dynamics dynamics(pendulum(), Options());
  LinearizedMotion motion(dynamics, one, one);
  motion.afford(2);
  CHECK(motion.go_to(0.0, state(0.3, 0.0), none));
  const LinearizedMotion::Place place = motion.place();
  CHECK(motion.go_to(0.1, state(0.4, 0.0), none));
  CHECK(!motion.go_to(0.2, state(0.5, 0.0), none));
  motion.go_back_to(place);
  CHECK(motion.here().t == 0.0);
  CHECK(motion.here().y == state(0.3, 0.0));
}

TEST_CASE("Euler parameters of either sign are the same error") {
  for (const double sign : {1.0, -1.0}) {
    Dynamics dynamics(pendulum(), Options());
    LinearizedMotion motion(dynamics, one, one);
    motion.afford(100);
    REQUIRE(motion.go_to(0.0, state(0.3, 0.0), none));
    VectorXd off = state(0.3 + 1e-6, 0.0);
    off.segment<4>(3) *= sign;
    const auto error = motion.error({0.0, off, state(0.3, 0.0)});
    REQUIRE(error);
    CHECK(error->way[4] == doctest::Approx(1e-6).epsilon(1e-4));
    CHECK(error->way[0] == doctest::Approx(-arm * std::cos(0.3) * 1e-6).epsilon(1e-4));
  }
}
