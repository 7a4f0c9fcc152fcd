#include "linkwork/constraints/mass_weighted_least_squares.hpp"

#include "dense_algebra.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

struct Solution {
  VectorXd x, lambda;
};

Solution solve(MassWeightedLeastSquares& solver, const Evaluation& at, const VectorXd& e, const VectorXd& a,
               const VectorXd& b) {
  Solution out{VectorXd(a.size()), VectorXd(b.size())};
  REQUIRE(solver.factorize(at, e));
  solver.solve(a, b, out.x, out.lambda);
  return out;
}

}  // namespace

TEST_CASE("solutions are those of the dense matrix [M D^T; D -E]") {
  Random random(31);
  const Model model = random_chain(random, 5, "revolute");
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
  const VectorXd e = VectorXd::Constant(system.row_count(), 1e-3);
  MassWeightedLeastSquares solver(system);
  const Solution found = solve(solver, at, e, a, b);
  VectorXd right(a.size() + b.size());
  right << a, b;
  const VectorXd expected = dense_solution(dense_kkt(dense_M(model), dense_D(system, at), e), right);
  CHECK(relative_error(found.x, VectorXd(expected.head(a.size()))) < 1e-10);
  CHECK(relative_error(found.lambda, VectorXd(-expected.tail(b.size()))) < 1e-10);
}

TEST_CASE("weights multiply masses and inertias: a heavy body yields less to a constraint") {
  Model model;
  model.add_body("left", body_at({0, 0, 0}));
  model.add_body("right", body_at({1, 0, 0}));
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> P(0, 0, 0), Q(1, 0, 0);
  model.add_joint("distance", "rod", 0, 1, place(model, 0, 1, P, Q, I, I), {{1.0, -1}});
  const System system(model);
  MassWeightedLeastSquares solver(system, Eigen::Vector2d(1.0, 3.0));
  const Evaluation at = evaluate_initially(system);
  // The rod is to lengthen at a rate: the bodies share it in inverse proportion to 1 and 3.
  const Solution found = solve(solver, at, VectorXd::Zero(1), VectorXd::Zero(12), VectorXd::Ones(1));
  CHECK(found.x[0] / found.x[6] == doctest::Approx(-3.0).epsilon(1e-14));
}

TEST_CASE("a massless body gets a mass, the mean of the others, so that there is a metric") {
  Model model = four_bar();
  std::vector<Body> bodies = model.bodies();
  bodies[0].mass = 2.0;
  bodies[1].mass = 0.0;
  bodies[1].inertia.setZero();
  bodies[2].mass = 4.0;
  const System system(model.with_masses(bodies));
  MassWeightedLeastSquares solver(system);
  CHECK(solver.system().massless_bodies().empty());
  CHECK(solver.system().mass(1) == doctest::Approx(3.0));
  CHECK(solver.system().mass(0) == 2.0);
}

TEST_CASE("in the metric of geometry velocities of natural size count alike") {
  Random random(33);
  const System system(random_chain(random, 3, "universal"));
  MassWeightedLeastSquares solver = MassWeightedLeastSquares::of_geometry(system, system.model().initial_q());
  const VectorXd scale = velocity_scale(system);
  for (int body = 0; body < 3; ++body) {
    CHECK(solver.system().mass(body) * scale[6 * body] * scale[6 * body] == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(solver.system().inertia(body).isIdentity(0.0));
  }
}

TEST_CASE("redundant rows without compliance have no factorization, and that is said") {
  const System system(four_bar());
  MassWeightedLeastSquares solver(system);
  CHECK(!solver.factorize(evaluate_initially(system), VectorXd::Zero(system.row_count())));
}
