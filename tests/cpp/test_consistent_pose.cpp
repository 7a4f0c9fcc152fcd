#include "linkwork/constraints/consistent_pose.hpp"

#include "linkwork/constraints/displacement.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

struct Loops {
  System system;
  Evaluation at;
  ClosedLoops loops;
  MassWeightedLeastSquares solver;
  explicit Loops(const Model& model)
      : system(model), at(evaluate_initially(system)), loops(system, at, 1e-9), solver(system) {}

  double violation(const VectorXd& q) {
    system.evaluate_constraints(0.0, q, VectorXd::Zero(system.v_size()), system.initial_history(), at);
    return at.Phi.cwiseAbs().maxCoeff();
  }
};

}  // namespace

TEST_CASE("positions off redundant constraints are projected onto all of them") {
  Random random(121);
  Loops it(four_bar());
  VectorXd q = it.system.model().initial_q();
  displace(it.system, random.vector(18, 0.02), q);
  REQUIRE(it.violation(q) > 1e-3);
  const ConsistentPose found = project_positions(it.solver, it.loops, {0.0, q, it.system.initial_history()});
  CHECK(found.reached == std::vector<char>{1});
  CHECK(it.violation(found.q) < 1e-12);
}

TEST_CASE("loops that cannot close come to rest where the squares of their residuals are least, others close") {
  Model model = four_bar();
  model.add_body("plate", body_at({0, 0, 5}));
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_joint("spherical", "low", ground, 3, {Vec3<double>(0, 0, 4), Vec3<double>(0, 0, -1), I, I});
  model.add_joint("spherical", "high", ground, 3, {Vec3<double>(0, 0, 9), Vec3<double>(0, 0, 1), I, I});  // 3 m apart
  Loops it(model);
  VectorXd q = model.initial_q();
  q[0] += 1e-3;
  const ConsistentPose found = project_positions(it.solver, it.loops, {0.0, q, it.system.initial_history()});
  CHECK(found.q[23] == doctest::Approx(6.5).epsilon(1e-6));  // between 5 and 8
  CHECK(found.reached == std::vector<char>{1, 1});           // at rest
  CHECK(it.violation(found.q) > 1.4);                        // and not closed
  CHECK(it.at.Phi.head(20).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a random allowed velocity satisfies D v = 0, and is the same for the same seed") {
  Loops it(four_bar());
  const VectorXd v = random_allowed_velocity(it.solver, it.loops, it.at, 7);
  CHECK(v.norm() > 1e-3);
  CHECK((dense_D(it.system, it.at) * v).cwiseAbs().maxCoeff() < 1e-9 * v.norm());
  CHECK(random_allowed_velocity(it.solver, it.loops, it.at, 7) == v);
  CHECK(random_allowed_velocity(it.solver, it.loops, it.at, 8) != v);
}

TEST_CASE("a perturbed pose lies on the constraints, away from where it was; what is locked stays") {
  Loops it(four_bar());
  const VectorXd q = it.system.model().initial_q();
  const PerturbedPose found = perturb(it.solver, it.loops, q, {1}, it.at);
  CHECK(found.mobile == std::vector<char>{1});
  CHECK(found.reached == std::vector<char>{1});
  CHECK(it.violation(found.q) < 1e-12);
  CHECK((found.q - q).norm() > 1e-3);
  CHECK(perturb(it.solver, it.loops, q, {0}, it.at).q == q);
}

TEST_CASE("the perturbed pose of a long row of loops satisfies its constraints but for roundoff of positions") {
  Loops it(ladder(300));
  const VectorXd q = it.system.model().initial_q();
  const PerturbedPose found = perturb(it.solver, it.loops, q, {1}, it.at);
  CHECK(found.reached == std::vector<char>{1});
  CHECK(it.violation(found.q) < 1e-12);  // at 300 m
  CHECK((found.q - q).cwiseAbs().maxCoeff() > 1e-2);
}
