#include <doctest/doctest.h>

#include "allocation_counter.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "support.hpp"

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
                    std::vector<Parameter>(kind.info.parameters.size(), Parameter{0.0, signal}));
  model.add_joint("distance", "driven", ground, body, random_attachment(random), {{0.0, signal}});
  return model;
}

struct Solver {
  std::string formulation, system, linear_solver;
};

/// Allocations of an evaluation and a solution after the first few.
long allocations_of(const Solver& solver) {
  Options options;
  options.formulation = solver.formulation;
  options.system = solver.system;
  options.linear_solver = solver.linear_solver;
  Dynamics dynamics(everything(), options);
  const VectorXd y = dynamics.initial_y();
  VectorXd v_dot(dynamics.system().v_size()), lambda(dynamics.system().row_count());
  const auto cycle = [&] {
    dynamics.evaluate(0.1, y);
    dynamics.accelerations(v_dot, lambda);
  };
  for (int warm_up = 0; warm_up < 3; ++warm_up) cycle();
  return allocations(cycle);
}

}  // namespace

TEST_CASE("the counter sees allocations by new and by Eigen") {
  std::vector<int> numbers;
  VectorXd x;
  CHECK(allocations([&] { numbers.resize(100); }) == 1);
  CHECK(allocations([&] { x.resize(100); }) == 1);
}

TEST_CASE("an evaluation does not allocate after the first") {
  const Model model = everything();
  const System system(model);
  Evaluation at = evaluate_initially(system);
  const VectorXd q = model.initial_q(), v = model.initial_v();
  CHECK(allocations([&] { system.evaluate(0.1, q, v, at); }) == 0);
}

TEST_CASE("products with M and D do not allocate") {
  const Model model = everything();
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  VectorXd x = model.initial_v(), y(system.v_size()), lambda(system.row_count());
  CHECK(allocations([&] {
          system.multiply_mass(x, y);
          system.multiply_inverse_mass(y, x);
          system.multiply_D(at, x, lambda);
          system.add_D_transposed(at, lambda, y);
        }) == 0);
}

TEST_CASE("a factorization and solution by dense Cholesky or KLU does not allocate after the first few") {
  for (const Solver& solver :
       {Solver{"standard", "schur", "dense"}, Solver{"standard", "schur", "klu"}, Solver{"standard", "kkt", "klu"},
        Solver{"penalty", "auto", "dense"}, Solver{"augmented_lagrangian", "auto", "dense"}}) {
    INFO(solver.formulation, " ", solver.system, " ", solver.linear_solver);
    CHECK(allocations_of(solver) == 0);
  }
}

#endif
