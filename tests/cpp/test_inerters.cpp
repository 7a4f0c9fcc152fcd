#include "linkwork/assembly/inerters.hpp"

#include <doctest/doctest.h>

#include "linkwork/assembly/system.hpp"
#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/primitives.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// One of each kind between bodies, and one to the ground.
Model with_inerters(Random& random) {
  Model model = random_tree(random, 4);
  int k = 0;
  for (const char* kind : {"inerter", "rotational_inerter", "translational_inerter", "inerter"}) {
    const int i = k == 3 ? ground : k;
    model.add_force(kind, "inerter " + std::to_string(k), i, 3, random_attachment(random), {{0.3 + k, -1}});
    k += 1;
  }
  return model;
}

MatrixXd rows_of(const System& system, const Evaluation& at) {
  MatrixXd out = MatrixXd::Zero(static_cast<Eigen::Index>(system.inerters().count()), system.v_size());
  for (std::size_t k = 0; k < system.inerters().count(); ++k)
    for (const Inerters::Part& part : system.inerters().row(k, at.D.data()))
      for (int c = 0; c < 6 && part.body != ground; ++c)
        out(static_cast<Eigen::Index>(k), 6 * part.body + c) = part.d[c];
  return out;
}

/// q moved along v for a short time.
VectorXd moved(const System& system, const VectorXd& q, const VectorXd& v, double t) {
  VectorXd rate(q.size());
  system.position_rates(q, v, rate);
  VectorXd middle = q + 0.5 * t * rate;
  system.normalize(middle);
  system.position_rates(middle, v, rate);
  VectorXd out = q + t * rate;
  system.normalize(out);
  return out;
}

}  // namespace

TEST_CASE("M and the kinetic energy have b d^T d of each inerter") {
  Random random(301);
  const System system(with_inerters(random));
  const Evaluation at = evaluate_initially(system);
  const MatrixXd d = rows_of(system, at);
  MatrixXd M = dense_M(system.model());
  for (Eigen::Index k = 0; k < d.rows(); ++k) M += (0.3 + static_cast<double>(k)) * d.row(k).transpose() * d.row(k);
  const VectorXd x = random.vector(system.v_size());
  VectorXd y(x.size());
  system.multiply_mass(at, x, y);
  CHECK(relative_error(y, M * x) < 1e-14);
  CHECK(system.kinetic_energy(at, x) == doctest::Approx(0.5 * x.dot(M * x)).epsilon(1e-13));
}

TEST_CASE("gamma is what the rate of the coordinate changes by while velocities stay") {
  Random random(302);
  const System system(with_inerters(random));
  const VectorXd q = system.model().initial_q(), v = system.model().initial_v();
  const double h = 1e-4;
  const auto rates = [&](double t) {
    Evaluation at = system.make_evaluation();
    system.evaluate_constraints(0.0, moved(system, q, v, t), v, system.initial_history(), at);
    return VectorXd(rows_of(system, at) * v);
  };
  const Evaluation at = evaluate_initially(system);
  CHECK(relative_error(-(rates(h) - rates(-h)) / (2.0 * h), at.coordinate_gamma) < 1e-6);
}

TEST_CASE("for linear solvers they are joints of one row behind the others, whose rows stand in the same places") {
  Random random(303);
  const Model model = with_inerters(random);
  const System system(model), joints(Inerters::as_joints(model));
  CHECK(joints.row_count() == system.row_count() + 4);
  CHECK(joints.inerters().empty());
  const Evaluation at = evaluate_initially(system);
  const VectorXd x = random.vector(system.v_size());
  VectorXd all(joints.row_count()), own(system.row_count());
  joints.multiply_D(at, x, all);
  system.multiply_D(at, x, own);
  CHECK(all.head(own.size()) == own);
  CHECK(relative_error(all.tail(4), rows_of(system, at) * x) < 1e-14);
}

TEST_CASE("names of theirs give way to those of joints") {
  Random random(304);
  Model model = with_inerters(random);
  model.add_joint("distance", "of inerter 1", 0, 2, random_attachment(random), {{1.0, -1}});
  CHECK(Inerters::as_joints(model).row_count() == model.row_count() + 4);
}

TEST_CASE("the row of an angle is that of the angle itself") {
  Random random(305);
  for (int trial = 0; trial < 50; ++trial) {
    const auto state = [&] {
      return BodyState<double>{random.vec3(), random.frame(), random.vec3(), random.vec3(3.0)};
    };
    const BodyState<double> i = state(), j = state();
    const Attachment<double> at = random_attachment(random);
    Equation<double> turns, is;
    turning<double>(i, j, at.x_i(), at.y_i(), at.x_j(), turns.rows());
    angle<double>(i, j, at.x_i(), at.y_i(), at.x_j(), is.rows());
    for (int c = 0; c < velocity_size; ++c) {
      CHECK(turns.D_i[c] == doctest::Approx(is.D_i[c]).epsilon(1e-12));
      CHECK(turns.D_j[c] == doctest::Approx(is.D_j[c]).epsilon(1e-12));
    }
    CHECK(turns.gamma == doctest::Approx(is.gamma).epsilon(1e-11));
  }
}
