#include "linkwork/integration/accumulated_error.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double size = 2.0, speed = 10.0;  // m, m/s

/// Two parts of a run of a connected mechanism, of a second and 100 steps each, with one step that is known of each.
RunErrors run(const StateDifference& in_first, const StateDifference& in_second, double first_speed = speed) {
  RunErrors out;
  out.connected_parts.resize(1);
  out.connected_parts[0].length = size;
  for (int k = 0; k < 2; ++k) {
    RunPart part;
    part.steps = 100;
    part.t = k;
    part.seconds = 1.0;
    part.sums_of_changes = VectorXd::Constant(1, 100.0);
    out.parts.push_back(part);
    StepError step;
    step.t = k + 0.5;
    step.h = 0.01;
    step.of_part.resize(1);
    step.of_part[0].change = 1.0;
    step.of_part[0].speed = step.of_part[0].body_speed = k == 0 ? first_speed : speed;
    step.of_part[0].end = k == 0 ? in_first : in_second;
    out.steps.push_back(step);
    out.part_of.push_back(k);
  }
  return out;
}

JudgedPart part_of(int first_body) {
  JudgedPart out;
  out.first_body = first_body;
  out.length = size;
  return out;
}

PartError off_by(const StateDifference& apart) {
  PartError out;
  out.end = apart;
  out.speed = out.body_speed = speed;
  out.change = 1.0;
  return out;
}

double state(const RunErrors& errors) { return accumulate(errors).state; }

/// Of an error at t, as it was followed to the end.
ErrorGrowth grown(double t, double factor) { return {t, 2.0, VectorXd::Constant(1, factor)}; }

}  // namespace

TEST_CASE("errors of poses add up over all steps, relative to the size of the motion") {
  StateDifference apart;
  apart.position = 1e-6;
  CHECK(state(run(apart, apart)) == doctest::Approx(200 * 1e-6 / size));
  CHECK(accumulate(run(apart, apart)).local_error == doctest::Approx(100 * 1e-6 / size));
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

TEST_CASE("energy delays by the largest acceleration that comes after it, but for that of a vibration") {
  RunErrors errors = run({}, {});
  for (RunPart& part : errors.parts) {
    part.peaks = VectorXd::Constant(1, 50.0 * speed * speed / size);
    part.velocity_paths = VectorXd::Constant(1, speed * speed / size);
  }
  errors.connected_parts[0].kinetic = 1.0;
  for (StepError& step : errors.steps) step.of_part[0].kinetic = 1.0;
  CHECK(accumulate(errors).slowness == doctest::Approx(1.0));
  errors.connected_parts[0].bursts_late = false;
  CHECK(accumulate(errors).suddenness == 0.0);
  errors.connected_parts[0].bursts_late = true;
  CHECK(accumulate(errors).suddenness == doctest::Approx(25.0));  // in the second part
  CHECK(accumulate(errors).peaks.size() == 2);
  CHECK(accumulate(errors).peaks[1].t == 1.0);
  CHECK(accumulate(errors).peaks[1].end == 2.0);
  CHECK(accumulate(errors).peaks[1].accelerations[0] == 50.0 * speed * speed / size);
  CHECK(accumulate(errors).speeds[0] == doctest::Approx(speed));
  errors.parts[1].peaks.setZero();
  CHECK(accumulate(errors).suddenness == doctest::Approx(0.0));
  errors.parts[1].peaks = errors.parts[0].peaks;
  for (RunPart& part : errors.parts) part.velocity_paths *= 50.0;
  CHECK(accumulate(errors).suddenness == doctest::Approx(1.0));
}

TEST_CASE("what is late where the motion is slow is farther off where it is fast") {
  StateDifference apart;
  apart.position = 1e-6;
  for (const double slow : {1.0, 0.5, 0.2})
    CHECK(state(run(apart, {}, slow * speed)) == doctest::Approx(100 * 1e-6 / size / slow));
}

TEST_CASE("errors of a part of the run grow as one of its own, and those before and after it, do") {
  StateDifference apart;
  apart.position = 1e-9;
  const double of_part = 100 * 1e-9 / size;
  RunErrors errors = run(apart, apart);
  const auto follow = [&](double t, double factor) { errors.growth.push_back(grown(t, factor)); };
  follow(0.5, 1e6);
  CHECK(state(errors) == doctest::Approx(of_part * (1e6 + 1e6)));
  follow(1.5, 1e4);
  CHECK(state(errors) == doctest::Approx(of_part * (1e6 + 1e5)));
  CHECK(accumulate(errors).growth == 1e6);
  CHECK(accumulate(errors).unstable == 1e6);
  CHECK(accumulate(errors).grows);
  errors.growth[1].of_part[0] = 1e8;
  CHECK(state(errors) == doctest::Approx(of_part * (1e7 + 1e8)));
  for (ErrorGrowth& it : errors.growth) it.of_part[0] = 1.0;
  CHECK(state(errors) == doctest::Approx(state(run(apart, apart))));
  CHECK(accumulate(errors).unstable == 1.0);
}

TEST_CASE("as regular motion grows, errors of steps alone grow, as where a contact begins; others come and go") {
  StateDifference apart;
  apart.position = 1e-9;
  const double of_part = 100 * 1e-9 / size, factor = 50.0;
  RunErrors errors = run(apart, apart);
  errors.growth.push_back(grown(0.0, factor));
  CHECK(state(errors) == doctest::Approx(2.0 * of_part * factor));
  for (RunPart& part : errors.parts) part.peaks = VectorXd::Zero(1);
  CHECK(state(errors) < 0.5 * of_part * factor);
  CHECK(accumulate(errors).unstable == 1.0);
}

TEST_CASE("a velocity is off by what bodies move at, not by what they would at the ends of the box as they turn") {
  StateDifference apart;
  apart.velocity = 1e-6;
  RunErrors errors = run({}, apart);
  const double usual = state(errors);
  for (StepError& step : errors.steps) step.of_part[0].speed = 100.0 * speed;
  const double of_velocities = 100 * 1e-6 / speed, of_poses = usual - of_velocities;
  CHECK(state(errors) == doctest::Approx(of_velocities + of_poses));
  apart.omega = std::exchange(apart.velocity, 0.0) * 100.0 / size;
  for (StepError& step : errors.steps) step.of_part[0].end = &step == &errors.steps[0] ? StateDifference() : apart;
  CHECK(state(errors) == doctest::Approx(of_velocities * (1.0 + 5.0)));  // it turns long before that
}

TEST_CASE("where growth is known to the end the state is off by all errors as they have grown at most") {
  StateDifference apart;
  apart.position = 1e-9;
  RunErrors errors = run(apart, apart);
  const double of_part = 100 * 1e-9 / size;
  const auto at_most = [&] { return accumulate(errors).at_most; };
  CHECK(std::isnan(at_most()));
  errors.growth.push_back(grown(0.2, 7.0));
  CHECK(std::isnan(at_most()));  // one error is of a kind
  errors.growth.push_back(grown(1.4, 3.0));
  CHECK(at_most() == doctest::Approx(of_part * (7.0 + 7.0)));
  errors.growth[0].t = 1.2;
  errors.growth.insert(errors.growth.begin(), grown(0.9, 2.0));
  CHECK(at_most() == doctest::Approx(of_part * (7.0 + 7.0)));  // the next one counts, too
  errors.growth[2].until = 1.9;
  CHECK(std::isnan(at_most()));  // not to the end
  errors.growth[2].until = 2.0;
  errors.growth[0].of_part[0] = 1e6;
  CHECK(std::isnan(at_most()));  // unstable
  errors.growth[0].of_part[0] = 2.0;
  EnergyMade made;
  made.largest = 1e-3;
  made.exchanged = 1.0;
  errors.connected_parts[0].energy = made;
  CHECK(std::isnan(at_most()));  // more than the steps have made
  errors.connected_parts[0].energy->largest = 1e-8;
  CHECK(at_most() == doctest::Approx(of_part * (7.0 + 7.0)));
  errors.connected_parts[0].has_laws = true;
  CHECK(std::isnan(at_most()));
}

TEST_CASE("a state inside of a step is off by what the interpolant is, once") {
  StateDifference apart;
  RunErrors errors = run(apart, apart);
  errors.steps[1].of_part[0].inside.position = 0.1;
  CHECK(state(errors) == doctest::Approx(0.1 / size));
}

TEST_CASE("parts of which no step could be taken again count as the others") {
  StateDifference apart;
  apart.position = 1e-6;
  RunErrors errors = run(apart, {});
  errors.steps[1].failed = true;
  const AccumulatedError found = accumulate(errors);
  CHECK(found.failed == 1);
  CHECK(found.steps.size() == 1);
  CHECK(found.state == doctest::Approx(200 * 1e-6 / size));
  errors.steps[0].failed = true;
  CHECK(accumulate(errors).steps.empty());
}

TEST_CASE("what the run moved a mechanism that rests is its error, which does not add up") {
  StateDifference moved;
  moved.position = 1e-6;
  RunErrors errors = run(moved, moved, 0.0);
  for (StepError& step : errors.steps) step.of_part[0].speed = step.of_part[0].body_speed = 1e-6;
  CHECK(state(errors) > 1.0);  // of the path of 2e-6 m
  errors.connected_parts[0].rest = Rest{{moved, moved}, 3.0, 1.0};
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
  stop.peaks = VectorXd::Constant(1, 50.0 * speed * speed / size);
  errors.parts.push_back(stop);
  CHECK(state(errors) == doctest::Approx(50.0 * before).epsilon(0.02));
}

TEST_CASE("each connected part is judged as if it were alone, and the worst counts, whatever its size and speed") {
  StateDifference apart;
  apart.position = 1e-6;
  const double alone = state(run(apart, apart));
  for (const double larger : {1e-6, 1.0, 1e6}) {
    RunErrors errors = run({}, {});
    errors.connected_parts.resize(2);
    errors.connected_parts[0].length = larger * size;
    errors.connected_parts[1] = part_of(7);
    for (StepError& step : errors.steps) {
      step.of_part.resize(2);
      step.of_part[0].speed = step.of_part[0].body_speed = larger * speed;
      step.of_part[0].acceleration = 1e3 * larger * speed * speed / size;  // errs in nothing that could be late by it
      step.of_part[1] = off_by(apart);
    }
    for (RunPart& part : errors.parts) {
      part.peaks = Eigen::Vector2d(1e3 * larger * speed * speed / size, 0.0);
      part.sums_of_changes = Eigen::Vector2d(100.0, 100.0);
    }
    const AccumulatedError found = accumulate(errors);
    CHECK(found.state == doctest::Approx(alone));
    CHECK(found.body == 7);
  }
}

TEST_CASE("what rests before forces give it energy, or after they took it, is not late") {
  RunErrors moving = run({}, {}), settled = moving, pushed = moving, turning = moving;
  for (RunErrors* it : {&moving, &settled, &pushed, &turning}) it->connected_parts[0].kinetic = 1.0;
  const auto set = [](StepError& step, double kinetic, double work) {
    step.of_part[0].kinetic = kinetic;
    step.work = work;
  };
  set(moving.steps[0], 1.0, 0.0), set(moving.steps[1], 1.0, 0.0);
  set(settled.steps[0], 1.0, 0.0), set(settled.steps[1], 0.0, -1.0);
  set(pushed.steps[0], 0.0, 0.0), set(pushed.steps[1], 1.0, 1.0);
  CHECK(accumulate(moving).slowness == doctest::Approx(1.0));
  CHECK(accumulate(settled).slowness == doctest::Approx(0.5));
  CHECK(accumulate(pushed).slowness == doctest::Approx(1.0));
  // A force that gives back what it took has a potential but does not tell it: a moment of rest is late for all that.
  set(turning.steps[0], 0.0, -1.0), set(turning.steps[1], 1.0, 0.0);
  CHECK(accumulate(turning).slowness == doctest::Approx(1.0));
  turning.parts[0].work = 0.0;  // before that moment
  CHECK(accumulate(turning).slowness == doctest::Approx(1.0));
  turning.connected_parts[0].has_laws = true;
  CHECK(accumulate(turning).slowness == doctest::Approx((100.0 + 1.0) / 2));
}

TEST_CASE("energy that steps make counts where laws do not tell theirs, with what the choice of steps leaves open") {
  RunErrors errors = run({}, {});
  errors.connected_parts[0].kinetic = 2.0;
  errors.steps[0].of_part[0].energy = 1e-6;
  errors.steps[1].of_part[0].energy = 3e-6;
  CHECK(accumulate(errors).energies.empty());
  errors.connected_parts[0].has_laws = true;
  for (RunPart& part : errors.parts) part.peaks = VectorXd::Zero(1);
  const std::vector<EnergyOfPart> found = accumulate(errors).energies;
  REQUIRE(found.size() == 1);
  CHECK(found[0].body == -1);
  CHECK(found[0].error == doctest::Approx((100 * 4e-6 + 100 * 2e-6 / std::sqrt(2.0)) / 2.0));
  errors.connected_parts[0].bursts_late = false;
  CHECK(accumulate(errors).energies.empty());
  errors.connected_parts[0].bursts_late = true;
  errors.connected_parts[0].rest = Rest();
  CHECK(accumulate(errors).energies.empty());
}

TEST_CASE("a part that rests is weighed by its rest, the part beside it by its motion") {
  StateDifference moved, apart;
  moved.position = 1e-6;
  apart.position = 1e-7;
  RunErrors errors = run(moved, moved, 0.0);
  errors.connected_parts.push_back(part_of(1));
  errors.connected_parts[0].rest = Rest{{moved, moved}, 3.0, 1.0};
  for (StepError& step : errors.steps) {
    step.of_part[0].speed = step.of_part[0].body_speed = 1e-6;
    step.of_part.push_back(off_by(apart));
  }
  for (RunPart& part : errors.parts) part.sums_of_changes = Eigen::Vector2d(100.0, 100.0);
  const AccumulatedError found = accumulate(errors);
  CHECK(found.state == doctest::Approx(200 * 1e-7 / size));
  CHECK(found.body == 1);
  CHECK(found.rest[0].speed == 3.0);
  CHECK(found.rest[1].speed == 0.0);
  CHECK(found.rest_energy == 0.0);  // the energy is of both
}
