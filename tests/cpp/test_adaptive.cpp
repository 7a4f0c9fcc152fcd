#include <doctest/doctest.h>

#include "allocation_counter.hpp"
#include "linkwork/formulation/projection.hpp"
#include "linkwork/integration/adaptive_simulation.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// The cubic that has the values and slopes of both ends of a step of Bogacki and Shampine (1989).
EmbeddedPair bs32() {
  EmbeddedPair pair;
  pair.method = {"bs32", 3, MatrixXd::Zero(3, 3), VectorXd(3), VectorXd(3)};
  pair.method.A(1, 0) = 0.5;
  pair.method.A(2, 1) = 0.75;
  pair.method.b << 2 / 9., 1 / 3., 4 / 9.;
  pair.method.c << 0, 0.5, 0.75;
  pair.error_order = 2;
  pair.error.resize(4);
  pair.error << -5 / 72., 1 / 12., 1 / 9., -1 / 8.;
  pair.extra_A.resize(0, 4);
  pair.interpolant.resize(4, 3);
  pair.interpolant << 1, -4 / 3., 5 / 9., 0, 1, -2 / 3., 0, 4 / 3., -8 / 9., 0, -1, 1;
  return pair;
}

/// Heun's method as a half-explicit one: each stage meets the constraints where the next begins.
HalfExplicitTableau half_explicit_heun() {
  HalfExplicitTableau tableau{"heun", 2, MatrixXd::Zero(2, 2), MatrixXd::Zero(2, 2)};
  tableau.A(1, 0) = 1.0;
  tableau.A_bar << 1.0, 0.0, 0.5, 0.5;
  return tableau;
}

Model pendulum() {
  Random random(7);
  Model model;
  model.add_body("bob", random_body(random));
  add_joint(model, random, "spherical", "hook", ground, 0);
  return model;
}

}  // namespace

TEST_CASE("projection takes positions and velocities to the constraints along M^-1 D^T") {
  const Model model = pendulum();
  Dynamics dynamics(model, {});
  const System& system = dynamics.system();
  Projection projection(dynamics);
  Random random(3);
  const VectorXd moved_q = moved(model.initial_q(), 1e-3 * random.vector(6), VectorXd::Zero(6), 1.0);
  VectorXd y = dynamics.initial_y();
  y.head<7>() = moved_q;
  y.segment<6>(7) += random.vector(6);
  const VectorXd v = y.segment<6>(7);
  dynamics.evaluate(0.0, y);
  projection.positions(0.0, y);
  projection.velocities(0.0, y);
  Evaluation at = system.make_evaluation();
  system.evaluate(0.0, y.head<7>(), y.segment<6>(7), system.initial_history(), at);
  CHECK(at.Phi.cwiseAbs().maxCoeff() < 1e-14);
  CHECK(at.Phi_dot.cwiseAbs().maxCoeff() < 1e-13);
  const VectorXd impulse = dense_M(model) * (y.segment<6>(7) - v);
  const MatrixXd D = dense_D(system, dynamics.evaluation());
  const VectorXd lambda = D.transpose().colPivHouseholderQr().solve(impulse);
  CHECK((D.transpose() * lambda - impulse).norm() < 1e-3 * impulse.norm());  // D of the state before
}

TEST_CASE("a pair with an estimate or an interpolant that cannot be is refused") {
  const auto code = [](auto alter) {
    EmbeddedPair pair = bs32();
    alter(pair);
    return error_code([&] { PairStepper stepper(pair); });
  };
  CHECK(code([](EmbeddedPair&) {}) == "none");
  CHECK(code([](EmbeddedPair& pair) { pair.error[0] += 0.1; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.error.conservativeResize(3); }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.error_order = 0; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.interpolant(0, 0) = 2.0; }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.interpolant.conservativeResize(3, 3); }) == "tableau");
  CHECK(code([](EmbeddedPair& pair) { pair.extra_c.setZero(1); }) == "tableau");
}

TEST_CASE("a half-explicit method that is implicit, singular or inconsistent is refused") {
  const auto code = [](auto alter) {
    HalfExplicitTableau tableau = half_explicit_heun();
    alter(tableau);
    return error_code([&] { make_half_explicit(tableau); });
  };
  CHECK(code([](HalfExplicitTableau&) {}) == "none");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A(0, 0) = 1.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(0, 1) = 1.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(0, 0) = 0.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(1, 0) = 0.6; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A.conservativeResize(1, 1); }) == "tableau");
}

TEST_CASE("a schedule of an adaptive run that makes no sense is refused") {
  const auto code = [](auto alter) {
    AdaptiveSchedule schedule;
    schedule.t_end = 1.0;
    schedule.record_every = 1;
    alter(schedule);
    Dynamics dynamics(pendulum(), {});
    return error_code([&] { AdaptiveSimulation simulation(dynamics, bs32(), schedule); });
  };
  CHECK(code([](AdaptiveSchedule&) {}) == "none");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.t_end = -1.0; }) == "t_end");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.tolerances.relative = 1e-16; }) == "rtol");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.tolerances.absolute = 0.0; }) == "atol");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.largest_step = 0.0; }) == "step");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.times = {0.5}; }) == "times");
}

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
    Dynamics dynamics(pendulum(), {});
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

#if CAN_COUNT_ALLOCATIONS

TEST_CASE("a trial step, its interpolation and a half-explicit step do not allocate after the first") {
  Options options;
  options.linear_solver = "dense";
  options.matrix_form = "schur";
  Dynamics dynamics(pendulum(), options);
  const ErrorMeasure measure(dynamics.system(), {});
  PairStepper stepper(bs32());
  stepper.start(dynamics.y_size());
  VectorXd y = dynamics.initial_y(), between(dynamics.y_size());
  const auto trial = [&] {
    dynamics.evaluate(0.0, y);
    stepper.trial(dynamics, measure, {0.0, 1e-3}, y);
    stepper.prepare_interpolation(dynamics);
    stepper.interpolate(dynamics.system(), 0.5, between);
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) trial();
  CHECK(allocations(trial) == 0);

  options.stabilization = "none";
  Dynamics bare(pendulum(), options);
  const auto method = make_half_explicit(half_explicit_heun());
  method->start(bare.y_size());
  const VectorXd start = bare.initial_y();
  const auto step = [&] {
    y = start;
    bare.evaluate(0.0, y);
    method->step(bare, 0.0, 1e-3, y);
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) step();
  CHECK(allocations(step) == 0);
}

#endif
