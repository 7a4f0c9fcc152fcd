#include "linkwork/integration/step_sampling.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "integrators.hpp"

using namespace support;

namespace {

/// Follows so many steps along x(t) = t^2, with a kick of the velocity in one of them.
void follow(StepSampling& sampling, const Dynamics& dynamics, int steps, int kick) {
  VectorXd y = dynamics.initial_y(), y_new = y;
  for (int n = 0; n < steps; ++n) {
    sampling.before(dynamics, y);
    y_new[7] = y[7] + 2.0 + (n == kick ? 1.0 : 0.0);
    sampling.after(n, 1.0, y, y_new);
    y = y_new;
  }
}

}  // namespace

TEST_CASE("parts of a run cover all of its steps, whether their number is known or not") {
  Dynamics dynamics(pendulum(), Options());
  for (const bool known : {false, true})
    for (const int steps : {1, 5, 6, 20, 21, 199, 1000, 12345}) {
      StepSampling sampling(dynamics);
      if (known) sampling.expect(steps);
      follow(sampling, dynamics, steps, -1);
      std::int64_t covered = 0, kept = 0;
      double seconds = 0.0, end = 0.0;
      for (const RunPart& part : sampling.parts()) {
        CHECK(part.t == end);
        end = part.t + part.seconds;
        covered += part.steps;
        seconds += part.seconds;
        for (const KeptStep* step : {&part.any, &part.steepest})
          if (step->kept()) {
            kept += 1;
            CHECK(step->t >= part.t);
            CHECK(step->t < end);
          }
      }
      CHECK(covered == steps);
      CHECK(seconds == steps);
      CHECK(kept <= StepSampling::samples(steps, 1) + 2);
      CHECK(kept >= std::min(steps, 7));
    }
}

TEST_CASE("the step in which accelerations change most is kept") {
  Dynamics dynamics(pendulum(), Options());
  for (const bool known : {false, true})
    for (const int kick : {3, 777, 4321, 9998}) {
      StepSampling sampling(dynamics);
      if (known) sampling.expect(10000);
      follow(sampling, dynamics, 10000, kick);
      bool found = false;
      CAPTURE(known);
      CAPTURE(kick);
      for (const RunPart& part : sampling.parts())
        for (const KeptStep* step : {&part.any, &part.steepest}) {
          const bool there = step->t == kick || step->t == kick + 1;  // it begins and ends
          found = found || (step->kept() && there);
        }
      CHECK(found);
    }
}

TEST_CASE("a small part that is pushed late is seen beside a large one that shakes all the time") {
  Model model(Vec3<double>::Zero());
  for (const char* name : {"large", "small"}) {
    Body body;
    body.mass = 1.0;
    model.add_body(name, body);
  }
  Dynamics dynamics(model, Options());
  const int steps = 5000, push = 4321;
  StepSampling sampling(dynamics);
  sampling.expect(steps);
  VectorXd y = dynamics.initial_y(), y_new = y;
  for (int n = 0; n < steps; ++n) {
    sampling.before(dynamics, y);
    y_new[14] = std::sin(0.1 * n) * 1e3;  // velocities along x
    y_new[20] = n < push ? 0.0 : 1e-3;
    sampling.after(n, 1.0, y, y_new);
    y = y_new;
  }
  bool found = false;
  for (const RunPart& part : sampling.parts()) {
    found = found || part.any.t == push || part.steepest.t == push || part.steepest.t == push + 1;
    if (part.t > push) CHECK(part.peaks[1] == 0.0);
  }
  CHECK(found);
}

TEST_CASE("steps with breaks are kept once each, of many those that stand for all") {
  Dynamics dynamics(pendulum(), Options());
  StepSampling few(dynamics);
  few.expect_breaks({0.25, 0.75, 7.0, 1234.5});
  follow(few, dynamics, 5000, -1);
  std::vector<double> starts;
  for (const RunPart& part : few.broken()) {
    starts.push_back(part.any.t);
    CHECK(part.steps == 1);
  }
  CHECK(starts == std::vector<double>{0.0, 6.0, 1234.0});  // of 7.0 the step that ends there
  StepSampling many(dynamics);
  std::vector<double> times;
  for (int k = 0; k < 1000; ++k) times.push_back(5.0 * k + 0.5);
  many.expect_breaks(times);
  follow(many, dynamics, 5000, -1);
  std::int64_t covered = 0;
  for (const RunPart& part : many.broken()) covered += part.steps;
  CHECK(many.broken().size() <= 17);
  CHECK(many.broken().back().any.t > 4500.0);
  CHECK(covered >= 1000);
  CHECK(covered < 1030);
}

TEST_CASE("a large jump among many small ones is kept, and stands for itself") {
  constexpr int count = 400, blow = 237;
  std::vector<double> times = {0.0}, values = {1.0};
  for (int k = 1; k < count; ++k) {
    times.push_back(5.0 * k + 0.5);
    values.push_back(k == blow ? 1e6 : k % 2);
  }
  times.push_back(1e4);
  Model model = pendulum();
  model.add_signal(piecewise_polynomial(times, values));
  Dynamics dynamics(model, Options());
  StepSampling sampling(dynamics);
  sampling.expect_breaks({times.begin() + 1, times.end() - 1});
  follow(sampling, dynamics, 5000, -1);
  std::int64_t covered = 0, alone = 0;
  for (const RunPart& part : sampling.broken()) {
    covered += part.steps;
    const bool at_blow = part.any.t == 5.0 * blow || part.any.t == 5.0 * (blow + 1);
    alone += at_blow && part.steps == 1 ? 1 : 0;
  }
  CHECK(alone == 2);  // where it begins and where it ends
  CHECK(covered >= count - 1);
}

namespace {

/// So many steps with an even loss, as if the work were more than it is, and one with `more` of it.
void lose(StepSampling& sampling, Dynamics& dynamics, int steps, int bad, double more) {
  VectorXd y = dynamics.initial_y(), y_new = y;
  dynamics.evaluate(0.0, y);
  sampling.expect(steps);
  for (int n = 0; n < steps; ++n) {
    sampling.before(dynamics, y);
    y_new[y.size() - 1] += n == bad ? more * 1e-9 : 1e-9;
    sampling.after(n, 1.0, y, y_new);
    y = y_new;
  }
  sampling.before(dynamics, y);
}

std::vector<double> starts_of(const std::vector<RunPart>& parts) {
  std::vector<double> out;
  for (const RunPart& part : parts)
    for (const KeptStep* step : {&part.any, &part.steepest})
      if (step->kept()) out.push_back(step->t);
  return out;
}

}  // namespace

TEST_CASE("a single step that makes energy is kept, an even loss in all of them is not") {
  Dynamics dynamics(pendulum(), Options());
  for (const int bad : {-1, 1234}) {
    StepSampling sampling(dynamics);
    lose(sampling, dynamics, 5000, bad, 1e6);
    const std::vector<KeptStep> found = sampling.outliers(sampling.parts());
    CHECK(found.size() == (bad < 0 ? 0 : 1));
    for (const KeptStep& step : found) CHECK(step.t == bad);
  }
}

TEST_CASE("of short runs each step is kept that makes more energy than those that are taken again anyway") {
  Dynamics dynamics(pendulum(), Options());
  StepSampling even(dynamics);
  lose(even, dynamics, 25, -1, 1.0);
  const std::vector<double> anyway = starts_of(even.parts());
  CHECK(even.suspects(even.parts()).empty());
  int others = 0;
  for (int bad = 0; bad < 25; ++bad) {
    if (std::find(anyway.begin(), anyway.end(), bad) != anyway.end()) continue;
    StepSampling sampling(dynamics);
    lose(sampling, dynamics, 25, bad, 9.0);
    const std::vector<KeptStep> found = sampling.suspects(sampling.parts());
    CAPTURE(bad);
    CHECK(found.size() == 1);
    CHECK(found.front().t == bad);
    others += 1;
  }
  CHECK(others > 0);
}

namespace {

/// Each body may touch a plane.
Model touching(int bodies) {
  Random random(5);
  Model model;
  const KindInfo& info = force_kinds()[force_kind_index("sphere_plane_contact")].info;
  for (int body = 0; body < bodies; ++body) {
    const std::string name = std::to_string(body);
    model.add_body("ball " + name, random_body(random));
    model.add_force(info.name, "contact " + name, ground, body, random_attachment(random),
                    force_parameters(model, random, info));
  }
  return model;
}

}  // namespace

TEST_CASE("a switch of one connected part is not lost among those of others") {
  Dynamics dynamics(touching(2), Options());
  StepSampling sampling(dynamics);
  sampling.expect(5000);
  VectorXd y = dynamics.initial_y(), y_new = y, sides = VectorXd::Ones(2);
  constexpr int hit = 3333;
  for (int n = 0; n < 5000; ++n) {
    sampling.before(dynamics, y, 1.0, 0.0, sides);
    if (n % 3 == 1) sides[0] = -sides[0];
    if (n == hit) sides[1] = -sides[1];
    sampling.after(n, 1.0, y, y_new);
  }
  std::int64_t alone = 0;
  for (const RunPart& part : sampling.switched())
    if (part.any.t == hit && part.steps == 1) alone += 1;
  CHECK(alone == 1);
}

TEST_CASE("steps with switches, and those that depend on them, stand for their kind alone") {
  Dynamics dynamics(touching(1), Options());
  for (const int memory : {0, 3}) {
    StepSampling sampling(dynamics);
    sampling.remember(memory);
    sampling.expect(5000);
    VectorXd y = dynamics.initial_y(), y_new = y, side = VectorXd::Ones(1);
    for (int n = 0; n < 5000; ++n) {
      sampling.before(dynamics, y, 1.0, 0.0, side);
      if (n % 50 == 7) side = -side;
      y_new[7] = y[7] + (n % 50 == 7 ? 1.0 : 1e-3);
      sampling.after(n, 1.0, y, y_new);
      y = y_new;
    }
    std::vector<double> starts;
    std::int64_t covered = 0;
    for (const RunPart& part : sampling.switched()) {
      starts.push_back(part.any.t);
      covered += part.steps;
      CHECK(static_cast<int>(part.any.t) % 50 >= 7);
      CHECK(static_cast<int>(part.any.t) % 50 <= 7 + memory);
    }
    std::sort(starts.begin(), starts.end());
    CHECK(starts.size() >= 10);
    CHECK(starts.size() <= 20);
    CHECK(starts.front() < 700.0);
    CHECK(starts.back() > 4300.0);
    CHECK(covered >= 100 * (memory + 1));
    CHECK(covered < 120 * (memory + 1));
    for (const RunPart& part : sampling.parts())
      for (const KeptStep* step : {&part.any, &part.steepest}) {
        if (!step->kept()) continue;
        const int since = (static_cast<int>(step->t) + 43) % 50;
        CHECK(step->switched == (since <= memory));
      }
  }
}

TEST_CASE("of steps whose errors are known those that err most are kept, whatever the accelerations") {
  Dynamics dynamics(pendulum(), Options());
  StepSampling sampling(dynamics);
  constexpr int steps = 2000, worst = 777;
  sampling.expect(steps);
  VectorXd y = dynamics.initial_y(), y_new = y;
  for (int n = 0; n < steps; ++n) {
    sampling.before(dynamics, y);
    y_new[7] = y[7] + 2.0 + (n % 10 == 5 ? 1.0 : 0.0);
    sampling.after(n, 1.0, y, y_new, VectorXd::Constant(1, n == worst ? 0.9 : 0.1));
    y = y_new;
  }
  double sum = 0.0;
  int kept = 0;
  for (const RunPart& part : sampling.parts()) {
    sum += part.sums_of_changes[0];
    if (part.any.t == worst || part.steepest.t == worst) kept += 1;
  }
  CHECK(kept == 1);
  CHECK(sum == doctest::Approx(0.1 * (steps - 1) + 0.9));
}

TEST_CASE("beside a part that errs by far more the worst steps of another are kept, too") {
  Dynamics dynamics(touching(2), Options());
  StepSampling sampling(dynamics);
  constexpr int steps = 2000, worst = 777;
  sampling.expect(steps);
  VectorXd y = dynamics.initial_y();
  for (int n = 0; n < steps; ++n) {
    sampling.before(dynamics, y, 1.0, 0.0, VectorXd::Ones(2));
    sampling.after(n, 1.0, y, y, Eigen::Vector2d(n % 2 == 0 ? 0.5 : 0.6, n == worst ? 0.1 : 0.001));
  }
  int kept = 0;
  for (const RunPart& part : sampling.parts())
    if (part.any.t == worst || part.steepest.t == worst) kept += 1;
  CHECK(kept == 1);
}
