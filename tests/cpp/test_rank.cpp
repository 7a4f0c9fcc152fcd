#include <doctest/doctest.h>

#include <Eigen/SVD>

#include "linkwork/formulation/rank.hpp"
#include "support.hpp"

using namespace support;

namespace {

int dense_rank(const System& system) {
  const MatrixXd D = dense_D(system, evaluate_initially(system));
  const VectorXd sigma = Eigen::JacobiSVD<MatrixXd>(D).singularValues();
  return static_cast<int>((sigma.array() > 1e-9 * sigma[0]).count());
}

/// The rank is that of the singular values; without the dependent rows, as many independent ones are left.
void check_rank(const Model& model) {
  const System system(model);
  const RankReport report = rank_of_constraints(system, evaluate_initially(system));
  CHECK(report.rows == system.row_count());
  CHECK(report.rank == dense_rank(system));
  CHECK(report.degrees_of_freedom == system.v_size() - report.rank);
  MatrixXd D = dense_D(system, evaluate_initially(system));
  for (const int row : report.dependent_rows) D.row(row).setZero();
  const VectorXd sigma = Eigen::JacobiSVD<MatrixXd>(D).singularValues();
  CHECK((sigma.array() > 1e-9 * sigma[0]).count() == report.rank);
}

Body at(const Vec3<double>& position) {
  Body body;
  body.position = position;
  return body;
}

void add_in_space(Model& model, const std::string& kind, const std::string& name, int i, int j, const Vec3<double>& P) {
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_joint(kind, name, i, j, place(model, i, j, P, P, I, I));
}

/// A planar four-bar with hinges about z: 18 velocities, 20 rows, of which 3 are redundant.
Model four_bar() {
  Model model;
  model.add_body("crank", at({0.0, 0.5, 0.0}));
  model.add_body("coupler", at({1.0, 1.25, 0.0}));
  model.add_body("rocker", at({2.0, 0.75, 0.0}));
  add_in_space(model, "revolute", "A", ground, 0, {0, 0, 0});
  add_in_space(model, "revolute", "B", 0, 1, {0, 1, 0});
  add_in_space(model, "revolute", "C", 1, 2, {2, 1.5, 0});
  add_in_space(model, "revolute", "D", 2, ground, {2, 0, 0});
  return model;
}

}  // namespace

TEST_CASE("random trees have full rank") {
  Random random(120);
  for (const int bodies : {1, 3, 10, 30}) {
    const Model model = random_tree(random, bodies);
    const System system(model);
    const RankReport report = rank_of_constraints(system, evaluate_initially(system));
    CHECK(report.rank == system.row_count());
    CHECK(report.dependent_rows.empty());
    CHECK(report.degrees_of_freedom == 6 * bodies - report.rank);
  }
}

TEST_CASE("random trees with loops have the rank of their singular values") {
  Random random(121);
  for (int repetition = 0; repetition < 10; ++repetition) {
    Model model = random_tree(random, 6);
    add_joint(model, random, "spherical", "closing", 5, 0);
    add_joint(model, random, "revolute", "closing too", 4, ground);
    check_rank(model);
  }
}

TEST_CASE("a planar four-bar of hinges has one degree of freedom and three redundant rows") {
  const System system(four_bar());
  const RankReport report = rank_of_constraints(system, evaluate_initially(system));
  CHECK(report.rank == 17);
  CHECK(report.dependent_rows.size() == 3);
  CHECK(report.degrees_of_freedom == 1);
  check_rank(four_bar());
}

TEST_CASE("a hinge that is there twice repeats five rows, each of one of the two") {
  Random random(122);
  Model model;
  model.add_body("bob", random_body(random));
  model.add_body("free", random_body(random));
  const Vec3<double> P = random.vec3();
  const Mat3<double> F = random.frame();
  add_joint(model, random, "spherical", "ball", 0, 1);
  model.add_joint("revolute", "hinge", ground, 0, place(model, ground, 0, P, P, F, F));
  model.add_joint("revolute", "again", ground, 0, place(model, ground, 0, P, P, F, F));
  const System system(model);
  const RankReport report = rank_of_constraints(system, evaluate_initially(system));
  CHECK(report.dependent_rows.size() == 5);
  for (const int row : report.dependent_rows) CHECK(model.joint_of_row(row) > 0);
  check_rank(model);
}

TEST_CASE("a slider on two rails along the axes of space repeats three rotations and two shifts") {
  Model model;
  model.add_body("slider", at({0, 0, 1}));
  add_in_space(model, "translational", "rail", ground, 0, {0, 0, 0});
  add_in_space(model, "translational", "second rail", ground, 0, {0, 0, 0});
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).dependent_rows.size() == 5);
  check_rank(model);
}

TEST_CASE("a hinge and a slider along the same axis leave nothing free") {
  Model model;
  model.add_body("block", at({0, 0, 1}));
  add_in_space(model, "revolute", "hinge", ground, 0, {0, 0, 0});
  add_in_space(model, "translational", "rail", ground, 0, {0, 0, 0});
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).degrees_of_freedom == 0);
  check_rank(model);
}

TEST_CASE("the rank does not change with the units of mass and length") {
  for (const double length : {1e-3, 1.0, 1e3}) {
    Model model;
    const Model original = four_bar();
    for (int body = 0; body < 3; ++body) {
      Body b = original.bodies()[static_cast<std::size_t>(body)];
      b.position *= length;
      b.inertia *= length * length;
      model.add_body("b" + std::to_string(body), b);
    }
    for (int joint = 0; joint < 4; ++joint) {
      Element element = original.joints()[static_cast<std::size_t>(joint)];
      element.at.s_i *= length;
      element.at.s_j *= length;
      model.add_joint("revolute", std::to_string(joint), element.i, element.j, element.at);
    }
    const System system(model);
    CHECK(rank_of_constraints(system, evaluate_initially(system)).rank == 17);
  }
}

TEST_CASE("a heavy and a light mechanism in one model have the rank that each has alone") {
  Model model;
  const Model original = four_bar();
  for (const auto& [name, mass] : {std::pair{"heavy", 1e10}, std::pair{"light", 1e-10}}) {
    const int first = static_cast<int>(model.bodies().size());
    std::vector<Body> bodies = original.bodies();
    for (Body& body : bodies) {
      body.mass *= mass;
      body.inertia *= mass;
    }
    model.add_bodies(name, bodies);
    std::vector<Element> joints = original.joints();
    for (Element& joint : joints) {
      joint.i += joint.i == ground ? 0 : first;
      joint.j += joint.j == ground ? 0 : first;
    }
    model.add_joints("revolute", name, joints, {});
  }
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).rank == 2 * 17);
}

TEST_CASE("a universal joint whose axes are parallel has a dependent row, at the end of a branch too") {
  Random random(124);
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const Vec3<double> P = random.vec3();
  const Mat3<double> F = random.frame();
  add_joint(model, random, "revolute", "hinge", ground, 0);
  model.add_joint("universal", "locked", 0, 1, place(model, 0, 1, P, P, F, F));
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).dependent_rows == std::vector<int>{8});
}

TEST_CASE("massless bodies are free where joints leave a motion of theirs without inertia, and only there") {
  Random random(123);
  Body ghost = random_body(random);
  ghost.mass = 0.0;
  ghost.inertia.setZero();
  for (const auto& [kind, free] :
       std::vector<std::pair<std::string, bool>>{{"fixed", false}, {"revolute", true}, {"spherical", true}}) {
    INFO(kind);
    Model model;
    model.add_body("solid", random_body(random));
    model.add_body("ghost", ghost);
    add_joint(model, random, kind, "joint", 0, 1);
    const System system(model);
    const std::vector<int> bodies = free_massless_bodies(system, evaluate_initially(system));
    CHECK(bodies == (free ? std::vector<int>{1} : std::vector<int>{}));
  }
}

TEST_CASE("a massless body without joints is free") {
  Model model;
  Body ghost;
  ghost.mass = 0.0;
  model.add_body("ghost", ghost);
  const System system(model);
  CHECK(free_massless_bodies(system, evaluate_initially(system)) == std::vector<int>{0});
}
