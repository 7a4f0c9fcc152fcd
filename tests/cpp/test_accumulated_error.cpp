#include "linkwork/integration/accumulated_error.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double size = 2.0, speed = 10.0;  // m, m/s

/// Two parts of a run, of a second and 100 steps each, with one step that is known of each.
RunErrors run(const StateDifference& in_first, const StateDifference& in_second, double first_speed = speed) {
  RunErrors out;
  out.diagonal = 2.0 * size;
  for (int k = 0; k < 2; ++k) {
    RunPart part;
    part.steps = 100;
    part.t = k;
    part.seconds = 1.0;
    part.sum_of_changes = 100.0;
    out.parts.push_back(part);
    StepError step;
    step.t = k + 0.5;
    step.h = 0.01;
    step.change = 1.0;
    step.speed = k == 0 ? first_speed : speed;
    step.end = k == 0 ? in_first : in_second;
    step.force = NAN;
    out.steps.push_back(step);
    out.part_of.push_back(k);
  }
  return out;
}

double state(const RunErrors& errors) { return accumulate(errors, 0.1).state; }

}  // namespace

TEST_CASE("errors of poses add up over all steps, relative to the size of the motion") {
  StateDifference apart;
  apart.position = 1e-6;
  CHECK(state(run(apart, apart)) == doctest::Approx(200 * 1e-6 / size));
  CHECK(accumulate(run(apart, apart), 0.1).local_error == doctest::Approx(100 * 1e-6 / size));
  apart.rotation = 1e-5;
  CHECK(state(run(apart, apart)) == doctest::Approx(200 * 1e-5));
}

TEST_CASE("an error of a velocity moves poses later, as far as a few characteristic times") {
  StateDifference apart;
  apart.velocity = 1e-6;
  const double early = state(run(apart, {})), late = state(run({}, apart));
  CHECK(late == doctest::Approx(100 * 1e-6 / speed * (1.0 + 0.5 * speed / size)));
  CHECK(early == doctest::Approx(100 * 1e-6 / speed * (1.0 + 5.0)));
}

TEST_CASE("what is late where the motion is slow is farther off where it is fast") {
  StateDifference apart;
  apart.position = 1e-6;
  for (const double slow : {1.0, 0.5, 0.2})
    CHECK(state(run(apart, {}, slow * speed)) == doctest::Approx(100 * 1e-6 / size / slow));
}

TEST_CASE("a state inside of a step is off by what the interpolant is, once") {
  StateDifference apart;
  RunErrors errors = run(apart, apart);
  errors.steps[1].inside.position = 0.1;
  CHECK(state(errors) == doctest::Approx(0.1 / size));
}

TEST_CASE("parts of which no step could be taken again count as the others") {
  StateDifference apart;
  apart.position = 1e-6;
  RunErrors errors = run(apart, {});
  errors.steps[1].failed = true;
  const AccumulatedError found = accumulate(errors, 0.1);
  CHECK(found.failed == 1);
  CHECK(found.steps.size() == 1);
  CHECK(found.state == doctest::Approx(200 * 1e-6 / size));
  errors.steps[0].failed = true;
  CHECK(accumulate(errors, 0.1).steps.empty());
}

TEST_CASE("what the run moved a mechanism that rests is its error, which does not add up") {
  StateDifference moved;
  moved.position = 1e-6;
  RunErrors errors = run(moved, moved, 0.0);
  for (StepError& step : errors.steps) step.speed = 1e-6;
  CHECK(state(errors) > 1.0);  // of the path of 2e-6 m
  errors.rest = Rest{{moved, moved}, 3.0, 1.0};
  CHECK(state(errors) == doctest::Approx(1e-6 / size));
}

TEST_CASE("what is late is off by the largest acceleration that comes, seen in a step or not") {
  StateDifference apart;
  apart.position = 1e-6;
  RunErrors errors = run(apart, {});
  const double before = state(errors);
  RunPart stop;  // of which no step is known
  stop.steps = 1;
  stop.t = 1.9;
  stop.seconds = 0.01;
  stop.peak = 50.0 * speed * speed / size;
  errors.parts.push_back(stop);
  CHECK(state(errors) == doctest::Approx(50.0 * before).epsilon(0.02));
}
