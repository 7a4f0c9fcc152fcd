#include "linkwork/integration/error_growth.hpp"

#include "linkwork/assembly/connected_components.hpp"
#include "mechanisms.hpp"
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

TEST_CASE("with few evaluations it is followed to the end by five times as many, or as far as these go") {
  const auto turning = [](double t) { return state(2.0 * t, 2.0); };
  const auto found = [&](std::int64_t most) {
    return growth(pendulum(Vec3<double>::Zero()), log_of(9.0, 300, turning), state(0.0, 2.0 + 1e-6), state(0.0, 2.0),
                  2.0, most);
  };
  REQUIRE(found(200).size() == 1);
  CHECK(found(200)[0].until == doctest::Approx(9.0));
  REQUIRE(found(40).size() == 1);
  CHECK(found(40)[0].until > 0.5);
  CHECK(found(40)[0].until < 8.0);
  CHECK(found(40)[0].of_part[0] == doctest::Approx(2.0 * found(40)[0].until).epsilon(0.1));
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

TEST_CASE("an error is lost where nothing is known of the motion, and grows beyond as one that begins there") {
  const double t_end = 3.0, again = 2.0;
  const auto upright = [](double t) { return std::abs(t - 1.05) < 0.01 ? state(NAN, NAN) : state(M_PI, 0.0); };
  const StateLog log = log_of(t_end, 60, upright);
  Dynamics dynamics(pendulum(), Options());
  const VectorXd off = state(M_PI + 1e-6, 0.0), exact = state(M_PI, 0.0);
  const auto errors = [&](std::size_t, double) {
    return std::vector<StepDifference>{{0.0, off, exact}, {1.05, off, exact}, {again, off, exact}};
  };
  const auto found =
      find_error_growth(dynamics, log, errors, MovingAxes(), VectorXd::Ones(1), VectorXd::Constant(1, pace), 100'000);
  REQUIRE(found.size() == 2);
  CHECK(found[0].lost);
  CHECK(found[0].until == doctest::Approx(1.0));
  CHECK(!found[1].lost);
  CHECK(found[1].until == doctest::Approx(t_end));
  const double after = std::cosh(pace * (t_end - again));
  CHECK(found[1].of_part[0] == doctest::Approx(after).epsilon(0.02));
  CHECK(found[0].of_part[0] == doctest::Approx(std::cosh(pace * found[0].until) * after).epsilon(0.02));
}

TEST_CASE("what is lost where it begins is not taken for known to the end") {
  const auto upright = [](double t) {
    return std::abs(t - 1.05) < 0.01 || std::abs(t - 1.35) < 0.01 ? state(NAN, NAN) : state(M_PI, 0.0);
  };
  const StateLog log = log_of(3.0, 60, upright);
  Dynamics dynamics(pendulum(), Options());
  const VectorXd off = state(M_PI + 1e-6, 0.0), exact = state(M_PI, 0.0);
  const auto errors = [&](std::size_t, double) {
    return std::vector<StepDifference>{
        {1.0, off, exact}, {1.05, off, exact}, {1.3, off, exact}, {1.35, off, exact}, {2.0, off, exact}};
  };
  const auto found =
      find_error_growth(dynamics, log, errors, MovingAxes(), VectorXd::Ones(1), VectorXd::Constant(1, pace), 100'000);
  REQUIRE(found.size() == 3);
  for (int k : {0, 1}) {
    CHECK(found[k].lost);
    CHECK(found[k].until == doctest::Approx(found[k].t));
    CHECK(found[k].of_part[0] == doctest::Approx(found[2].of_part[0]).epsilon(1e-3));
  }
  CHECK(found[2].until == doctest::Approx(3.0));
}

TEST_CASE("of one state, and where there is no error, nothing grows") {
  const auto below = [](double) { return state(0.0, 0.0); };
  CHECK(growth(pendulum(), log_of(0.0, 0, below), state(1e-6, 0.0), below(0.0), pace).empty());
  CHECK(growth(pendulum(), log_of(1.0, 9, below), below(0.0), below(0.0), pace).empty());
}

namespace {

constexpr double speed = 1.0, gap = 0.1, ball = 0.01, stiffness = 1e6;  // of support::two_balls, of 1 kg

double push(double distance) { return stiffness * std::pow(std::max(2.0 * ball - distance, 0.0), 1.5); }

/// Two balls meet head on: what lies between them, its rate, and by how much one that passes beside is off, with its
/// rate, relative to that at the start. F acts on both, so that twice the acceleration of each counts.
struct Meeting {
  double t = 0.0, between = gap, rate = -speed, aside = 1.0, aside_rate = 0.0;

  void go_on(double h, int steps) {
    for (int k = 0; k < steps; ++k) {
      const double half = between + 0.5 * h / steps * rate, force = 2.0 * push(half);
      rate += h / steps * force;
      const double aside_half = aside + 0.5 * h / steps * aside_rate;
      aside_rate += h / steps * force / half * aside_half;
      between = half + 0.5 * h / steps * rate;
      aside = aside_half + 0.5 * h / steps * aside_rate;
    }
    t += h;
  }
  /// In the order of a state; the middle of both moves at half of the speed.
  VectorXd y() const {
    VectorXd out = VectorXd::Zero(27);
    const double middle = 0.5 * (gap + speed * t);
    out[0] = middle - 0.5 * between, out[7] = middle + 0.5 * between;
    out[3] = out[10] = 1.0;
    out[14] = 0.5 * (speed - rate), out[20] = 0.5 * (speed + rate);
    return out;
  }
};

}  // namespace

TEST_CASE("balls that meet head on part at more than twice the angle by which they touch beside it") {
  const Model model = support::two_balls(speed, {gap, 0, 0});
  Dynamics dynamics(model, Options());
  const Eigen::Index contacts = dynamics.system().history_size();
  for (const double h : {2e-4, 1e-3}) {
    Meeting motion;
    StateLog log(2, contacts);
    double largest = 1.0;
    while (motion.t < 0.2) {
      const bool touches = motion.between < 2.0 * ball;
      log.add(motion.t, motion.y(), VectorXd::Constant(contacts, touches ? speed : 0.0), touches);
      motion.go_on(touches || motion.between + h * motion.rate < 2.0 * ball ? h / 10.0 : h, 1000);
      largest = std::max({largest, 0.5 * (1.0 + motion.aside), 0.5 * motion.aside_rate / speed});
    }
    VectorXd off = Meeting().y();
    off[1] += 1e-9;
    const auto errors = [&](std::size_t, double) { return std::vector<StepDifference>{{0.0, off, Meeting().y()}}; };
    const auto parts = ConnectedParts::of(dynamics.system()).count();
    const auto found = find_error_growth(dynamics, log, errors, MovingAxes(), VectorXd::Ones(parts),
                                         VectorXd::Constant(parts, speed), 100'000);
    REQUIRE(found.size() == 1);
    CHECK(motion.aside_rate > 2.0 * speed / (2.0 * ball));  // as much of hard ones
    CHECK(found[0].until > 0.19);
    CHECK(found[0].of_part.maxCoeff() == doctest::Approx(largest).epsilon(0.03));
  }
}
