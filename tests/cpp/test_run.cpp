#include "linkwork/integration/run.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// The slider off its rail by 2e-2 m at most and 0.5 m/s, with limits of its violation.
Options limited(const std::string& policy, double position, double velocity) {
  Options options = unstabilized();
  options.violation_limit = {position, velocity, INFINITY};
  options.on_violation = policy;
  return options;
}

}  // namespace

TEST_CASE("a violation beyond its limit ends the run with an error that names the joint, the limit and the time") {
  try {
    run(displaced_slider(), make_runge_kutta(rk4()), {0.1, 0.01, 1}, limited("stop", 1e-3, INFINITY));
    FAIL("no error");
  } catch (const ViolationError& error) {
    CHECK(error.details.joints == std::vector<std::string>{"rail"});
    CHECK(error.details.residuals.front().second >= 2e-2);
    CHECK(error.details.time <= 0.01);
  }
}

TEST_CASE("projection beyond a limit takes the state back once, and a run that is good is left alone") {
  for (const double limit : {1e-3, 1.0}) {
    Dynamics dynamics(displaced_slider(), limited("project", limit, limit));
    Simulation simulation(dynamics, make_runge_kutta(rk4()), {0.1, 0.01, 1});
    const Frames frames = simulation.advance(1 << 30, 1e9);
    CHECK(simulation.projections() == (limit < 0.5 ? 1 : 0));
    CHECK((frames.violation[frames.violation.size() - 3] < 1e-12) == (limit < 0.5));
  }
}

TEST_CASE("a run that begins where another ended takes its steps, to the last bit") {
  const Model model = spherical_pendulum();
  const Frames whole = run(model, make_runge_kutta(rk4()), {2.0, 0.01, 200});
  const Frames first = run(model, make_runge_kutta(rk4()), {1.0, 0.01, 100});
  VectorXd state(13);
  state << last(first.q, 7), last(first.v, 6);
  const Frames second = run(model, make_runge_kutta(rk4()), {2.0, 0.01, 100, 1.0, state});
  CHECK(second.t.front() == 1.0);
  CHECK((last(second.q, 7) - last(whole.q, 7)).norm() == 0.0);
  CHECK((last(second.v, 6) - last(whole.v, 6)).norm() == 0.0);
}

TEST_CASE("a start that cannot be is refused") {
  const Model model = free_body();
  const auto code = [&](double t, const VectorXd& state) {
    return error_code([&] { run(model, make_runge_kutta(rk4()), {1.0, 0.1, 1, t, state}); });
  };
  VectorXd state(13);
  state << model.initial_q(), model.initial_v();
  CHECK(code(0.5, state) == "none");
  CHECK(code(1.5, state) == "start");
  CHECK(code(NAN, state) == "start");
  CHECK(code(0.5, state.head(12)) == "start");
  VectorXd undefined = state;
  undefined[0] = NAN;
  CHECK(code(0.5, undefined) == "start");
  VectorXd stretched = state;
  stretched.segment<4>(3) *= 1.001;
  CHECK(code(0.5, stretched) == "start");
}

TEST_CASE("an error that leaves a step says when it was, unless a stage knew better") {
  for (const double known : {double(NAN), 3.5}) {
    try {
      with_time(3.0, 0.1, [&] {
        ErrorDetails details;
        details.time = known;
        throw NotFiniteError("test", "test", details);
      });
      FAIL("no error");
    } catch (const NotFiniteError& error) {
      CHECK(error.details.time == (std::isnan(known) ? 3.0 : 3.5));
      CHECK(error.details.step == 0.1);
    }
  }
}
