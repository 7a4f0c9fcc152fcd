#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// A system, its matrices at the initial state, and a random right-hand side.
struct Problem {
  Problem(const Model& model, Random& random)
      : system(model),
        at(evaluate_initially(system)),
        M(dense_M(model)),
        D(dense_D(system, at)),
        a(random.vector(system.v_size())),
        b(random.vector(system.row_count())) {}

  /// (x, lambda) by elimination with full pivoting.
  std::pair<VectorXd, VectorXd> solve_densely(const VectorXd& e) const {
    const auto n = M.rows(), m = D.rows();
    MatrixXd K(n + m, n + m);
    K << M, D.transpose(), D, -MatrixXd(e.asDiagonal());
    VectorXd right(n + m);
    right << a, b;
    const VectorXd x = dense_solution(K, right);
    return {x.head(n), -x.tail(m)};
  }

  System system;
  Evaluation at;
  MatrixXd M, D;
  VectorXd a, b;
};

void check_agrees(SaddleSolver& solver, const Problem& problem, const VectorXd& e, double tolerance) {
  solver.factorize(problem.at, e);
  VectorXd x(problem.system.v_size()), lambda(problem.system.row_count());
  solver.solve(problem.a, problem.b, x, lambda);
  const auto [x_dense, lambda_dense] = problem.solve_densely(e);
  CHECK(relative_error(x, x_dense) < tolerance);
  CHECK(relative_error(lambda, lambda_dense) < tolerance);
  CHECK(solver.smallest_pivot() > 0.0);
}

/// Runs a check for a form with every solver of this build that can factorize it.
template <class Check>
void for_every_solver(const std::string& form, Check check) {
  for (const LinearSolverInfo& info : linear_solvers()) {
    if (!info.make || !can_solve(form, info)) continue;
    INFO(form, " by ", info.name);
    check(info);
  }
}

/// Positive numbers of mixed size.
VectorXd random_compliance(const System& system, Random& random) {
  return (random.vector(system.row_count()).array() * 3.0 - 3.0).exp();
}

/// A tree with a joint closing a loop.
Model random_loop(Random& random) {
  Model model = random_tree(random, 5);
  add_joint(model, random, "distance", "closing", 4, 0);
  return model;
}

/// A pendulum whose hinge is there twice, the second time at another point of its axis and with other x and y axes: the
/// rows depend on each other, and none is equal to another.
Model doubled_hinge(Random& random) {
  Model model;
  model.add_body("bob", random_body(random));
  model.add_body("other", random_body(random));
  const Vec3<double> P = random.vec3();
  const Mat3<double> F = random.frame(), turned = F * rotation_matrix<double>(exponential(Vec3<double>(0, 0, 0.4)));
  const Vec3<double> Q = P + 0.7 * F.col(2);
  add_joint(model, random, "spherical", "ball", 0, 1);
  model.add_joint("revolute", "hinge", ground, 0, place(model, ground, 0, P, P, F, F));
  model.add_joint("revolute", "again", ground, 0, place(model, ground, 0, Q, Q, turned, turned));
  return model;
}

}  // namespace

TEST_CASE("kkt agrees with a dense solution of [M D^T; D 0]") {
  for_every_solver("kkt", [](const LinearSolverInfo& info) {
    Random random(110);
    for (int repetition = 0; repetition < 5; ++repetition) {
      const Problem problem(random_loop(random), random);
      const auto solver = make_saddle_solver("kkt", info);
      solver->analyze(problem.system, problem.at);
      check_agrees(*solver, problem, VectorXd::Zero(problem.system.row_count()), 1e-9);
    }
  });
}

TEST_CASE("schur agrees with a dense solution of [M D^T; D -E], E = 0 included") {
  for_every_solver("schur", [](const LinearSolverInfo& info) {
    Random random(111);
    for (int repetition = 0; repetition < 5; ++repetition) {
      const Problem problem(random_loop(random), random);
      const auto solver = make_saddle_solver("schur", info);
      solver->analyze(problem.system, problem.at);
      check_agrees(*solver, problem, VectorXd::Zero(problem.system.row_count()), 1e-9);
      check_agrees(*solver, problem, random_compliance(problem.system, random), 1e-9);
    }
  });
}

TEST_CASE("normal agrees with a dense solution of [M D^T; D -E]") {
  for_every_solver("normal", [](const LinearSolverInfo& info) {
    Random random(112);
    for (int repetition = 0; repetition < 5; ++repetition) {
      const Problem problem(random_loop(random), random);
      const auto solver = make_saddle_solver("normal", info);
      solver->analyze(problem.system, problem.at);
      check_agrees(*solver, problem, random_compliance(problem.system, random), 1e-9);
    }
  });
}

TEST_CASE("normal and a compliant schur solve with redundant rows") {
  for (const char* form : {"normal", "schur"})
    for_every_solver(form, [&](const LinearSolverInfo& info) {
      Random random(113);
      const Problem problem(doubled_hinge(random), random);
      const auto solver = make_saddle_solver(form, info);
      solver->analyze(problem.system, problem.at);
      check_agrees(*solver, problem, random_compliance(problem.system, random), 1e-9);
    });
}

TEST_CASE("normal solves with massless bodies that joints hold") {
  for_every_solver("normal", [](const LinearSolverInfo& info) {
    Random random(114);
    Model model;
    Body ghost = random_body(random);
    ghost.mass = 0.0;
    ghost.inertia.setZero();
    model.add_body("solid", random_body(random));
    model.add_body("ghost", ghost);
    add_joint(model, random, "revolute", "hinge", ground, 0);
    add_joint(model, random, "fixed", "weld", 0, 1);
    const Problem problem(model, random);
    const auto solver = make_saddle_solver("normal", info);
    solver->analyze(problem.system, problem.at);
    check_agrees(*solver, problem, random_compliance(problem.system, random), 1e-9);
  });
}

TEST_CASE("a second factorization at another state forgets the first") {
  for (const char* form : {"kkt", "schur", "normal"})
    for_every_solver(form, [&](const LinearSolverInfo& info) {
      Random random(115);
      Problem problem(random_loop(random), random);
      const VectorXd e = std::string(form) == "kkt" ? VectorXd::Zero(problem.system.row_count())
                                                    : random_compliance(problem.system, random);
      const auto solver = make_saddle_solver(form, info);
      solver->analyze(problem.system, problem.at);
      solver->factorize(problem.at, e);
      const VectorXd q = moved(problem.system.model().initial_q(), random.vector(30), VectorXd::Zero(30), 0.1);
      problem.system.evaluate(0.0, q, problem.system.model().initial_v(), problem.system.initial_history(), problem.at);
      problem.D = dense_D(problem.system, problem.at);
      check_agrees(*solver, problem, e, 1e-9);
    });
}

TEST_CASE("a hinge that is there twice is a SingularSystemError in kkt and schur") {
  for (const char* form : {"kkt", "schur"})
    for_every_solver(form, [&](const LinearSolverInfo& info) {
      Random random(116);
      for (int repetition = 0; repetition < 20; ++repetition) {
        const Problem problem(doubled_hinge(random), random);
        const auto solver = make_saddle_solver(form, info);
        solver->analyze(problem.system, problem.at);
        CHECK_THROWS_AS(solver->factorize(problem.at, VectorXd::Zero(problem.system.row_count())), SingularSystemError);
      }
    });
}

TEST_CASE("the error of schur for a hinge that is there twice names one of the two, where the solver tells the row") {
  for (const char* name : {"dense", "cholmod", "cholmod_simplicial", "cholmod_supernodal", "eigen_ldlt"}) {
    if (first_available({name, "dense"}) != name) continue;
    INFO(std::string(name));
    Random random(117);
    const Problem problem(doubled_hinge(random), random);
    const auto solver = make_saddle_solver("schur", linear_solver_info(name));
    solver->analyze(problem.system, problem.at);
    try {
      solver->factorize(problem.at, VectorXd::Zero(problem.system.row_count()));
      FAIL_CHECK("no error");
    } catch (const SingularSystemError& error) {
      INFO(std::string(error.what()));
      const std::string joint = error.details.joints.empty() ? "none" : error.details.joints.front();
      CHECK((joint == "hinge" || joint == "again"));
      CHECK(std::string(error.what()).find("'" + joint + "'") != std::string::npos);
    }
  }
}

TEST_CASE("the error of a singular matrix advises what is not done yet") {
  Random random(118);
  const Problem problem(doubled_hinge(random), random);
  const auto solver = make_saddle_solver("kkt", linear_solver_info("block"));
  solver->analyze(problem.system, problem.at);
  for (const auto& [compliance, advice] :
       {std::pair{0.0, "formulation 'augmented_lagrangian'"}, {1e-30, "a smaller penalty_scale"}})
    try {
      solver->factorize(problem.at, VectorXd::Constant(problem.system.row_count(), compliance));
      FAIL_CHECK("no error");
    } catch (const SingularSystemError& error) {
      CHECK(std::string(error.what()).find(advice) != std::string::npos);
    }
}

TEST_CASE("a massless body that nothing holds is a SingularSystemError of normal") {
  for_every_solver("normal", [](const LinearSolverInfo& info) {
    Random random(118);
    Model model;
    Body ghost = random_body(random);
    ghost.mass = 0.0;
    model.add_body("solid", random_body(random));
    model.add_body("ghost", ghost);
    add_joint(model, random, "revolute", "hinge", ground, 0);
    const Problem problem(model, random);
    const auto solver = make_saddle_solver("normal", info);
    solver->analyze(problem.system, problem.at);
    CHECK_THROWS_AS(solver->factorize(problem.at, VectorXd::Ones(problem.system.row_count())), SingularSystemError);
  });
}

TEST_CASE("the pivots of kkt and schur do not change with the units of mass and length") {
  for (const char* form : {"kkt", "schur"}) {
    const auto smallest_pivot = [&](double mass, double length) {
      Random random(119);
      Model model;
      for (int body = 0; body < 3; ++body) {
        Body link = random_body(random);
        link.mass *= mass;
        link.inertia *= mass * length * length;
        link.position *= length;
        model.add_body("link" + std::to_string(body), link);
        const Vec3<double> P = length * random.vec3();
        const Mat3<double> F = random.frame();
        model.add_joint("revolute", "hinge" + std::to_string(body), body - 1, body,
                        place(model, body - 1, body, P, P, F, F));
      }
      const Problem problem(model, random);
      const auto solver = make_saddle_solver(form, linear_solver_info("dense"));
      solver->analyze(problem.system, problem.at);
      solver->factorize(problem.at, VectorXd::Zero(problem.system.row_count()));
      return solver->smallest_pivot();
    };
    INFO(std::string(form));
    CHECK(smallest_pivot(1e3, 1e3) == doctest::Approx(smallest_pivot(1.0, 1.0)).epsilon(1e-9));
  }
}

TEST_CASE("a solver of positive definite systems is refused for kkt, an unknown form always") {
  for (const LinearSolverInfo& info : linear_solvers())
    if (info.positive_definite) CHECK_THROWS_AS(make_saddle_solver("kkt", info), OptionError);
  CHECK_THROWS_AS(make_saddle_solver("lkk", linear_solver_info("dense")), OptionError);
}
