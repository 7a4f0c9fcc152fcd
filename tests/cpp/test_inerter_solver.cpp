#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// A tree with inertia along its first coordinates, small and large.
Model with_inerters(Random& random) {
  Model model = random_tree(random, 4);
  double b = 1e-3;
  for (const char* kind : {"inerter", "rotational_inerter", "translational_inerter"}) {
    model.add_force(kind, kind, 0, 3, random_attachment(random), {{b, -1}});
    b *= 100.0;
  }
  return model;
}

MatrixXd dense_mass(const System& system, const Evaluation& at) {
  MatrixXd M(system.v_size(), system.v_size());
  VectorXd column(system.v_size());
  for (Eigen::Index k = 0; k < M.cols(); ++k) {
    system.multiply_mass(at, VectorXd::Unit(M.cols(), k), column);
    M.col(k) = column;
  }
  return M;
}

}  // namespace

TEST_CASE("every solver solves with the mass matrix that inerters are part of") {
  Random random(311);
  const System system(with_inerters(random));
  const Evaluation at = evaluate_initially(system);
  const MatrixXd M = dense_mass(system, at), D = dense_D(system, at);
  const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
  for (const MatrixForm& form : matrix_forms())
    for (const LinearSolverInfo& info : linear_solvers()) {
      if (!info.available() || !can_solve(form.name, info)) continue;
      INFO(form.name, " by ", info.name);
      const bool plain = std::string(form.name) == "kkt" && !info.make_saddle;  // E = 0 there
      const VectorXd e = VectorXd::Constant(b.size(), plain ? 0.0 : 0.02);
      const auto solver = make_saddle_solver(form.name, info, system);
      solver->analyze(system, at);
      VectorXd right(a.size() + b.size()), x(a.size()), lambda(b.size());
      right << a, b;
      MatrixXd K(right.size(), right.size());
      K << M, D.transpose(), D, -MatrixXd(e.asDiagonal());
      const VectorXd expected = dense_solution(K, right);
      solver->factorize(at, e);
      solver->solve(a, b, x, lambda);
      CHECK(relative_error(x, expected.head(a.size())) < 1e-9);
      solver->factorize_and_solve(at, e, a, b, x, lambda);
      CHECK(relative_error(x, expected.head(a.size())) < 1e-9);
      VectorXd left(a.size());
      system.multiply_mass(at, x, left);
      left -= D.transpose() * lambda;
      CHECK(relative_error(left, a) < 1e-9);
      CHECK(solver->smallest_pivot() > 0.0);
      CHECK(solver->factor_nonzeros() > 0);
    }
}

TEST_CASE("without inerters nothing stands between") {
  Random random(312);
  const System system(random_tree(random, 3));
  const Evaluation at = evaluate_initially(system);
  const auto solver = make_saddle_solver("kkt", linear_solver_info("block"), system);
  solver->analyze(system, at);
  const auto plain = make_saddle_solver("kkt", linear_solver_info("block"));
  plain->analyze(system, at);
  CHECK(solver->factor_nonzeros() == plain->factor_nonzeros());
}
