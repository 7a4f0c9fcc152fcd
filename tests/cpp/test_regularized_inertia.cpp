#include <doctest/doctest.h>

#include "linkwork/constraints/refinement.hpp"
#include "linkwork/constraints/regularized_inertia.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// Rods of 1 m and 1 kg along x with this moment about themselves; hinges of axis z between them, `turned` about x.
Model rods(int count, double moment, const std::string& joint, double length = 1.0, double mass = 1.0) {
  Model model;
  for (int k = 0; k < count; ++k) {
    Body body;
    body.mass = mass;
    body.inertia = (Vec3<double>(moment, 1.0 / 12, 1.0 / 12) * mass * length * length).asDiagonal();
    body.position = Vec3<double>((k + 0.5) * length, 0, 0);
    model.add_body("rod" + std::to_string(k), body);
    Attachment<double> at;
    at.s_i = k > 0 ? Vec3<double>(0.5 * length, 0, 0) : Vec3<double>::Zero();
    at.s_j = Vec3<double>(-0.5 * length, 0, 0);
    at.C_i = at.C_j = Eigen::AngleAxisd(0.4, Vec3<double>(1, 1, 1).normalized()).toRotationMatrix();
    model.add_joint(joint, joint + std::to_string(k), k - 1, k, at);
  }
  return model;
}

}  // namespace

TEST_CASE("compact bodies keep their inertia, and their roundoff shows nowhere") {
  Random random(141);
  for (const Model& model : {random_chain(random, 6, "revolute"), random_tree(random, 8), rods(3, 1e-2, "revolute")}) {
    const System system(model);
    const RegularizedInertia inertia(system, evaluate_initially(system));
    CHECK(!inertia.regularized());
    CHECK(&inertia.system() == &system);
    CHECK(!inertia.shows(INFINITY));
    CHECK(!inertia.shows(1e-9));
  }
}

TEST_CASE("tiny moments that joints feel are regularized, in any units alike") {
  for (const double moment : {0.0, 1e-12, 1e-7})
    for (const double length : {1e-6, 1.0, 1e6})
      for (const double mass : {1e-9, 1.0, 1e9}) {
        const System system(rods(3, moment, "revolute", length, mass));
        const RegularizedInertia inertia(system, evaluate_initially(system));
        REQUIRE(inertia.regularized());
        CHECK(inertia.smallest_moment() <= 4.0 * moment + 1e-15);
        CHECK(inertia.system().massless_bodies().empty());
        for (int body = 0; body < 3; ++body) {
          const Mat3<double> added = inertia.system().inertia(body) - system.inertia(body);
          CHECK(added(0, 0) == doctest::Approx(2.5e-6 * mass * length * length));
          CHECK(added.norm() == doctest::Approx(added(0, 0)));
          CHECK(inertia.system().mass(body) == mass);
        }
      }
}

TEST_CASE("a moment that no joint feels is left as it is, and one that vanishes is not") {
  const System spinning(rods(2, 1e-9, "spherical"));
  const RegularizedInertia own(spinning, evaluate_initially(spinning));
  CHECK(!own.regularized());
  CHECK(own.smallest_moment() == 1.0);
  const System still(rods(2, 0.0, "spherical"));
  CHECK(RegularizedInertia(still, evaluate_initially(still)).regularized());
}

TEST_CASE("refinement leads from regularized inertias to the solution of the equations as they are") {
  for (const double moment : {0.0, 1e-12, 1e-8, 1e-5}) {
    INFO(moment);
    const System system(rods(4, moment, "revolute"));
    const Evaluation at = evaluate_initially(system);
    const RegularizedInertia inertia(system, at);
    const auto saddle = make_saddle_solver("kkt", linear_solver_info("block"));
    saddle->analyze(inertia.system(), at);
    Random random(142);
    const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
    VectorXd x(a.size()), lambda(b.size());
    saddle->factorize_and_solve(at, VectorXd::Zero(b.size()), a, b, x, lambda);
    Refinement refinement(system, inertia.lengths());
    const auto nearby = [&](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx, MutableVector dlambda) {
      saddle->solve(r_1, r_2, dx, dlambda);
    };
    REQUIRE(refinement.refine(at, a, b, x, lambda, nearby, Inexactness::inertia));
    const MatrixXd D = dense_D(system, at), M = dense_M(system.model());
    CHECK((M * x - D.transpose() * lambda - a).norm() <=
          1e-13 * (M * x).norm() + 1e-13 * (D.transpose() * lambda).norm());
    CHECK((D * x - b).norm() <= 1e-13 * x.norm());
  }
}
