#include "linkwork/integration/state_log.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr std::size_t most = 4096;

/// One body that turns by so much from one state to the next [rad].
VectorXd turned(double angle) {
  VectorXd y = VectorXd::Zero(14);
  y[3] = std::cos(angle / 2.0);
  y[4] = std::sin(angle / 2.0);
  y[10] = 1.0;
  return y;
}

StateLog log_of(std::size_t states, double angle) {
  StateLog log(1, 2);
  for (std::size_t k = 0; k < states; ++k) {
    const auto number = static_cast<double>(k);
    log.add(number, turned(number * angle), VectorXd::Constant(2, number));
  }
  return log;
}

/// The most steps from one state to the next.
double longest(const StateLog& log) {
  double out = 0.0;
  for (std::size_t k = 1; k < log.size(); ++k) out = std::max(out, log.t(k) - log.t(k - 1));
  return out;
}

/// Whether there is one at that time, number k.
bool has(const StateLog& log, double t) {
  for (std::size_t k = 0; k < log.size(); ++k)
    if (log.t(k) == t) return true;
  return false;
}

}  // namespace

TEST_CASE("a log of few states has all of them") {
  const StateLog log = log_of(100, 0.1);
  REQUIRE(log.size() == 100);
  CHECK(log.t(99) == 99.0);
  CHECK(log.y(37) == turned(3.7));
  CHECK(log.history(37) == VectorXd::Constant(2, 37.0));
}

TEST_CASE("of many that are near each other it has every so many, to the end") {
  const std::size_t states = 10 * most;
  const StateLog log = log_of(states, 1e-4);
  CHECK(log.size() <= most);
  CHECK(log.size() > most / 2);
  CHECK(longest(log) <= 16.0);
  for (std::size_t k = 0; k < log.size(); ++k) {
    REQUIRE(log.y(k) == turned(1e-4 * log.t(k)));
    REQUIRE(log.history(k)[1] == log.t(k));
  }
  CHECK(log.t(log.size() - 1) >= static_cast<double>(states) - 16.0);
}

TEST_CASE("of many it has all in which something touches, and those before and after") {
  const std::size_t states = 10 * most;
  StateLog log(1, 0);
  const auto touching = [](std::size_t k) { return k % 997 < 10; };
  for (std::size_t k = 0; k < states; ++k)
    log.add(static_cast<double>(k), turned(1e-4 * static_cast<double>(k)), VectorXd(), touching(k));
  CHECK(longest(log) <= 16.0);
  std::size_t found = 0, about = 0;
  for (std::size_t k = 0; k < log.size(); ++k) {
    found += touching(static_cast<std::size_t>(log.t(k))) ? 1 : 0;
    about += log.touches_about(k) ? 1 : 0;
  }
  CHECK(found == 10 * (states / 997) + std::min<std::size_t>(states % 997, 10));
  for (std::size_t k = 997; k < states; k += 997)
    REQUIRE(has(log, static_cast<double>(k - 1)));  // there it has not begun yet
  CHECK(about > found);
  CHECK(about < 13 * (states / 997 + 1));
}

TEST_CASE("where something touches all the time, as where it rests, it has every so many likewise") {
  StateLog log(1, 0);
  for (std::size_t k = 0; k < 10 * most; ++k)
    log.add(static_cast<double>(k), turned(1e-4 * static_cast<double>(k)), VectorXd(), true);
  CHECK(log.size() > most / 4);
  CHECK(log.t(log.size() - 1) >= static_cast<double>(10 * most) - 1.0);
}

TEST_CASE("of many it has those where a velocity changes by much, however soon it comes back") {
  const std::size_t states = 10 * most;
  StateLog log(1, 0);
  for (std::size_t k = 0; k < states; ++k) {
    VectorXd y = turned(0.0);
    y[7] = std::sin(1e-3 * static_cast<double>(k)) + (k % 997 == 500 ? 1.0 : 0.0);
    log.add(static_cast<double>(k), y, VectorXd());
  }
  for (std::size_t k = 500; k < states; k += 997) {
    CHECK(has(log, static_cast<double>(k)));
    CHECK(has(log, static_cast<double>(k + 1)));
  }
  CHECK(log.t(log.size() - 1) >= static_cast<double>(states) - 32.0);
}

TEST_CASE("of many that are far from each other it has the first ones, as those left would be too far") {
  const StateLog log = log_of(3 * most, 0.2);
  REQUIRE(log.size() == most);
  CHECK(log.t(most - 1) == static_cast<double>(most - 1));
}

TEST_CASE("Euler parameters that change their signs are those nearer to the state before") {
  StateLog log(1, 0);
  for (int k = 0; k < 60; ++k) {
    VectorXd y = turned(0.2 * k);
    if (k % 3 == 1) y.segment<4>(3) *= -1.0;
    log.add(k, y, VectorXd());
  }
  for (std::size_t k = 0; k < 60; ++k) CHECK(log.y(k) == turned(0.2 * static_cast<double>(k)));
}

TEST_CASE("a log that has ended, and one of a large model, take nothing") {
  StateLog log = log_of(5, 0.1);
  log.end();
  log.add(5.0, turned(0.5), VectorXd::Zero(2));
  CHECK(log.size() == 5);
  const int bodies = 10'000;
  StateLog large(bodies, 0);
  large.add(0.0, VectorXd::Zero(13 * bodies + 1), VectorXd());
  CHECK(large.size() == 0);
}
