#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "dense_algebra.hpp"
#include "linkwork/constraints/rank.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// The rank is that of the singular values; without the dependent rows, as many independent ones are left.
void check_rank(const Model& model) {
  const System system(model);
  const PoseRank report = rank_of_constraints(system, evaluate_initially(system));
  CHECK(report.rows == system.row_count());
  CHECK(report.degrees_of_freedom == system.v_size() - report.rank);
  MatrixXd D = dense_D(system, evaluate_initially(system));
  CHECK(report.rank == dense_rank(D, 1e-9));
  for (const int row : report.dependent_rows) D.row(row).setZero();
  CHECK(dense_rank(D, 1e-9) == report.rank);
}

/// n hinges about one direction along a circle, links of 1 m between them, in a plane that is turned in space.
Model ring(int n, const Vec3<double>& center) {
  const Mat3<double> F = rotation_matrix<double>(Vec4<double>(0.7, 0.3, -0.5, 0.2).normalized());
  const auto hinge = [&](int k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    return Vec3<double>(center +
                        n / (2.0 * std::numbers::pi) * (std::cos(angle) * F.col(0) + std::sin(angle) * F.col(1)));
  };
  Model model;
  for (int k = 0; k + 1 < n; ++k) model.add_body("link" + std::to_string(k), body_at(0.5 * (hinge(k) + hinge(k + 1))));
  for (int k = 0; k < n; ++k) {
    const int i = k > 0 ? k - 1 : ground, j = k + 1 < n ? k : ground;
    model.add_joint("revolute", "hinge" + std::to_string(k), i, j, place(model, i, j, hinge(k), hinge(k), F, F));
  }
  return model;
}

}  // namespace

TEST_CASE("random trees have full rank") {
  Random random(120);
  for (const int bodies : {1, 3, 10, 30}) {
    const Model model = random_tree(random, bodies);
    const System system(model);
    const PoseRank report = rank_of_constraints(system, evaluate_initially(system));
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
  const PoseRank report = rank_of_constraints(system, evaluate_initially(system));
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
  const PoseRank report = rank_of_constraints(system, evaluate_initially(system));
  CHECK(report.dependent_rows.size() == 5);
  for (const int row : report.dependent_rows) CHECK(model.joint_of_row(row) > 0);
  check_rank(model);
}

TEST_CASE("a slider on two rails along the axes of space repeats three rotations and two shifts") {
  Model model;
  model.add_body("slider", body_at({0, 0, 1}));
  join(model, "translational", "rail", ground, 0, {0, 0, 0});
  join(model, "translational", "second rail", ground, 0, {0, 0, 0});
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).dependent_rows.size() == 5);
  check_rank(model);
}

TEST_CASE("a hinge and a slider along the same axis leave nothing free") {
  Model model;
  model.add_body("block", body_at({0, 0, 1}));
  join(model, "revolute", "hinge", ground, 0, {0, 0, 0});
  join(model, "translational", "rail", ground, 0, {0, 0, 0});
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).degrees_of_freedom == 0);
  check_rank(model);
}

TEST_CASE("the rank does not change with the units of mass and length") {
  for (const double length : {1e-3, 1.0, 1e3}) {
    Model model;
    const Model original = four_bar();
    for (int body = 0; body < 3; ++body) {
      Body b = original.bodies()[body];
      b.position *= length;
      b.inertia *= length * length;
      model.add_body("b" + std::to_string(body), b);
    }
    for (int joint = 0; joint < 4; ++joint) {
      Element element = original.joints()[joint];
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

TEST_CASE("the rank does not change with masses, however thin the rods") {
  for (const double inertia : {1e-2, 1e-6, 1e-10, 1e-14, 0.0}) {
    INFO(inertia);
    const Model original = four_bar();
    Model model;
    for (Body body : original.bodies()) {
      body.inertia = Vec3<double>(1e-2, inertia, 1e-2).asDiagonal();
      model.add_body("b" + std::to_string(model.bodies().size()), body);
    }
    for (const Element& joint : original.joints())
      model.add_joint("revolute", "j" + std::to_string(model.joints().size()), joint.i, joint.j, joint.at);
    const System system(model);
    CHECK(rank_of_constraints(system, evaluate_initially(system)).rank == 17);
    CHECK(examine_rank(system).redundant_rows == examine_rank(System(original)).redundant_rows);
  }
}

TEST_CASE("hinges out of line lock a door of any size, those that are off by less than anybody knows do not") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const auto& [off, rank] : {std::pair{1e-12, 5}, {1e-10, 5}, {1e-8, 6}, {1e-4, 6}}) {
      INFO(size, " ", off);
      CHECK(examine_rank(System(door(size, {off, 0, 0}, true))).rank == rank);
    }
}

TEST_CASE("what locks a door by its digits is told, and nothing of exact, far apart or long loops") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double off : {1e-8, 1e-6, 1e-4}) {
      INFO(size, " ", off);
      const RankReport report = examine_rank(System(door(size, {off, 0, 0}, true)));
      CHECK(report.nearly_dependent == 1);
      CHECK(report.least_part < 2.0 * off);
      CHECK(report.least_part > 0.01 * off);
    }
  CHECK(examine_rank(System(door(1.0, {1e-12, 0, 0}, true))).nearly_dependent == 0);
  CHECK(examine_rank(System(door(1.0, {0.1, 0, 0}, true))).nearly_dependent == 0);
  CHECK(examine_rank(System(four_bar())).nearly_dependent == 0);
  for (const int n : {20, 300, sanitized ? 600 : 3000})
    CHECK(examine_rank(System(ring(n, Vec3<double>::Zero()))).nearly_dependent == 0);
}

TEST_CASE("near dependence counts in each component of loops, whatever else is there") {
  Model model;
  const auto add = [&](const std::string& name, const Vec3<double>& off) {
    const Model one = door(1.0, off, true);
    const int body = model.add_body(name, one.bodies()[0]);
    for (const Element& joint : one.joints())
      model.add_joint("revolute", name + std::to_string(model.joints().size()), joint.i == ground ? ground : body,
                      joint.j == ground ? ground : body, joint.at);
  };
  for (int k = 0; k < 100; ++k) add("door" + std::to_string(k), {k % 2 == 0 ? 1e-5 : 0.0, 0, 0});
  CHECK(examine_rank(System(model)).nearly_dependent == 50);
}

TEST_CASE("what is left of a door's residual is not told from its rank") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double off : {1e-12, 1e-10, 1e-9, 1e-8})
      for (const Vec3<double>& direction : {Vec3<double>{1, 0, 0}, Vec3<double>{0, 1, 0}, Vec3<double>{0, 0, 1}}) {
        INFO(size, " ", off);
        CHECK(examine_rank(System(door(size, off * direction))).rank == 5);
      }
}

TEST_CASE("a long ring of hinges has three redundant equations wherever it stands") {
  for (const double off : {0.0, 1e3, 1e4, 1e6}) {
    INFO(off);
    const RankReport report = examine_rank(System(ring(1000, off * Vec3<double>(1.0, -2.0, 1.0))));
    CHECK(report.degrees_of_freedom == 997);
    CHECK(report.redundant_rows.size() == 3);
    CHECK(report.singular_rows.empty());
  }
}

TEST_CASE("joints that contradict each other leave a rank of at most six for each body") {
  for (const double off : {1e-4, 1e-2})
    for (const Vec3<double>& direction : {Vec3<double>{1, 0, 0}, Vec3<double>{0, 1, 0}, Vec3<double>{0, 0, 1}})
      CHECK(examine_rank(System(door(1.0, off * direction))).rank <= 6);
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

void add_rod(Model& model, int i, int j, const Vec3<double>& P_i, const Vec3<double>& P_j) {
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_joint("distance", "rod", i, j, place(model, i, j, P_i, P_j, I, I), {{(P_i - P_j).norm(), -1}});
}

TEST_CASE("a planar four-bar repeats three equations in every pose, those of the joint that closes it") {
  const System system(four_bar());
  const RankReport report = examine_rank(system);
  CHECK(report.rank == 17);
  CHECK(report.degrees_of_freedom == 1);
  CHECK(report.singular_rows.empty());
  CHECK(report.unique == std::vector<char>{0, 0, 0, 0});
  REQUIRE(report.redundant_rows.size() == 3);
  const int closing = system.model().joint_of_row(report.redundant_rows.front());
  for (const DependentGroup& group : dependent_groups(system, report, 3)) {
    CHECK(system.model().joint_of_row(group.row) == closing);
    CHECK(!group.others.empty());
  }
}

TEST_CASE("a group is dependent, and no longer without any one of its rows") {
  const System system(four_bar());
  const RankReport report = examine_rank(system);
  Evaluation generic = system.make_evaluation();
  system.evaluate_constraints(0.0, report.q, VectorXd::Zero(system.v_size()), system.initial_history(), generic);
  const MatrixXd D = dense_D(system, generic);
  for (const DependentGroup& group : dependent_groups(system, report, 3)) {
    std::vector<int> rows = group.others;
    rows.push_back(group.row);
    const auto rank_without = [&](int left_out) {
      MatrixXd part(static_cast<Eigen::Index>(rows.size()), D.cols());
      for (std::size_t k = 0; k < rows.size(); ++k)
        part.row(static_cast<Eigen::Index>(k)) = (rows[k] == left_out ? 0.0 : 1.0) * D.row(rows[k]);
      return static_cast<std::size_t>(dense_rank(part, 1e-9));
    };
    CHECK(rank_without(-1) == rows.size() - 1);
    for (const int row : rows) CHECK(rank_without(row) == rows.size() - 1);
  }
}

TEST_CASE("a flat four-bar has the rank of others, and a singular pose") {
  const System system(four_bar(true));
  const RankReport report = examine_rank(system);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).rank == 16);
  CHECK(report.rank == 17);
  CHECK(report.redundant_rows.size() == 3);
  CHECK(report.singular_rows.size() == 1);
}

TEST_CASE("a dead center that cannot be left has no redundant rows") {
  Model model;
  model.add_body("crank", body_at({0.5, 0.0, 0.0}));
  join(model, "revolute", "hinge", ground, 0, {0, 0, 0});
  add_rod(model, 0, ground, {1, 0, 0}, {3, 0, 0});
  const System system(model);
  const RankReport report = examine_rank(system);
  CHECK(report.rank == 6);
  CHECK(report.redundant_rows.empty());
  CHECK(report.singular_rows.size() == 1);
}

TEST_CASE("a planar loop stretched into a dead center repeats three equations, and has one that is singular") {
  Model model;
  model.add_body("a", body_at({0.5, 0.0, 0.0}));
  model.add_body("b", body_at({1.5, 0.0, 0.0}));
  join(model, "revolute", "A", ground, 0, {0, 0, 0});
  join(model, "revolute", "B", 0, 1, {1, 0, 0});
  join(model, "revolute", "C", 1, ground, {2, 0, 0});
  const RankReport report = examine_rank(System(model));
  CHECK(rank_of_constraints(System(model), evaluate_initially(System(model))).rank == 11);
  CHECK(report.rank == 12);
  CHECK(report.degrees_of_freedom == 0);
  CHECK(report.redundant_rows.size() == 3);
  CHECK(report.singular_rows.size() == 1);
}

TEST_CASE("what an initial pose hides by its errors is redundant all the same") {
  Model model;
  const Model exact = four_bar();
  Random random(125);
  for (Body body : exact.bodies()) {
    body.position += random.vec3(1e-3);
    body.orientation = exponential(random.vec3(1e-3));
    model.add_body("b" + std::to_string(model.bodies().size()), body);
  }
  for (const Element& joint : exact.joints())
    model.add_joint("revolute", "j" + std::to_string(model.joints().size()), joint.i, joint.j, joint.at);
  const System system(model);
  CHECK(rank_of_constraints(system, evaluate_initially(system)).rank > 17);
  CHECK(examine_rank(system).rank == 17);
}

TEST_CASE("only the joints of the loop have reactions that do not follow") {
  Model model = four_bar();
  model.add_body("weight", body_at({3, 0, 0}));
  model.add_body("side", body_at({-1, 0, 0}));
  join(model, "spherical", "hook", 2, 3, {2.5, 0, 0});
  join(model, "spherical", "left", ground, 4, {-2, 0, 0});
  join(model, "spherical", "right", ground, 4, {-1, 1, 0});
  add_rod(model, 3, 4, {3, 0, 0}, {-1, 0, 1});
  CHECK(examine_rank(System(model)).unique == std::vector<char>{0, 0, 0, 0, 1, 0, 0, 1});
}

TEST_CASE("many loops in one component repeat as many rows as each alone") {
  const int loops = 300;  // above the size up to which the kernel is written out
  const RankReport report = examine_rank(System(ladder(loops)));
  CHECK(report.redundant_rows.size() == 3 * loops);
  CHECK(report.degrees_of_freedom == 1);
  CHECK(report.singular_rows.empty());
  CHECK(report.unique == std::vector<char>(3 * loops + 1, 0));
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

TEST_CASE("masses, forces and gravity leave the geometry as it is, joints and poses do not") {
  const Model model = four_bar();
  const System system(model);
  std::vector<Body> heavier = model.bodies();
  heavier[1].mass *= 3.0;
  CHECK(same_geometry(system, System(model.with_masses(heavier))));
  CHECK(same_geometry(system, System(model.with_weights({0, 0, -1.6}, {}, {}, {}))));
  VectorXd q = model.initial_q();
  q[0] = std::nextafter(q[0], 2.0);
  CHECK(!same_geometry(system, System(model.with_initial_state(q, model.initial_v()))));
  CHECK(!same_geometry(system, System(four_bar(true))));
  CHECK(!same_geometry(system, System(four_bar_with_tail())));
}
