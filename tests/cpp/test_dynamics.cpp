#include "linkwork/formulation/dynamics.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// With a driven joint, off the constraints.
Model driven_chain() {
  Random random(140);
  Model model = random_chain(random, 3, "spherical");
  model.add_joint("distance", "actuator", ground, 1, random_attachment(random),
                  {{0.0, model.add_signal(harmonic(0.2, 3.0, 0.5, 1.0))}});
  return model;
}

}  // namespace

TEST_CASE("rates are N(q) v, the accelerations, and the power of forces and drivers") {
  Options options = unstabilized();
  Dynamics dynamics(driven_chain(), options);
  const System& system = dynamics.system();
  const int nq = system.q_size(), nv = system.v_size();
  const VectorXd y = dynamics.initial_y();
  VectorXd y_dot(y.size()), q_dot(nq), v_dot(nv), lambda(system.row_count());
  dynamics.evaluate(0.3, y);
  dynamics.rates(y_dot);
  dynamics.accelerations(v_dot, lambda);
  system.position_rates(y.head(nq), y.segment(nq, nv), q_dot);
  CHECK((y_dot.head(nq) - q_dot).norm() == 0.0);
  CHECK(relative_error(VectorXd(y_dot.segment(nq, nv)), v_dot) < 1e-14);
  // Of the driver -lambda . Phi_t: the change of the kinetic energy is the power of all that acts.
  const Evaluation& at = dynamics.evaluation();
  CHECK(y_dot[nq + nv] == doctest::Approx(at.power - lambda.dot(at.Phi_t)));
  CHECK(std::abs(lambda.dot(at.Phi_t)) > 1e-3);
}

TEST_CASE("continuous Baumgarte adds -2 alpha Phi_dot - beta^2 Phi to gamma") {
  const Model model = driven_chain();
  Options options = unstabilized();
  options.stabilization = "baumgarte";
  options.baumgarte_alpha = 3.0;
  options.baumgarte_beta = 7.0;
  Dynamics dynamics(model, options);
  VectorXd y = dynamics.initial_y(), y_dot(y.size());
  y.head<3>() += Vec3<double>(0.1, -0.2, 0.05);
  dynamics.evaluate(0.0, y);
  dynamics.rates(y_dot);
  const System& system = dynamics.system();
  const Evaluation& at = dynamics.evaluation();
  const VectorXd v_dot = y_dot.segment(system.q_size(), system.v_size());
  CHECK(at.Phi.norm() > 0.1);
  CHECK(relative_error(dense_D(system, at) * v_dot, at.gamma - 6.0 * at.Phi_dot - 49.0 * at.Phi) < 1e-10);
}

TEST_CASE("a zero-order hold enters the rates until it ends, and never the accelerations") {
  const Model model = driven_chain();
  Dynamics dynamics(model, Options());
  VectorXd y = dynamics.initial_y(), free(y.size()), held(y.size()), released(y.size());
  const auto n = dynamics.system().v_size();
  dynamics.evaluate(0.0, y);
  dynamics.rates(free);
  dynamics.begin_zero_order_hold({2.0, 5.0}, 0.01);
  dynamics.rates(held);
  VectorXd v_dot(n), lambda(dynamics.system().row_count());
  dynamics.accelerations(v_dot, lambda);
  dynamics.end_zero_order_hold();
  dynamics.rates(released);
  const Evaluation& at = dynamics.evaluation();
  const VectorXd u = dense_D(dynamics.system(), at) * (held - free).segment(dynamics.system().q_size(), n);
  CHECK(relative_error(u, -4.0 * at.Phi_dot - 25.0 * at.Phi) < 1e-9);
  CHECK(relative_error(released, free) < 1e-13);
  CHECK(relative_error(v_dot, free.segment(dynamics.system().q_size(), n)) < 1e-13);
}

TEST_CASE("a step that was cut short corrects violations as one of the usual length") {
  const Model model = pendulum();
  Dynamics dynamics(model, Options());
  VectorXd y = dynamics.initial_y(), usual(dynamics.y_size()), held(dynamics.y_size());
  y[2] += 1e-3;  // off the hinge
  dynamics.evaluate(0.0, y);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.01), 0.01);
  dynamics.rates(usual);
  dynamics.end_zero_order_hold();
  dynamics.correct_over(0.01);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 1e-9), 1e-9);
  dynamics.rates(held);
  CHECK((held - usual).norm() <= 1e-12 * usual.norm());
}

TEST_CASE("the halves keep the zero-order hold of the whole step") {
  const Model model = pendulum();
  Dynamics dynamics(model, Options());
  VectorXd y = dynamics.initial_y(), held(dynamics.y_size()), halved(dynamics.y_size()), free(dynamics.y_size());
  y[2] += 1e-3;  // off the hinge
  dynamics.evaluate(0.0, y);
  dynamics.rates(free);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.01), 0.01);
  dynamics.rates(held);
  dynamics.begin_parts(0.5);
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.005), 0.005);
  dynamics.end_zero_order_hold();
  dynamics.begin_zero_order_hold(deadbeat_gains(0.5, 0.005), 0.005);
  dynamics.rates(halved);
  CHECK((held - free).norm() > 1e-3);
  CHECK((halved - held).norm() <= 1e-12 * held.norm());
  dynamics.end_parts();
  dynamics.rates(halved);
  CHECK((halved - free).norm() <= 1e-12 * held.norm());
}

TEST_CASE("after a look elsewhere the dynamics return to the bits of where they were") {
  Dynamics dynamics(spherical_pendulum(), {});
  const VectorXd y = dynamics.initial_y();
  VectorXd before(y.size()), after(y.size());
  dynamics.evaluate(0.0, y);
  dynamics.rates(before);
  const Dynamics::Place place = dynamics.place();
  VectorXd other = y;
  other.segment<6>(7) *= 2.0;
  dynamics.evaluate(1.0, other);
  dynamics.rates(after);
  CHECK((after - before).norm() > 1.0);
  dynamics.return_to(place);
  dynamics.rates(after);
  CHECK((after - before).norm() == 0.0);
}

TEST_CASE("who observes hears of the first solution at a state, at once where there has been one") {
  Dynamics dynamics(spherical_pendulum(), {});
  VectorXd y_dot(dynamics.y_size());
  int heard = 0;
  dynamics.evaluate(0.0, dynamics.initial_y());
  dynamics.observe([&] { heard += 1; });
  CHECK(heard == 0);
  dynamics.rates(y_dot);
  CHECK(heard == 1);
  dynamics.observe([&] { heard += 1; });
  CHECK(heard == 2);
  dynamics.rates(y_dot);
  CHECK(heard == 2);
}

TEST_CASE("a state is factorized once, however often it is solved for") {
  Dynamics dynamics(spherical_pendulum(), unstabilized());
  VectorXd y_dot(dynamics.y_size());
  const DynamicsStatistics before = dynamics.statistics();
  dynamics.evaluate(0.0, dynamics.initial_y());
  for (int k = 0; k < 3; ++k) dynamics.rates(y_dot);
  const DynamicsStatistics after = dynamics.statistics();
  CHECK(after.evaluations - before.evaluations == 1);
  CHECK(after.factorizations - before.factorizations == 1);
  CHECK(after.solves - before.solves == 3);
}

TEST_CASE("a history of another mechanism is refused") {
  Dynamics dynamics(spherical_pendulum(), {});
  CHECK(error_code([&] { dynamics.set_history(VectorXd(2)); }) == "history");
}

TEST_CASE("the D at hand is that of the last evaluation alone: of its pose, and where joints are driven of its time") {
  Dynamics driven(driven_chain(), unstabilized()), free(four_bar(), unstabilized());
  for (Dynamics* dynamics : {&driven, &free}) {
    const int nq = dynamics->system().q_size();
    VectorXd y = dynamics->initial_y();
    dynamics->evaluate(0.5, y);
    CHECK(dynamics->has_D_of(0.5, y.head(nq)));
    CHECK(dynamics->has_D_of(0.6, y.head(nq)) == (dynamics == &free));
    dynamics->begin_elsewhere(0.5, y);
    CHECK(!dynamics->has_D_of(0.5, y.head(nq)));
    dynamics->evaluate(0.5, y);
    y[nq] += 1.0;  // D is of the pose
    CHECK(dynamics->has_D_of(0.5, y.head(nq)));
    y[0] += 1e-15;
    CHECK(!dynamics->has_D_of(0.5, y.head(nq)));
  }
}
