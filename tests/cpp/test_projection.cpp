#include "linkwork/formulation/projection.hpp"

#include "dense_algebra.hpp"
#include "mechanisms.hpp"

using namespace support;

TEST_CASE("the change of velocities is -M^-1 D^T S^-1 (D v + Phi_t), whatever the formulation") {
  Random random(111);
  const Model model = random_chain(random, 4, "universal");
  const MatrixXd M = dense_M(model);
  for (const char* formulation : {"standard", "augmented_lagrangian"}) {
    Dynamics dynamics(model, options_of(formulation));
    VectorXd y = dynamics.initial_y();
    dynamics.evaluate(0.0, y);
    const MatrixXd D = dense_D(dynamics.system(), dynamics.evaluation());
    const VectorXd v = y.segment(28, 24);
    const VectorXd lambda = dense_solution(dense_delassus(M, D), dynamics.evaluation().Phi_dot);
    const VectorXd expected = v - dense_inverse(M) * (D.transpose() * lambda);
    Projection(dynamics).velocities(0.0, y);
    CHECK(relative_error(VectorXd(y.segment(28, 24)), expected) < 1e-10);
  }
}

TEST_CASE("projected velocities have less kinetic energy, by that of the change") {
  Random random(112);
  const Model model = random_chain(random, 3, "spherical");
  Dynamics dynamics(model, {});
  VectorXd y = dynamics.initial_y();
  dynamics.evaluate(0.0, y);
  const VectorXd before = y.segment(21, 18);
  Projection(dynamics).velocities(0.0, y);
  const VectorXd after = y.segment(21, 18);
  const System& system = dynamics.system();
  const Evaluation& at = dynamics.evaluation();
  CHECK(system.kinetic_energy(at, before) ==
        doctest::Approx(system.kinetic_energy(at, after) + system.kinetic_energy(at, before - after)).epsilon(1e-10));
}

TEST_CASE("positions off the constraints of a redundant mechanism are taken back, all of its equations met") {
  const Model model = four_bar();
  Dynamics dynamics(model, {});
  VectorXd y = dynamics.initial_y();
  VectorXd off = VectorXd::Zero(18);
  off[0] = 1e-3;
  off[11] = -2e-3;
  y.head(21) = moved(y.head(21), off, VectorXd::Zero(18), 1.0);
  dynamics.evaluate(0.0, y);
  REQUIRE(dynamics.evaluation().Phi.cwiseAbs().maxCoeff() > 1e-4);
  Projection(dynamics).positions(0.0, y);
  dynamics.evaluate(0.0, y);
  CHECK(dynamics.evaluation().Phi.cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("a state that no pose near satisfies is an error that names a joint") {
  Model model;
  model.add_body("ball", body_at({1, 0, 0}));
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_joint("distance", "rod", ground, 0, {O, O, I, I}, {{1.0, -1}});
  Dynamics dynamics(model, {});
  VectorXd y = dynamics.initial_y();
  dynamics.evaluate(0.0, y);
  y.head<3>() = Vec3<double>(1e-3, 0, 200.0);  // across the direction in which it was factorized
  CHECK_THROWS_AS(Projection(dynamics).positions(0.0, y), NotConvergedError);
}
