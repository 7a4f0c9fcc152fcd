#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "linkwork/integration/run_judge.hpp"
#include "linkwork/integration/simulation.hpp"
#include "support.hpp"

using namespace support;

namespace {

ButcherTableau rk4() {
  ButcherTableau out{"rk4", 4, MatrixXd::Zero(4, 4), VectorXd(4), VectorXd(4)};
  out.A(1, 0) = out.A(2, 1) = 0.5;
  out.A(3, 2) = 1.0;
  out.b << 1 / 6., 1 / 3., 1 / 3., 1 / 6.;
  out.c << 0, 0.5, 0.5, 1;
  return out;
}

/// A rod on a hinge, let go from the horizontal.
Model pendulum() {
  Model model;
  Body body;
  body.mass = 2.0;
  body.inertia = Vec3<double>(0.10, 0.20, 0.20).asDiagonal();
  body.position = {0.5, 0.0, 0.0};
  model.add_body("rod", body);
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j = {-0.5, 0.0, 0.0};
  at.C_i = at.C_j = (Mat3<double>() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();  // z along -y
  model.add_joint("revolute", "hinge", ground, 0, at);
  return model;
}

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

TEST_CASE("a single step that makes energy is kept, an even loss in all of them is not") {
  Dynamics dynamics(pendulum(), Options());
  for (const int bad : {-1, 1234}) {
    StepSampling sampling(dynamics);
    VectorXd y = dynamics.initial_y(), y_new = y;
    dynamics.evaluate(0.0, y);
    for (int n = 0; n < 5000; ++n) {
      sampling.before(dynamics, y);
      y_new[y.size() - 1] += n == bad ? 1e-3 : 1e-9;  // as if the work were more than it is
      sampling.after(n, 1.0, y, y_new);
      y = y_new;
    }
    const std::vector<KeptStep> found = sampling.outliers({});
    CHECK(found.size() == (bad < 0 ? 0 : 1));
    for (const KeptStep& step : found) CHECK(step.t == bad);
  }
}

TEST_CASE("a step taken again in halves gives its error, which falls with the order plus one") {
  const Model model = pendulum();
  double last = 0.0;
  for (const double h : {0.04, 0.02, 0.01}) {
    Dynamics dynamics(model, Options());
    Simulation run(dynamics, make_runge_kutta(rk4()), {0.4, h});
    run.advance(1000000, 1e9);
    StepJudge judge(dynamics, in_parts(make_runge_kutta(rk4())));
    double largest = 0.0;
    for (const RunPart& part : run.sampling().parts())
      for (const KeptStep* step : {&part.any, &part.steepest})
        if (step->kept()) {
          const StepError error = judge.judge(*step, true);
          CHECK(!error.failed);
          CHECK(error.force < 1e3 * (error.end.velocity + error.end.position + 1e-12));
          largest = std::max(largest, error.end.velocity);
        }
    if (last > 0.0) CHECK(std::log2(last / largest) == doctest::Approx(5.0).epsilon(0.1));
    last = largest;
  }
}

/// Accelerations of the model by rk4 with step h, whose largest difference in a second take is that of the error.
double largest_error(const Model& model, double h, std::vector<double> breaks) {
  Dynamics dynamics(model, Options());
  Simulation run(dynamics, make_runge_kutta(rk4()), {20.0 * h, h});
  run.expect_breaks(std::move(breaks));
  run.advance(1000000, 1e9);
  double largest = 0.0;
  for (const StepError& step : judge_run(run.sampling(), dynamics, in_parts(make_runge_kutta(rk4()))).steps)
    largest = std::max(largest, step.end.velocity);
  return largest;
}

TEST_CASE(
    "a force in step with the parts of a step is seen, and a pulse between its stages where its times are known") {
  const double h = 0.04, two_pi = 6.283185307179586;
  const auto pushed = [](TimeFunctionPtr force) {
    Model model;
    Body body;
    body.mass = 1.0;
    body.inertia = 0.1 * Mat3<double>::Identity();
    model.add_body("ball", body);
    Attachment<double> at;
    at.s_i.setZero();
    at.s_j.setZero();
    at.C_i = at.C_j = Mat3<double>::Identity();
    std::vector<Parameter> parameters(6);
    parameters[0].signal = model.add_signal(std::move(force));
    model.add_force("applied", "push", ground, 0, at, parameters);
    return model;
  };
  for (const int periods : {1, 2, 4, 8, 12})
    CHECK(largest_error(pushed(harmonic(10.0, two_pi * periods / h, 0.25 * two_pi, 0.0)), h, {}) > 1e-2);
  const auto pulse = [](double t) { return t >= 0.3701 && t < 0.3711 ? 50.0 : 0.0; };
  const Model model = pushed(callback(pulse));
  CHECK(largest_error(model, h, {}) < 1e-12);
  CHECK(largest_error(model, h, {0.3701, 0.3711}) == doctest::Approx(0.05).epsilon(1e-3));
}

TEST_CASE("the halves keep the zero-order hold of the whole step") {
  const Model model = pendulum();
  Dynamics dynamics(model, Options());
  VectorXd y = dynamics.initial_y(), held(dynamics.y_size()), halved(dynamics.y_size()), free(dynamics.y_size());
  y[2] += 1e-3;  // off the hinge
  dynamics.evaluate(0.0, y);
  dynamics.rates(free);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.01));
  dynamics.rates(held);
  dynamics.begin_parts(0.5);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.005));
  dynamics.end_zero_order_hold();
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.005));
  dynamics.rates(halved);
  CHECK((held - free).norm() > 1e-3);
  CHECK((halved - held).norm() <= 1e-12 * held.norm());
  dynamics.end_parts();
  dynamics.rates(halved);
  CHECK((halved - free).norm() <= 1e-12 * held.norm());
}
