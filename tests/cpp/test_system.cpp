#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// Trees of random joints, and one with a closed loop and the ground as first and as second body.
std::vector<Model> random_models(std::uint64_t seed) {
  Random random(seed);
  std::vector<Model> models;
  for (int bodies : {1, 2, 5, 12}) models.push_back(random_tree(random, bodies));
  Model loop = random_tree(random, 4);
  add_joint(loop, random, "spherical", "closing", 3, 1);
  add_joint(loop, random, "revolute", "to ground", 2, ground);
  models.push_back(loop);
  return models;
}

/// A body at rest that hangs from the ground by a joint of this kind at point P; forces and torques as `reactions`
/// gives.
struct Hanging {
  Hanging(const std::string& kind, bool ground_first) {
    Random random(51);
    Body body = random_body(random);
    body.velocity.setZero();
    body.omega.setZero();
    model.add_body("weight", body);
    const Mat3<double> F = random.frame();
    const int i = ground_first ? ground : 0, j = ground_first ? 0 : ground;
    model.add_joint(kind, "hook", i, j, place(model, i, j, P, P, F, F));
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const MatrixXd D = dense_D(system, at);
    const VectorXd lambda = dense_least_norm(D.transpose(), -at.g.head<6>(), 1e-12);  // static: -D^T lambda = g
    CHECK((D.transpose() * lambda + at.g.head<6>()).norm() < 1e-13);
    system.reactions(at, model.initial_q(), lambda, force, torque);
  }
  const Vec3<double> P{0.3, -0.8, 1.1};
  Model model;
  Eigen::Matrix3Xd force{3, 1}, torque{3, 1};
};

}  // namespace

TEST_CASE("products with D and D^T are those of the dense D") {
  Random random(50);
  for (const Model& model : random_models(52)) {
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const MatrixXd D = dense_D(system, at);
    const VectorXd x = random.vector(system.v_size()), lambda = random.vector(system.row_count());
    VectorXd y(system.row_count()), z = random.vector(system.v_size());
    const VectorXd sum = z + D.transpose() * lambda;
    system.multiply_D(at, x, y);
    system.add_D_transposed(at, lambda, z);
    CHECK(relative_error(y, D * x) < 1e-14);
    CHECK(relative_error(z, sum) < 1e-14);
  }
}

TEST_CASE("Phi_dot = D v + Phi_t") {
  Random random(53);
  Model model = random_tree(random, 3);
  const Attachment<double> at_points = random_attachment(random);
  model.add_joint("distance", "driven", 0, 2, at_points, {{0.0, model.add_signal(polynomial({1.0, 0.7}))}});
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  CHECK(at.Phi_t.tail<1>()[0] == doctest::Approx(-0.7));
  CHECK(relative_error(at.Phi_dot, dense_D(system, at) * model.initial_v() + at.Phi_t) < 1e-14);
}

TEST_CASE("delassus_diagonal = diag(D M^-1 D^T)") {
  for (const Model& model : random_models(54)) {
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const MatrixXd D = dense_D(system, at);
    const VectorXd expected = dense_delassus(dense_M(model), D).diagonal();
    CHECK(relative_error(system.delassus_diagonal(at), expected) < 1e-12);
  }
}

TEST_CASE("products with M and M^-1 are those of the dense M") {
  Random random(55);
  const Model model = random_tree(random, 4);
  const System system(model);
  const VectorXd x = random.vector(24);
  VectorXd y(24), z(24);
  system.multiply_mass(system.make_evaluation(), x, y);
  system.multiply_inverse_mass(y, z);
  CHECK(relative_error(y, dense_M(model) * x) < 1e-14);
  CHECK(relative_error(z, x) < 1e-12);
}

TEST_CASE("the inverse of an inertia is that on its range, whatever other bodies have") {
  Random random(61);
  Model model;
  Body line = random_body(random), point = line;
  line.inertia = Vec3<double>(0.0, 2.0, 2.0).asDiagonal();
  point.inertia.setZero();
  model.add_body("first", random_body(random));
  model.add_body("line", line);
  model.add_body("second", random_body(random));
  model.add_body("point", point);
  model.add_body("third", random_body(random));
  const System system(model);
  CHECK(system.massless_bodies() == std::vector<int>{1, 3});
  for (const int body : {0, 2, 4})
    CHECK((system.inverse_inertia(body) * system.inertia(body) - Mat3<double>::Identity()).norm() < 1e-12);
  CHECK(system.inverse_inertia(1).isApprox(Mat3<double>(Vec3<double>(0.0, 0.5, 0.5).asDiagonal()), 1e-15));
  CHECK(system.inverse_inertia(3).isZero(0.0));
}

TEST_CASE("kinetic energy = v^T M v / 2") {
  Random random(56);
  const Model model = random_tree(random, 4);
  const VectorXd v = model.initial_v();
  const System system(model);
  CHECK(system.kinetic_energy(system.make_evaluation(), v) ==
        doctest::Approx(0.5 * v.dot(dense_M(model) * v)).epsilon(1e-14));
}

TEST_CASE("q_dot = N(q) v is the derivative of q along the motion") {
  Random random(57);
  const Model model = random_tree(random, 3);
  const System system(model);
  const VectorXd q = model.initial_q(), v = model.initial_v(), still = VectorXd::Zero(18);
  VectorXd q_dot(21);
  system.position_rates(q, v, q_dot);
  const auto pose = [&](double s) { return moved(q, v, still, s); };
  CHECK(relative_error(q_dot, first_difference(pose, 1e-3)) < 1e-10);
}

TEST_CASE("normalize makes every p unit and keeps its direction and r") {
  Random random(58);
  const Model model = random_tree(random, 2);
  VectorXd q = model.initial_q();
  q.segment<4>(3) *= 1.3;
  q.segment<4>(10) *= 0.2;
  System(model).normalize(q);
  CHECK((q - model.initial_q()).norm() < 1e-15);
}

TEST_CASE("an evaluation does not depend on the length of p") {
  Random random(59);
  const Model model = random_tree(random, 3);
  const System system(model);
  VectorXd q = model.initial_q();
  for (int body = 0; body < 3; ++body) q.segment<4>(7 * body + 3) *= 0.7 + 0.3 * body;
  Evaluation at = system.make_evaluation();
  system.evaluate(0.0, q, model.initial_v(), system.initial_history(), at);
  const Evaluation unit = evaluate_initially(system);
  CHECK(relative_error(dense_D(system, at), dense_D(system, unit)) < 1e-14);
  CHECK(relative_error(at.gamma, unit.gamma) < 1e-13);
}

TEST_CASE("a second evaluation at the same state gives the same numbers") {
  Random random(60);
  const Model model = random_tree(random, 6);
  const System system(model);
  const VectorXd q = model.initial_q(), v = model.initial_v();
  Evaluation at = evaluate_initially(system);
  const Evaluation first = at;
  system.evaluate(0.0, q, 2.0 * v, system.initial_history(), at);
  system.evaluate(0.0, q, v, system.initial_history(), at);
  CHECK(at.D == first.D);
  CHECK(at.gamma == first.gamma);
  CHECK(at.Phi_dot == first.Phi_dot);
  CHECK(at.g == first.g);
}

TEST_CASE("the blocks of joints and of bodies list every block once for each") {
  for (const Model& model : random_models(61)) {
    const System system(model);
    std::vector<int> by_joint(system.blocks().size()), by_body(system.blocks().size());
    for (int joint = 0; joint < system.joint_count(); ++joint)
      for (const int block : system.joint_blocks(joint)) {
        CHECK(system.blocks()[block].joint == joint);
        by_joint[block] += 1;
      }
    for (int body = 0; body < system.body_count(); ++body)
      for (const int block : system.body_blocks(body)) {
        CHECK(system.blocks()[block].body == body);
        by_body[block] += 1;
      }
    CHECK(by_joint == std::vector<int>(system.blocks().size(), 1));
    CHECK(by_body == by_joint);
  }
}

TEST_CASE("a weld holds a hanging body's weight and its moment about the joint") {
  const Hanging hanging("fixed", true);
  const Body& body = hanging.model.bodies()[0];
  const Vec3<double> weight = body.mass * hanging.model.gravity();
  CHECK((hanging.force.col(0) + weight).norm() < 1e-12);
  CHECK((hanging.torque.col(0) + (body.position - hanging.P).cross(weight)).norm() < 1e-12);
}

TEST_CASE("swapped bodies flip the sign of the reaction") {
  const Hanging ground_first("fixed", true), ground_second("fixed", false);
  CHECK((ground_first.force + ground_second.force).norm() < 1e-12);
  CHECK((ground_first.torque + ground_second.torque).norm() < 1e-12);
}

TEST_CASE("the reaction between two bodies is a wrench of D^T lambda on each, taken about the joint's point") {
  Random random(64);
  for (const JointKind& kind : joint_kinds()) {
    INFO(kind.info.name);
    Model model;
    for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
    add_joint(model, random, kind.info.name, "joint", 0, 1);
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const VectorXd lambda = random.vector(system.row_count());
    const VectorXd wrenches = dense_D(system, at).transpose() * lambda;
    Eigen::Matrix3Xd force(3, 1), torque(3, 1);
    system.reactions(at, model.initial_q(), lambda, force, torque);
    const Vec3<double> F = force.col(0), T = torque.col(0);
    const Body &a = model.bodies()[0], &b = model.bodies()[1];
    const Vec3<double> P = b.position + rotation_matrix<double>(b.orientation) * model.joints()[0].at.s_j;
    const auto moment = [&](const Body& body, int k) {
      return Vec3<double>(rotation_matrix<double>(body.orientation) * wrenches.segment<3>(6 * k + 3));
    };
    CHECK((wrenches.segment<3>(6) - F).norm() < 1e-14);
    CHECK((wrenches.segment<3>(0) + F).norm() < 1e-14);
    CHECK((moment(b, 1) - T - (P - b.position).cross(F)).norm() < 1e-13);
    CHECK((moment(a, 0) + T + (P - a.position).cross(F)).norm() < 1e-13);
  }
}

TEST_CASE("the frame of a joint is fixed in its first body") {
  Random random(65);
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const Mat3<double> F = random.frame(), other = random.frame();
  const Vec3<double> P = random.vec3();
  model.add_joint("revolute", "ground first", ground, 0, place(model, ground, 0, P, P, F, other));
  model.add_joint("revolute", "body first", 1, 0, place(model, 1, 0, P, P, F, other));
  const System system(model);
  VectorXd q = model.initial_q();
  CHECK((system.joint_frame(0, q) - F).norm() < 1e-14);
  CHECK((system.joint_frame(1, q) - F).norm() < 1e-14);
  const Vec4<double> turn = random.unit_quaternion();
  q.segment<4>(10) = quaternion_product<double>(turn, q.segment<4>(10));
  CHECK((system.joint_frame(0, q) - F).norm() < 1e-14);
  CHECK((system.joint_frame(1, q) - rotation_matrix<double>(turn) * F).norm() < 1e-14);
}

TEST_CASE("massless bodies are listed, and their massless directions span the kernel of M") {
  Random random(66);
  Model model;
  model.add_body("solid", random_body(random));
  Body point = random_body(random), rod = random_body(random), ghost = random_body(random);
  point.inertia.setZero();
  const Mat3<double> axes = random.frame();
  rod.inertia = axes * Vec3<double>(0.0, 1.0, 1.0).asDiagonal() * axes.transpose();
  rod.inertia = (0.5 * (rod.inertia + rod.inertia.transpose())).eval();
  ghost.mass = 0.0;
  ghost.inertia.setZero();
  model.add_body("point", point);
  model.add_body("rod", rod);
  model.add_body("ghost", ghost);
  const System system(model);
  CHECK(system.massless_bodies() == std::vector<int>{1, 2, 3});
  const std::vector<int> dimensions = {0, 3, 1, 6};
  for (int body = 0; body < 4; ++body) {
    const MatrixXd kernel = system.massless_directions(body);
    CHECK(kernel.cols() == dimensions[body]);
    if (kernel.cols() == 0) continue;
    CHECK((dense_M(model).block<6, 6>(6 * body, 6 * body) * kernel).norm() < 1e-14);
    CHECK((kernel.transpose() * kernel - MatrixXd::Identity(kernel.cols(), kernel.cols())).norm() < 1e-14);
  }
}
