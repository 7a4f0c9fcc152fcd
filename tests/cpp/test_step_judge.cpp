#include "linkwork/integration/step_judge.hpp"

#include "integrators.hpp"
#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/special/coupler.hpp"

using namespace support;

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
          const StateDifference& end = error.of_part[0].end;
          CHECK(error.of_part[0].force < 1e3 * (end.velocity + end.position + 1e-12));
          largest = std::max(largest, end.velocity);
        }
    if (last > 0.0) CHECK(std::log2(last / largest) == doctest::Approx(5.0).epsilon(0.1));
    last = largest;
  }
}

TEST_CASE("a multistep method is compared with its starter in parts, and has the error of its own order") {
  double previous = 0.0;
  for (const double h : {0.02, 0.01, 0.005}) {
    Dynamics dynamics(pendulum(), Options());
    Simulation run(dynamics, make_multistep(ab2()), {0.4, h});
    run.advance(1 << 30, 1e9);
    StepJudge judge(dynamics, by_one_step_method(ab2().starter));
    double largest = 0.0;
    for (const RunPart& part : run.sampling().parts())
      if (part.any.kept() && part.any.t > 2.5 * h)
        largest = std::max(largest, judge.judge(part.any, false).of_part[0].end.velocity);
    if (previous > 0.0) CHECK(std::log2(previous / largest) == doctest::Approx(3.0).epsilon(0.1));
    previous = largest;
  }
}

TEST_CASE("a step that cannot be taken again is said to have failed") {
  Dynamics dynamics(pendulum(), Options());
  StepJudge judge(dynamics, in_parts(make_runge_kutta(rk4())));
  KeptStep step;
  step.h = 0.1;
  step.y = step.y_new = dynamics.initial_y();
  step.history = dynamics.initial_history();
  CHECK(!judge.judge(step, false).failed);
  step.y[7] = NAN;
  CHECK(judge.judge(step, false).failed);
}

TEST_CASE("reactions that yielding constraints give are compared in the state of the run, and go with the compliance") {
  double last = 0.0;
  for (const double scale : {1e4, 1e5}) {
    Options yielding;
    yielding.formulation = "penalty";
    yielding.penalty_scale = scale;
    Dynamics dynamics(pendulum(), Options()), recorded(pendulum(), yielding);
    StepJudge judge(dynamics, in_parts(make_runge_kutta(rk4())));
    KeptStep step;
    step.h = 0.1;
    step.y = step.y_new = dynamics.initial_y();
    step.history = dynamics.initial_history();
    CHECK(std::isnan(judge.judge(step, true).of_part[0].yielded_force));
    judge.compare_with(&recorded);
    const PartError error = judge.judge(step, false).of_part[0];
    const double lost = error.yielded_force / error.largest_force;
    CHECK(lost > 0.1 / scale);
    CHECK(lost < 10.0 / scale);
    if (last > 0.0) CHECK(last / lost == doctest::Approx(10.0).epsilon(0.01));
    last = lost;
  }
}

TEST_CASE("an angle that is counted over full turns, and is not zero any more, is no contact that begins") {
  Random random(5);
  Model model;
  for (const double x : {0.0, 5.0}) {
    Body body = body_at({x, 0, 0});
    body.omega = {0, 0, x > 0.0 ? 2.0 : 1.0};
    model.add_body(x > 0.0 ? "b" : "a", body);
    join(model, "revolute", x > 0.0 ? "B" : "A", ground, x > 0.0 ? 1 : 0, {x, 0, 0});
  }
  const auto coupler =
      std::make_shared<Coupler>(model, std::vector<CoupledCoordinate>{{0, "angle", 2.0}, {1, "angle", -1.0}});
  const Element& first = model.joints()[0];
  model.add_special_joint("coupler", "belt", first.i, first.j, first.at, coupler, {{0.0, -1}});
  model.add_body("ball", random_body(random));
  const KindInfo& contact = force_kinds()[force_kind_index("sphere_plane_contact")].info;
  model.add_force(contact.name, "contact", ground, 2, random_attachment(random),
                  force_parameters(model, random, contact));
  Dynamics dynamics(model, Options());
  Simulation run(dynamics, make_runge_kutta(rk4()), {0.2, 0.02});
  run.advance(1 << 30, 1e9);
  CHECK(run.sampling().switched().empty());
  StepJudge judge(dynamics, in_parts(make_runge_kutta(rk4())));
  int judged = 0;
  for (const RunPart& part : run.sampling().parts()) {
    if (!part.any.kept()) continue;
    KeptStep step = part.any;
    step.history_new = step.history;
    step.history_new.head<2>() += Eigen::Vector2d(0.02, 0.04);  // of the coupler
    const StepError error = judge.judge(step, false);
    CHECK(!error.failed);
    CHECK(!error.of_part[0].contact_begins);
    judged += 1;
  }
  CHECK(judged > 0);
}
