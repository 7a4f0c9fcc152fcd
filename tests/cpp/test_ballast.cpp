#include "linkwork/linear/block/ballast.hpp"

#include <doctest/doctest.h>

#include "block_solver_checks.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

using namespace support;

namespace {

Body link(Random& random) {
  Body body = random_body(random);
  body.mass = 0.0;
  body.inertia.setZero();
  return body;
}

std::string any_kind(Random& random) {
  return joint_kinds()[random.integer(0, static_cast<int>(joint_kinds().size()) - 1)].info.name;
}

/// Massless links and bodies in turn; between them joints of one kind and welds, or welds and joints.
Model chain_with_links(Random& random, int bodies, const std::string& kind, bool weld_first) {
  Model model;
  for (int k = 0; k < bodies; ++k) {
    model.add_body("body" + std::to_string(k), k % 2 ? random_body(random) : link(random));
    add_joint(model, random, (k % 2 == 0) == weld_first ? "fixed" : kind, "joint" + std::to_string(k), k - 1, k);
  }
  return model;
}

/// A body on hinges, with massless links between them, about axes of space.
Model on_hinges(Random& random, const std::vector<Vec3<double>>& axes) {
  Model model;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const int body =
        model.add_body("body" + std::to_string(k), k + 1 < axes.size() ? link(random) : random_body(random));
    const Mat3<double> F = Eigen::Quaterniond::FromTwoVectors(Vec3<double>::UnitZ(), axes[k]).toRotationMatrix();
    const Vec3<double> P(0.1, 0.2, 0.3);
    model.add_joint("revolute", "hinge" + std::to_string(k), body - 1, body, place(model, body - 1, body, P, P, F, F));
  }
  return model;
}

/// The least inertia that joints leave a motion, relative to that of unit masses and moments.
double least_inertia(const System& system, const Evaluation& at) {
  const MatrixXd D = dense_D(system, at), M = dense_M(system.model());
  const MatrixXd P = MatrixXd::Identity(D.cols(), D.cols()) - D.transpose() * dense_inverse(D * D.transpose()) * D;
  return D.cols() > D.rows() ? singular_values(P * M * P)[D.cols() - D.rows() - 1] : 1.0;
}

bool factorizes_as_it_is(SaddleSolver& solver, const System& system) {
  const Evaluation at = evaluate_initially(system);
  REQUIRE(solver.analyze_as_it_is(system, at, system.massless_bodies()));
  try {
    solver.factorize(at, {});
  } catch (const SingularSystemError&) {
    return false;
  }
  return true;
}

void check_solves_as_it_is(SaddleSolver& solver, const System& system, Random& random) {
  const Evaluation at = evaluate_initially(system);
  const VectorXd e, a = random.vector(system.v_size()), b = random.vector(system.row_count());
  VectorXd x(a.size()), lambda(b.size()), x_again(a.size()), lambda_again(b.size());
  REQUIRE(solver.analyze_as_it_is(system, at, system.massless_bodies()));
  solver.factorize_and_solve(at, e, a, b, x, lambda);
  const auto [first, second] = residuals(system, at, VectorXd::Zero(b.size()), a, b, x, lambda);
  CHECK(first < 1e-11);
  CHECK(second < 1e-11);
  solver.solve(2.0 * a, 2.0 * b, x_again, lambda_again);
  CHECK(relative_error(x_again, 2.0 * x) < 1e-10);
  const MatrixXd D = dense_D(system, at), M = dense_M(system.model());
  MatrixXd K = MatrixXd::Zero(D.rows() + D.cols(), D.rows() + D.cols());
  K << M, -D.transpose(), D, MatrixXd::Zero(D.rows(), D.rows());
  VectorXd right(K.rows());
  right << a, b;
  const VectorXd exact = accurate_solution(K, right);
  CHECK(relative_error(x, exact.head(x.size())) < 1e-9);
  CHECK(relative_error(lambda, exact.tail(lambda.size())) < 1e-9);
}

}  // namespace

TEST_CASE("massless links with joints of every kind are eliminated as they are, on every instruction set") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(211);
    for (const JointKind& kind : joint_kinds())
      for (const bool weld_first : {true, false}) {
        INFO(kind.info.name, weld_first);
        check_solves_as_it_is(solver, System(chain_with_links(random, 8, kind.info.name, weld_first)), random);
      }
  });
}

TEST_CASE("trees of all joints are eliminated as they are wherever no motion is without inertia") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(212);
    constexpr int trials = sanitized ? 60 : 300;
    int solved = 0;
    for (int trial = 0; trial < trials; ++trial) {
      Model model(random.vec3(9.81));
      for (int body = 0; body < 9; ++body) {
        model.add_body("body" + std::to_string(body), random.number() < -0.5 ? link(random) : random_body(random));
        add_joint(model, random, any_kind(random), "joint" + std::to_string(body), random.integer(ground, body - 1),
                  body);
      }
      const System system(model);
      if (system.massless_bodies().empty() || least_inertia(system, evaluate_initially(system)) < 1e-3) continue;
      if (!factorizes_as_it_is(solver, system)) continue;
      check_solves_as_it_is(solver, system, random);
      ++solved;
    }
    CHECK(solved > trials / 30);
  });
}

TEST_CASE("hinges with massless links between them turn a body, and where two axes are one, that is told") {
  const Vec3<double> x = Vec3<double>::UnitX(), y = Vec3<double>::UnitY(), z = Vec3<double>::UnitZ();
  for_every_instruction_set([&](SaddleSolver& solver) {
    Random random(213);
    for (const double angle : {1.0, 0.5}) {
      INFO(angle);
      check_solves_as_it_is(solver, System(on_hinges(random, {x, y, x * std::cos(angle) + z * std::sin(angle)})),
                            random);
    }
    const System locked(on_hinges(random, {x, y, x}));
    const Evaluation at = evaluate_initially(locked);
    REQUIRE(solver.analyze_as_it_is(locked, at, locked.massless_bodies()));
    CHECK_THROWS_AS(solver.factorize(at, {}), SingularSystemError);
  });
}

TEST_CASE("a ballast is as much as what a branch carries, and that of bodies in loops is none of branches") {
  Random random(214);
  const Model model = on_hinges(random, {Vec3<double>::UnitX(), Vec3<double>::UnitY(), Vec3<double>::UnitZ()});
  const std::vector<block::Ballast> found =
      block::ballasts(model, block::SymbolicFactorization(System(model)).steps, model.row_count());
  REQUIRE(found.size() == 3);
  for (const block::Ballast& it : found) {
    CHECK(1.0 / it.inverse_mass == doctest::Approx(model.bodies()[2].mass));
    CHECK(it.least_mass * it.inverse_mass == doctest::Approx(1e-3));
    CHECK(it.least_moment * it.inverse_moment == doctest::Approx(1e-3));
    CHECK(1.0 / it.inverse_moment >= model.bodies()[2].inertia.diagonal().maxCoeff());
  }
}

TEST_CASE("massless bodies in closed loops are not eliminated as they are") {
  Random random(215);
  Model model = on_hinges(random, {Vec3<double>::UnitX(), Vec3<double>::UnitY(), Vec3<double>::UnitZ()});
  add_joint(model, random, "spherical", "closing", ground, 2);
  const System system(model);
  CHECK_FALSE(block::make_block_solver()->analyze_as_it_is(system, evaluate_initially(system), {0, 1}));
}
