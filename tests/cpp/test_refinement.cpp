#include "linkwork/constraints/refinement.hpp"

#include "dense_algebra.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

struct Problem {
  Model model;
  System system;
  Evaluation at;
  VectorXd a, b, x, lambda;  ///< with the solution of the dense equations
  MatrixXd M, D;

  Problem(Model given, Random& random)
      : model(std::move(given)), system(model), at(evaluate_initially(system)), M(dense_M(model)) {
    D = dense_D(system, at);
    a = random.vector(system.v_size());
    b = random.vector(system.row_count());
    VectorXd right(a.size() + b.size());
    right << a, b;
    const VectorXd solution = dense_solution(kkt(M), right);
    x = solution.head(a.size());
    lambda = -solution.tail(b.size());
  }
  MatrixXd kkt(const MatrixXd& mass) const { return dense_kkt(mass, D, VectorXd::Zero(D.rows())); }

  /// Solves with another mass matrix.
  Refinement::Nearby nearby(const MatrixXd& mass) const {
    return [K = kkt(mass)](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx, MutableVector dlambda) {
      VectorXd right(r_1.size() + r_2.size());
      right << r_1, r_2;
      const VectorXd out = dense_solution(K, right);
      dx = out.head(r_1.size());
      dlambda = -out.tail(r_2.size());
    };
  }
};

}  // namespace

TEST_CASE("one correction by the exact matrix is the solution, from anywhere") {
  Random random(41);
  const Problem problem(random_chain(random, 4, "spherical"), random);
  Refinement refinement(problem.system, characteristic_lengths(problem.system));
  VectorXd x = random.vector(problem.x.size()), lambda = random.vector(problem.lambda.size());
  refinement.correct(problem.at, problem.a, problem.b, x, lambda, problem.nearby(problem.M));
  CHECK(relative_error(x, problem.x) < 1e-11);
  CHECK(relative_error(lambda, problem.lambda) < 1e-11);
}

TEST_CASE("corrections by a nearby mass matrix shrink the error by the share of its difference") {
  Random random(42);
  const Problem problem(random_chain(random, 4, "spherical"), random);
  Refinement refinement(problem.system, characteristic_lengths(problem.system));
  const auto nearby = problem.nearby(1.25 * problem.M);  // M^ = M / (1 - 1/5): a fifth of the free motions is left
  VectorXd x = VectorXd::Zero(problem.x.size()), lambda = VectorXd::Zero(problem.lambda.size());
  refinement.correct(problem.at, problem.a, problem.b, x, lambda, nearby);
  const double first = (x - problem.x).norm();
  refinement.correct(problem.at, problem.a, problem.b, x, lambda, nearby);
  CHECK((x - problem.x).norm() == doctest::Approx(0.2 * first).epsilon(1e-8));
}

TEST_CASE("refinement goes on to roundoff, however wrong the inertias of its solver are") {
  Random random(43);
  const Problem problem(random_chain(random, 4, "spherical"), random);
  for (const double factor : {1.3, 30.0}) {
    MatrixXd mass = problem.M;
    mass.bottomRightCorner(6, 6) *= factor;  // of the last body: conjugate gradients where it is far off
    Refinement refinement(problem.system, characteristic_lengths(problem.system));
    const auto nearby = problem.nearby(mass);
    VectorXd x(problem.x.size()), lambda(problem.lambda.size());
    nearby(problem.a, problem.b, x, lambda);
    REQUIRE(relative_error(x, problem.x) > 1e-3);
    CHECK(refinement.refine(problem.at, problem.a, problem.b, x, lambda, nearby, Inexactness::inertia));
    CHECK(relative_error(x, problem.x) < 1e-11);
    CHECK(relative_error(lambda, problem.lambda) < 1e-10);
  }
}
