#include "linkwork/integration/energies_made.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double stiffness = 50.0, mass = 2.0;

Model two_bodies() {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = mass;
  for (const char* name : {"first", "second"}) model.add_body(name, body);
  return model;
}

void spring(Model& model, int body, double damping, Parameter actuator = {0.0, -1}) {
  Attachment<double> at;
  at.s_i << 0.0, 0.0, -1.0;
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring of " + std::to_string(body), ground, body, at,
                  {{stiffness, -1}, {damping, -1}, {1.0, -1}, actuator});
}

/// Steps of 1 s in which the springs are stretched by `stretch` where a step begins and by `stretch_new` where it ends,
/// while bodies move with `speed` across.
std::vector<std::optional<EnergyMade>> found(const Model& model, const std::vector<std::array<double, 3>>& steps) {
  Dynamics dynamics(model, Options());
  std::vector<KeptStep> kept;
  for (const auto& [stretch, stretch_new, speed] : steps) {
    KeptStep step;
    step.t = double(kept.size());
    step.h = 1.0;
    step.y = step.y_new = dynamics.initial_y();
    for (const int body : {0, 1}) {
      step.y[7 * body + 2] = stretch;
      step.y_new[7 * body + 2] = stretch_new;
      step.y[14 + 6 * body] = step.y_new[14 + 6 * body] = speed;
    }
    kept.push_back(step);
  }
  std::vector<const KeptStep*> pointers;
  for (const KeptStep& step : kept) pointers.push_back(&step);
  return find_energies_made(dynamics, pointers, VectorXd::Ones(2));
}

}  // namespace

TEST_CASE("what a run makes is the largest difference of kinetic energy and potential from those at its start") {
  Model model = two_bodies();
  spring(model, 0, 0.0);
  const auto made = found(model, {{0.1, 0.1, 0.0}, {0.1, 0.3, 0.0}, {0.3, 0.3, 1.0}});
  const double potential = 0.5 * stiffness * (0.09 - 0.01), kinetic = 0.5 * mass;
  REQUIRE(made[0]);
  CHECK(made[0]->largest == doctest::Approx(potential + kinetic));
  CHECK(made[0]->exchanged == doctest::Approx(potential));
  const double integral = 0.5 * potential + (potential + kinetic), drift = 1.5 * (potential + kinetic);
  CHECK(made[0]->lasting == doctest::Approx(integral / drift));
  REQUIRE(made[1]);  // it is free
  CHECK(made[1]->largest == doctest::Approx(kinetic));
}

TEST_CASE("energy that nothing makes is rounding") {
  Model model = two_bodies();
  spring(model, 0, 0.0);
  const auto made = found(model, {{0.1, 0.1, 1.0}, {0.1, -0.1 - 4e-17, 1.0}});
  CHECK(made[0]->largest == 0.0);
}

TEST_CASE("parts in which forces may do work have none, whatever they do in these states") {
  Model damped = two_bodies();
  spring(damped, 0, 1.0);
  CHECK(found(damped, {{0.1, 0.2, 0.0}})[0]);  // it does not move along the damper
  Model driven = two_bodies();
  spring(driven, 0, 0.0, {0.0, driven.add_signal(harmonic(1.0, 3.0, 0.0, 0.0))});
  CHECK(!found(driven, {{0.1, 0.2, 0.0}})[0]);
  CHECK(found(driven, {{0.1, 0.2, 0.0}})[1]);
}

TEST_CASE("of a mechanism that is one connected part the balance of the run tells") {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = mass;
  model.add_body("alone", body);
  Dynamics dynamics(model, Options());
  KeptStep step;
  step.h = 1.0;
  step.y = step.y_new = dynamics.initial_y();
  CHECK(!find_energies_made(dynamics, {&step}, VectorXd::Ones(1))[0]);
}

TEST_CASE("inerters have a share of the energies of states near each other that move faster") {
  Model model = two_bodies();
  Attachment<double> at;
  at.s_i << 0.0, 0.0, -1.0;
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  const double inertance = 30.0, speed = 2.0, more = 1e-3;
  model.add_force("inerter", "rotor", ground, 0, at, {{inertance, -1}});
  Dynamics dynamics(model, Options());
  VectorXd y = dynamics.initial_y();
  y[14 + 2] = speed;  // along it
  VectorXd faster = y;
  faster[14 + 2] += more;
  dynamics.evaluate(0.0, y);
  const VectorXd v = y.segment(14, 12);
  CHECK(energies_in_inerters(dynamics.system(), dynamics.evaluation(), v)[0] ==
        doctest::Approx(0.5 * inertance * speed * speed));
  CHECK(energies_apart(dynamics.system(), dynamics.evaluation(), y, faster)[0] ==
        doctest::Approx((mass + inertance) * speed * more));
}

TEST_CASE("energies of two states near each other differ by what their forces would do, potential or not") {
  Model model(Vec3<double>(0.0, 0.0, -9.81));
  Body body;
  body.mass = mass;
  body.inertia = Vec3<double>(0.5, 0.7, 0.9).asDiagonal();
  for (const char* name : {"first", "second"}) model.add_body(name, body);
  spring(model, 0, 0.0);
  Dynamics dynamics(model, Options());
  const System& system = dynamics.system();
  VectorXd y = dynamics.initial_y(), way = VectorXd::Zero(y.size());
  for (Eigen::Index k = 0; k < y.size() - 1; ++k) {
    y[k] += 0.3 * std::sin(double(k));
    way[k] = std::cos(2.0 * double(k));
  }
  system.normalize(y.head(system.q_size()));
  const auto energy = [&](const VectorXd& at) {
    dynamics.evaluate(0.0, at);
    const auto v = at.segment(system.q_size(), system.v_size());
    return system.kinetic_energy(dynamics.evaluation(), v) + dynamics.evaluation().potential;
  };
  const double small = 1e-5;
  VectorXd before = y - small * way, after = y + small * way;
  for (VectorXd* it : {&before, &after}) system.normalize(it->head(system.q_size()));
  const double expected = energy(after) - energy(before);
  dynamics.evaluate(0.0, y);
  const VectorXd apart = energies_apart(system, dynamics.evaluation(), y, after) -
                         energies_apart(system, dynamics.evaluation(), y, before);
  CHECK(apart.size() == 2);
  CHECK(std::abs(apart[0]) > 0.1 * std::abs(expected));
  CHECK(apart.sum() == doctest::Approx(expected).epsilon(1e-6));
}
