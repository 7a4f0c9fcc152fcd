#include "linkwork/integration/events.hpp"

#include "integrators.hpp"
#include "linkwork/integration/adaptive_simulation.hpp"

using namespace support;

TEST_CASE("events are known however a run is cut into pieces") {
  const auto occurrences = [](double max_seconds) {
    AdaptiveSchedule schedule;
    schedule.t_end = 2.0;
    schedule.record_every = 1;
    Event event;
    event.name = "turn";
    event.function = [](double t, const VectorXd&) { return std::sin(10.0 * t + 1.0); };
    event.change = [](double, const VectorXd& y) {
      Changed changed{y, false};
      changed.y.tail<6>() *= -1.0;
      return changed;
    };
    Dynamics dynamics(spherical_pendulum(), {});
    AdaptiveSimulation simulation(dynamics, bs32(), schedule, {event});
    std::vector<double> found;
    while (!simulation.finished()) {
      simulation.advance(1 << 30, max_seconds);
      for (const Occurrence& it : simulation.take_occurrences()) {
        CHECK((it.before.tail<6>() + it.after.tail<6>()).norm() < 1e-6 * it.before.tail<6>().norm());
        found.push_back(it.t);
      }
    }
    return found;
  };
  const std::vector<double> whole = occurrences(1e9);
  CHECK(whole.size() == 6);  // (k pi - 1) / 10
  CHECK(occurrences(0.0) == whole);
}

namespace {

/// A step along a straight line of states.
struct Line final : Interpolant {
  VectorXd from, to;
  void interpolate(const System&, double theta, VectorXd& y) const override { y = from + theta * (to - from); }
};

/// One free body, whose place (x, y, z) and velocity are given; with the place where an event of `what` would come.
struct Ball {
  Dynamics dynamics{free_body(), {}};
  const System& system = dynamics.system();

  VectorXd state(const Vec3<double>& place, const Vec3<double>& velocity = Vec3<double>::Zero()) const {
    VectorXd y = dynamics.initial_y();
    y.head<3>() = place;
    y.segment<6>(7) << velocity, 0.0, 0.0, 0.0;
    return y;
  }
  Line line(const Vec3<double>& from, const Vec3<double>& to) const {
    Line out;
    out.from = state(from);
    out.to = state(to);
    return out;
  }
};

/// When a component of the place passes through a value.
Event through(int component, double value, int direction = 0, bool terminal = false) {
  Event event;
  event.name = "through";
  event.function = [=](double, const VectorXd& y) { return y[component] - value; };
  event.direction = direction;
  event.terminal = terminal;
  return event;
}

}  // namespace

TEST_CASE("an event that makes no sense is refused") {
  const auto code = [](const Event& event) { return error_code([&] { EventWatch watch({event}); }); };
  Event event = through(0, 0.0);
  CHECK(code(event) == "none");
  event.direction = 2;
  CHECK(code(event) == "event");
  event = through(0, 0.0);
  event.tolerance = -1.0;
  CHECK(code(event) == "event");
  event = through(0, 0.0);
  event.function = {};
  CHECK(code(event) == "event");
}

TEST_CASE("an event is found at its place in the step, on the side that comes after it, if it goes in its direction") {
  const Ball ball;
  const Line step = ball.line({-1, 0, 0}, {3, 0, 0});
  for (const int direction : {-1, 0, 1}) {
    EventWatch watch({through(0, 0.2, direction)});
    watch.start(ball.system, 0.0, step.from);
    const auto& found = watch.scan(step, ball.system, 0.0, 2.0);
    if (direction < 0) {
      CHECK(found.empty());
      continue;
    }
    REQUIRE(found.size() == 1);
    CHECK(found[0].theta == doctest::Approx(0.3).epsilon(1e-12));
    CHECK(found[0].side == 1.0);
  }
}

TEST_CASE("events come in order of time, and none after the one that ends the step") {
  const Ball ball;
  const Line step = ball.line({0, 0, 0}, {1, 2, 4});
  EventWatch watch({through(0, 0.9), through(1, 0.8, 0, true), through(2, 1.2), through(0, 0.6, 0, true)});
  watch.start(ball.system, 0.0, step.from);
  const auto& found = watch.scan(step, ball.system, 0.0, 1.0);
  REQUIRE(found.size() == 2);
  CHECK(found[0].event == 2);  // at 0.3
  CHECK(found[1].event == 1);  // at 0.4
}

TEST_CASE("events that differ in their times by no more than these are known come together") {
  const Ball ball;
  const Line step = ball.line({0, 0, 0}, {1, 2, 4});
  EventWatch watch({through(1, 0.8), through(0, 0.4 + 1e-14, 0, true), through(2, 1.6 + 1e-9), through(2, 1.6, 0, true),
                    through(0, 0.4)});
  watch.start(ball.system, 0.0, step.from);
  std::vector<std::size_t> came;
  for (const auto& found : watch.scan(step, ball.system, 0.0, 1.0)) came.push_back(found.event);
  CHECK(came == std::vector<std::size_t>{1, 3, 0, 4});
}

TEST_CASE("each of several barriers at a time holds") {
  const Ball ball;
  const Vec3<double> down(-1, -1, 0), rest(0, 0, 0);
  EventWatch watch({through(0, 0.0, 0, true), through(1, 0.0, 0, true)});
  const Line fall = ball.line({1, 1, 0}, {-1, -1, 0}), on = ball.line({0, 0, 0}, {-1e-3, -1e-3, 0});
  watch.start(ball.system, 0.0, fall.from);
  const std::vector<EventWatch::Found> happened = watch.scan(fall, ball.system, 0.0, 2.0);
  REQUIRE(happened.size() == 2);
  watch.restart(ball.system, 1.0, ball.state({0, 0, 0}, down), ball.state({0, 0, 0}, rest), happened);
  CHECK(watch.scan(on, ball.system, 1.0, 1.0).size() == 2);
}

TEST_CASE("a function that is zero at the start has no sign until it leaves zero") {
  const Ball ball;
  EventWatch watch({through(0, 0.0)});
  const Line away = ball.line({0, 0, 0}, {1, 0, 0}), back = ball.line({1, 0, 0}, {-1, 0, 0});
  watch.start(ball.system, 0.0, away.from);
  CHECK(watch.scan(away, ball.system, 0.0, 1.0).empty());
  const auto& found = watch.scan(back, ball.system, 1.0, 1.0);
  REQUIRE(found.size() == 1);
  CHECK(found[0].theta == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(found[0].side == -1.0);
}

TEST_CASE("after a barrier to be on the other side is the same event again, after a passage it is none") {
  const Ball ball;
  const Vec3<double> down(-1, 0, 0), rest(0, 0, 0);
  for (const bool barrier : {false, true}) {
    EventWatch watch({through(0, 0.0, 0, true)});
    const Line fall = ball.line({1, 0, 0}, {-1, 0, 0}), on = ball.line({0, 0, 0}, {-1e-3, 0, 0});
    watch.start(ball.system, 0.0, fall.from);
    const EventWatch::Found happened = watch.scan(fall, ball.system, 0.0, 2.0).front();
    watch.restart(ball.system, 1.0, ball.state({0, 0, 0}, down), ball.state({0, 0, 0}, barrier ? rest : down),
                  {happened});
    const auto& found = watch.scan(on, ball.system, 1.0, 1.0);
    CHECK(found.size() == (barrier ? 1 : 0));
    if (barrier) CHECK(found[0].theta < 1e-6);
  }
}

TEST_CASE("a function that is not a number is an error that names the event") {
  Event event = through(0, 0.0);
  event.function = [](double, const VectorXd&) { return NAN; };
  const Ball ball;
  EventWatch watch({event});
  CHECK_THROWS_WITH_AS(watch.start(ball.system, 0.0, ball.state({0, 0, 0})), doctest::Contains("'through'"),
                       OptionError);
}
