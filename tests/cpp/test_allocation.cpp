#include <doctest/doctest.h>

#include "allocation_counter.hpp"
#include "integrators.hpp"

#if CAN_COUNT_ALLOCATIONS

using namespace support;

namespace {

/// All joints and all forces, some driven by functions of time.
Model everything() {
  Random random(70);
  Model model;
  int body = ground;
  for (const JointKind& kind : joint_kinds()) {
    model.add_body("body " + kind.info.name, random_body(random));
    add_joint(model, random, kind.info.name, kind.info.name, body, body + 1);
    body += 1;
  }
  const int signal = model.add_signal(harmonic(0.1, 1.0, 0.0, 1.0));
  for (const ForceKind& kind : force_kinds())
    model.add_force(kind.info.name, kind.info.name, 0, 1, random_attachment(random),
                    force_parameters(model, random, kind.info));
  model.add_joint("distance", "driven", ground, body, random_attachment(random), {{0.0, signal}});
  return model;
}

struct Solver {
  std::string formulation, system, linear_solver;
};

/// Bodies around a hub, each joined to it and to the next: loops, and more joints on one body than are eliminated after
/// it. With `doubled` joints, equations that depend on the others.
Model ring(const char* kind, int bodies, bool doubled) {
  Random random(71);
  Model model;
  model.add_body("hub", random_body(random));
  add_joint(model, random, "revolute", "axle", ground, 0);
  for (int body = 1; body <= bodies; ++body) {
    model.add_body("arm" + std::to_string(body), random_body(random));
    add_joint(model, random, "spherical", "shoulder" + std::to_string(body), 0, body);
    if (body > 1) add_joint(model, random, kind, "loop" + std::to_string(body), body - 1, body);
    if (doubled && body == bodies) {
      const Element last = model.joints().back();
      model.add_joint(kind, "again", last.i, last.j, last.at, {model.joint_parameters().back()});
    }
  }
  return model;
}

/// Allocations of an evaluation and a solution after the first few.
long allocations_of(const Solver& solver, const Model& model) {
  Options options;
  options.formulation = solver.formulation;
  options.matrix_form = solver.system;
  options.linear_solver = solver.linear_solver;
  Dynamics dynamics(model, options);
  const VectorXd y = dynamics.initial_y();
  VectorXd v_dot(dynamics.system().v_size()), lambda(dynamics.system().row_count());
  const auto cycle = [&] {
    dynamics.evaluate(0.1, y);
    dynamics.accelerations(v_dot, lambda);
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) cycle();
  return allocations(cycle);
}

/// Not in a build without SuiteSparse.
bool has_klu() {
  const auto& all = linear_solvers();
  return std::any_of(all.begin(), all.end(), [](const auto& it) { return it.name == "klu" && it.available(); });
}

}  // namespace

TEST_CASE("the counter sees allocations by new and by Eigen") {
  std::vector<int> numbers;
  VectorXd x;
  CHECK(allocations([&] {
          numbers.resize(100);
          asm volatile("" : : "r"(numbers.data()) : "memory");  // else Clang leaves it out
        }) == 1);
  CHECK(allocations([&] { x.resize(100); }) == 1);
}

TEST_CASE("an evaluation does not allocate after the first") {
  const Model model = everything();
  const System system(model);
  Evaluation at = evaluate_initially(system);
  const VectorXd q = model.initial_q(), v = model.initial_v();
  CHECK(allocations([&] { system.evaluate(0.1, q, v, system.initial_history(), at); }) == 0);
}

TEST_CASE("products with M and D do not allocate") {
  const Model model = everything();
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  VectorXd x = model.initial_v(), y(system.v_size()), lambda(system.row_count());
  CHECK(allocations([&] {
          system.multiply_mass(at, x, y);
          system.multiply_inverse_mass(y, x);
          system.multiply_D(at, x, lambda);
          system.add_D_transposed(at, lambda, y);
        }) == 0);
}

TEST_CASE("a factorization and solution by dense Cholesky or KLU does not allocate after the first few") {
  for (const Solver& solver :
       {Solver{"standard", "schur", "dense"}, Solver{"standard", "schur", "klu"}, Solver{"standard", "kkt", "klu"},
        Solver{"penalty", "auto", "dense"}, Solver{"augmented_lagrangian", "auto", "dense"}}) {
    if (std::string(solver.linear_solver) == "klu" && !has_klu()) continue;
    INFO(solver.formulation, " ", solver.system, " ", solver.linear_solver);
    CHECK(allocations_of(solver, everything()) == 0);
  }
}

TEST_CASE("the block solver does not allocate after the first few solutions, with loops, hubs and redundancy either") {
  for (const char* formulation : {"standard", "penalty", "augmented_lagrangian"})
    for (const Model& model :
         {everything(), ring("distance", 4, false), ring("distance", 20, false), ring("distance", 5, true)}) {
      INFO(std::string(formulation), " ", model.joints().size(), " joints");
      CHECK(allocations_of({formulation, "auto", "block"}, model) == 0);
    }
}

TEST_CASE("a trial step, its interpolation and a half-explicit step do not allocate after the first") {
  Options options;
  options.linear_solver = "dense";
  options.matrix_form = "schur";
  Dynamics dynamics(spherical_pendulum(), options);
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
  Dynamics bare(spherical_pendulum(), options);
  const auto method = make_half_explicit(half_explicit_heun());
  method->start(bare.y_size());
  const VectorXd start = bare.initial_y();
  const auto step = [&] {
    y = start;
    bare.evaluate(0.0, y);
    method->step(bare, {0.0, 1e-3}, y);
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) step();
  CHECK(allocations(step) == 0);
}

#endif
