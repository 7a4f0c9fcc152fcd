#include <cmath>

#include "linkwork/linear/block/symbolic_factorization.hpp"

#include "block_solver_checks.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// Bodies on hinges and sliders on the ground, some with branches; each is joined to the next by a body, or a rod.
Model grounded_bodies(Random& random, int count, bool branches) {
  Model model;
  for (int k = 0; k < count; ++k) {
    const std::string number = std::to_string(k);
    const int body = model.add_body("body" + number, random_body(random));
    const char* kind = k % 4 == 1 ? "translational" : "revolute";
    if (k % 4 == 3) continue;
    if (k % 3) add_joint(model, random, kind, "guide" + number, ground, body);
    else add_joint(model, random, kind, "guide" + number, body, ground);
  }
  for (int k = 0; k < count; ++k) {
    const std::string number = std::to_string(k);
    const int next = (k + 1) % count;
    if (k % 2 == 0) {
      add_joint(model, random, "distance", "rod" + number, k, next);
    } else {
      const int coupler = model.add_body("coupler" + number, random_body(random));
      add_joint(model, random, "universal", "left" + number, k, coupler);
      add_joint(model, random, "distance", "right" + number, coupler, next);
    }
    if (!branches) continue;
    const int branch = model.add_body("branch" + number, random_body(random));
    add_joint(model, random, k % 3 ? "revolute" : "cylindrical", "branch" + number, k, branch);
  }
  return model;
}

int count_grounded(const System& system) {
  const block::SymbolicFactorization symbolic(system);
  int out = 0;
  for (const block::CoreBody& body : symbolic.bodies) out += body.grounded();
  return out;
}

}  // namespace

TEST_CASE("grounded bodies of loops are solved, with branches and where their joints yield, too") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(16);
    for (int trial = 0; trial < 40; ++trial) {
      const int count = random.integer(4, 12);
      const System system(grounded_bodies(random, count, trial % 2 == 1));
      CHECK(count_grounded(system) == count - count / 4);
      check_solves(solver, system, random, false);
      check_solves(solver, system, random, true);
      CHECK(solver.reordered());  // joints that yield are like others
      check_solves(solver, system, random, false);
      CHECK(!solver.reordered());
    }
  });
}

TEST_CASE("grounded bodies whose joints are violated by far are solved as others are") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(17);
    int reordered = 0;
    for (int trial = 0; trial < 20; ++trial) {
      Model model;
      for (int body = 0; body < 3; ++body) {
        model.add_body("body" + std::to_string(body), random_body(random));
        model.add_joint(body ? "revolute" : "translational", "guide" + std::to_string(body), ground, body,
                        random_attachment(random));
      }
      for (int body = 0; body < 2; ++body)
        add_joint(model, random, "distance", "rod" + std::to_string(body), body, body + 1);
      const System system(model);
      CHECK(count_grounded(system) == 3);
      check_solves(solver, system, random, false);
      reordered += solver.reordered();
    }
    CHECK(reordered > 1);
    CHECK(reordered < 19);
  });
}

TEST_CASE("a row that the joint of a grounded body nearly fulfils by itself is a small pivot") {
  for_every_instruction_set([](SaddleSolver& solver) {
    for (const double angle : {0.5, 1e-2, 1e-4, 1e-6}) {
      INFO("at ", angle);
      Model model;  // a crank, and a rod from its pin almost straight on to the ground
      const Vec3<double> pin(0.4, 0.0, 0.0), far(0.4 + std::cos(angle), std::sin(angle), 0.0);
      const int crank = model.add_body("crank", body_at({0.2, 0.0, 0.0}));
      join(model, "revolute", "bearing", ground, crank, {0.0, 0.0, 0.0});
      Attachment<double> at{far, pin - Vec3<double>(0.2, 0.0, 0.0), Mat3<double>::Identity(), Mat3<double>::Identity()};
      model.add_joint("distance", "rod", ground, crank, at, {Parameter{1.0}});
      const System system(model);
      REQUIRE(count_grounded(system) == 1);
      const Evaluation evaluation = evaluate_initially(system);
      solver.analyze(system, evaluation);
      solver.factorize(evaluation, VectorXd());
      const MatrixXd M = dense_M(model), D = dense_D(system, evaluation), S = dense_delassus(M, D);
      const MatrixXd first = S.topLeftCorner(5, 5);
      const VectorXd s = S.col(5).head(5);
      const double pivot = (S(5, 5) - s.dot(dense_solution(first, s))) / S(5, 5);
      CHECK(solver.smallest_pivot() == doctest::Approx(pivot).epsilon(1e-3));
    }
  });
}

TEST_CASE("grounded bodies of masses over twelve decades have the accelerations of an accurate solution") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(18);
    for (int trial = 0; trial < 10; ++trial) {
      const Model scaled = spread(grounded_bodies(random, 5, trial % 2 == 1), random, 12.0);
      const System system(scaled);
      REQUIRE(count_grounded(system) > 0);
      const Evaluation at = evaluate_initially(system);
      const MatrixXd M = dense_M(scaled), D = dense_D(system, at);
      const Eigen::Index n = M.rows(), m = D.rows();
      MatrixXd K = MatrixXd::Zero(n + m, n + m);
      K << M, D.transpose(), D, MatrixXd::Zero(m, m);
      VectorXd right(n + m), x(n), lambda(m);
      const VectorXd a = M * random.vector(n), b = random.vector(m);
      right << a, b;
      solver.analyze(system, at);
      solver.factorize_and_solve(at, VectorXd(), a, b, x, lambda);
      CHECK(relative_error(x, accurate_solution(K, right).head(n)) < 1e-9);
    }
  });
}
