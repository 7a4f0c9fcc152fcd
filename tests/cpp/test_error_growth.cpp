#include "linkwork/integration/error_growth.hpp"

#include "swinging_rod.hpp"

using namespace linkwork;
using namespace support::swinging_rod;

namespace {

template <class Motion>
StateLog log_of(double t_end, int states, Motion motion) {
  StateLog log(1, 0);
  for (int k = 0; k <= states; ++k) log.add(t_end * k / states, motion(t_end * k / states), VectorXd());
  return log;
}

/// Of an angle that was off at the start, with lengths and speeds that say the same of angles and rates.
std::vector<ErrorGrowth> growth(const Model& model, const StateLog& log, const VectorXd& off, const VectorXd& exact,
                                double of_rate, std::int64_t most = 100'000) {
  Dynamics dynamics(model, Options());
  const auto errors = [&](std::size_t, double) { return std::vector<StepDifference>{{0.0, off, exact}}; };
  return find_error_growth(dynamics, log, errors, MovingAxes(), VectorXd::Ones(1), VectorXd::Constant(1, of_rate),
                           most);
}

}  // namespace

TEST_CASE("beside an upright pendulum an angle grows by its hyperbolic cosine, however far apart states are known") {
  const auto upright = [](double) { return state(M_PI, 0.0); };
  for (const int states : {4, 40, 400}) {
    const double t_end = 3.0;
    const auto found = growth(pendulum(), log_of(t_end, states, upright), state(M_PI + 1e-6, 0.0), upright(0), pace);
    REQUIRE(found.size() == 1);
    CHECK(found[0].until == doctest::Approx(t_end));
    CHECK(found[0].of_part[0] == doctest::Approx(std::cosh(pace * t_end)).epsilon(0.02));
  }
}

TEST_CASE("below it comes and goes") {
  const auto below = [](double) { return state(0.0, 0.0); };
  const auto found = growth(pendulum(), log_of(50.0, 2000, below), state(1e-6, 0.0), below(0.0), pace);
  CHECK(found[0].of_part[0] == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("without forces an error of the rate makes one of the angle in proportion to time") {
  const auto turning = [](double t) { return state(2.0 * t, 2.0); };
  const auto found =
      growth(pendulum(Vec3<double>::Zero()), log_of(9.0, 300, turning), state(0.0, 2.0 + 1e-6), state(0.0, 2.0), 2.0);
  CHECK(found[0].of_part[0] == doctest::Approx(2.0 * 9.0).epsilon(0.01));  // of the rate it was 1 / 2 of the speed
}

TEST_CASE("what misses the equations of the joints is taken back, and does not grow") {
  const auto below = [](double) { return state(0.0, 0.0); };
  VectorXd off = state(1e-6, 0.0);
  off[1] += 1e-6;  // along the hinge
  off[9] += 1e-4;  // against it
  const auto found = growth(pendulum(), log_of(50.0, 2000, below), off, below(0.0), pace);
  CHECK(found[0].of_part[0] == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("with few evaluations it is followed as far as these go") {
  const auto turning = [](double t) { return state(2.0 * t, 2.0); };
  const auto found = growth(pendulum(Vec3<double>::Zero()), log_of(9.0, 300, turning), state(0.0, 2.0 + 1e-6),
                            state(0.0, 2.0), 2.0, 200);
  REQUIRE(found.size() == 1);
  CHECK(found[0].until > 0.5);
  CHECK(found[0].until < 8.0);
  CHECK(found[0].of_part[0] == doctest::Approx(2.0 * found[0].until).epsilon(0.1));
}

TEST_CASE("however few evaluations there are, it ends where they do") {
  const auto turning = [](double t) { return state(2.0 * t, 2.0); };
  const StateLog log = log_of(9.0, 300, turning);
  Dynamics dynamics(pendulum(), Options());
  const auto errors = [&](std::size_t, double) {
    return std::vector<StepDifference>{{0.0, state(0.0, 2.0 + 1e-6), state(0.0, 2.0)},
                                       {1.0, state(2.0, 2.0 + 1e-6), state(2.0, 2.0)}};
  };
  for (std::int64_t most = 1; most < 60; ++most)
    for (const ErrorGrowth& it :
         find_error_growth(dynamics, log, errors, MovingAxes(), VectorXd::Ones(1), VectorXd::Constant(1, 2.0), most))
      CHECK(it.of_part[0] >= 1.0);
}

TEST_CASE("of one state, and where there is no error, nothing grows") {
  const auto below = [](double) { return state(0.0, 0.0); };
  CHECK(growth(pendulum(), log_of(0.0, 0, below), state(1e-6, 0.0), below(0.0), pace).empty());
  CHECK(growth(pendulum(), log_of(1.0, 9, below), below(0.0), below(0.0), pace).empty());
}
