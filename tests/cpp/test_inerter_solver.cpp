#include <doctest/doctest.h>

#include <utility>

#include "dense_algebra.hpp"
#include "linkwork/linear/block/block_solver.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// A tree with inertia along its first coordinates, small and large.
Model with_inerters(Random& random) {
  Model model = random_tree(random, 4);
  double b = 1e-3;
  for (const char* kind : {"inerter", "rotational_inerter", "translational_inerter"}) {
    model.add_force(kind, kind, 0, 3, random_attachment(random), {{b, -1}});
    b *= 100.0;
  }
  return model;
}

MatrixXd dense_mass(const System& system, const Evaluation& at) {
  MatrixXd M(system.v_size(), system.v_size());
  VectorXd column(system.v_size());
  for (Eigen::Index k = 0; k < M.cols(); ++k) {
    system.multiply_mass(at, VectorXd::Unit(M.cols(), k), column);
    M.col(k) = column;
  }
  return M;
}

constexpr const char* kinds[] = {"inerter", "rotational_inerter", "translational_inerter"};

void add_inerter(Model& model, Random& random, int kind, double inertance, int i, int j) {
  model.add_force(kinds[kind], "inerter " + std::to_string(model.forces().size()), i, j, random_attachment(random),
                  {{inertance, -1}});
}

/// [M D^T d^T; D -E 0; d 0 -1/b] with the rows d of inerters: no entry of it is large.
MatrixXd dense_matrix(const System& system, const Evaluation& at, const VectorXd& e) {
  const MatrixXd D = dense_D(system, at);
  const auto n = static_cast<Eigen::Index>(system.v_size()), m = D.rows();
  const auto count = static_cast<Eigen::Index>(system.inerters().count());
  MatrixXd K = MatrixXd::Zero(n + m + count, n + m + count);
  K.topLeftCorner(n, n) = dense_M(system.model());
  K.block(n, 0, m, n) = D;
  K.block(n, n, m, m) = -MatrixXd(e.asDiagonal());
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto inerter = static_cast<std::size_t>(k);
    for (const Inerters::Part& part : system.inerters().row(inerter, at.D.data()))
      if (part.body != ground)
        K.row(n + m + k).segment<6>(6 * part.body) = Eigen::Map<const Eigen::Matrix<double, 1, 6>>(part.d);
    K(n + m + k, n + m + k) = -1.0 / system.inerters().inertance(inerter);
  }
  K.topRightCorner(n, m + count) = K.bottomLeftCorner(m + count, n).transpose();
  return K;
}

/// By the block solver of each instruction set, x and lambda against those of the dense matrix.
void check_by_block(const System& system, Random& random, bool compliant, double tolerance = 1e-10) {
  const Evaluation at = evaluate_initially(system);
  const Eigen::Index n = system.v_size(), m = system.row_count();
  const VectorXd e = VectorXd::Constant(m, compliant ? 1e-3 : 0.0);
  const VectorXd a = random.vector(n), b = random.vector(m);
  VectorXd right = VectorXd::Zero(n + m + static_cast<Eigen::Index>(system.inerters().count()));
  right.head(n + m) << a, b;
  const VectorXd expected = accurate_solution(dense_matrix(system, at, e), right);
  for (int level = 0; level < instruction_set_count(); ++level) {
    INFO("kernels of ", std::string(instruction_set(level).name));
    const auto solver = detail::with_inerters(block::make_block_solver(instruction_set(level)));
    VectorXd x(n), lambda(m), again(n);
    solver->analyze(system, at);
    solver->factorize_and_solve(at, e, a, b, x, lambda);
    CHECK(relative_error(x, expected.head(n)) < tolerance);
    CHECK(relative_error(VectorXd(-lambda), expected.segment(n, m)) < tolerance);
    solver->solve(2.0 * a, 2.0 * b, again, lambda);
    CHECK(relative_error(again, 2.0 * x) < tolerance);
  }
}

}  // namespace

TEST_CASE("every solver solves with the mass matrix that inerters are part of") {
  Random random(311);
  const System system(with_inerters(random));
  const Evaluation at = evaluate_initially(system);
  const MatrixXd M = dense_mass(system, at), D = dense_D(system, at);
  const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
  for (const MatrixForm& form : matrix_forms())
    for (const LinearSolverInfo& info : linear_solvers()) {
      if (!info.available() || !can_solve(form.name, info)) continue;
      INFO(form.name, " by ", info.name);
      const bool plain = std::string(form.name) == "kkt" && !info.make_saddle;  // E = 0 there
      const VectorXd e = VectorXd::Constant(b.size(), plain ? 0.0 : 0.02);
      const auto solver = make_saddle_solver(form.name, info, system);
      solver->analyze(system, at);
      VectorXd right(a.size() + b.size()), x(a.size()), lambda(b.size());
      right << a, b;
      MatrixXd K(right.size(), right.size());
      K << M, D.transpose(), D, -MatrixXd(e.asDiagonal());
      const VectorXd expected = dense_solution(K, right);
      solver->factorize(at, e);
      solver->solve(a, b, x, lambda);
      CHECK(relative_error(x, expected.head(a.size())) < 1e-9);
      solver->factorize_and_solve(at, e, a, b, x, lambda);
      CHECK(relative_error(x, expected.head(a.size())) < 1e-9);
      VectorXd left(a.size());
      system.multiply_mass(at, x, left);
      left -= D.transpose() * lambda;
      CHECK(relative_error(left, a) < 1e-9);
      CHECK(solver->smallest_pivot() > 0.0);
      CHECK(solver->factor_nonzeros() > 0);
    }
}

TEST_CASE("without inerters nothing stands between") {
  Random random(312);
  const System system(random_tree(random, 3));
  const Evaluation at = evaluate_initially(system);
  const auto solver = make_saddle_solver("kkt", linear_solver_info("block"), system);
  solver->analyze(system, at);
  const auto plain = make_saddle_solver("kkt", linear_solver_info("block"));
  plain->analyze(system, at);
  CHECK(solver->factor_nonzeros() == plain->factor_nonzeros());
}

TEST_CASE("beside joints of every kind inerters of every kind are solved, as many as there are") {
  Random random(313);
  for (const JointKind& kind : joint_kinds())
    for (const int each : {1, 2, 3, 7}) {  // from one to more than a joint has room for
      INFO(kind.info.name, ", ", each, " inerters");
      Model model = random_chain(random, 3, kind.info.name);
      for (int body = 0; body < 3; ++body)
        for (int k = 0; k < each; ++k) {
          const bool turned = (body + k) % 2 == 1;  // bodies the other way round than the joint has them
          add_inerter(model, random, (body + k) % 3, 0.2 + k, turned ? body : body - 1, turned ? body - 1 : body);
        }
      const System system(model);
      check_by_block(system, random, false);
      check_by_block(system, random, true);
    }
}

TEST_CASE("inertances from nothing to rigidity are solved, along what moves and along what does not") {
  Random random(314);
  for (const double inertance : {1e-12, 1e-3, 1e3, 1e6, 1e9}) {
    INFO("inertance ", inertance);
    for (const bool slides : {false, true}) {
      INFO("sliders: ", slides);
      Model model = random_chain(random, 6, slides ? "translational" : "revolute");
      for (int body = 0; body < 6; ++body) {
        const Element joint = model.joints()[body];
        model.add_force(slides ? "translational_inerter" : "rotational_inerter", "rotor " + std::to_string(body),
                        body - 1, body, joint.at, {{body % 2 ? 0.1 : inertance, -1}});
      }
      check_by_block(System(model), random, false, 1e-11);
      if (inertance > 1e6) continue;  // as hard as joints that contradict each other, along what does not move
      for (int kind = 0; kind < 3; ++kind) add_inerter(model, random, kind, inertance, 2 * kind - 1, 2 * kind);
      check_by_block(System(model), random, false, 1e-8);  // roundoff of the rows times 1e6
    }
  }
}

TEST_CASE(
    "hinges and sliders, with rotors or without, and welds are solved whichever body is first, and far off them") {
  Random random(317);
  constexpr std::pair<const char*, const char*> joints[] = {{"revolute", "rotational_inerter"},
                                                            {"translational", "translational_inerter"}};
  for (const double violation : {0.0, 0.1, 3.0}) {
    INFO("turned by up to ", violation, " rad");
    Model model;
    for (int body = 0; body < 20; ++body) {
      const std::string name = std::to_string(body);
      const auto [kind, rotor] = joints[body % 5 % 2];
      model.add_body("body " + name, random_body(random));
      int i = random.integer(ground, body - 1), j = body;
      if (body % 2 == 1) std::swap(i, j);
      const Mat3<double> frame = random.frame();
      const Vec3<double> point = random.vec3();
      Attachment<double> at = place(model, i, j, point, point, frame, frame);
      at.C_j = (at.C_j * rotation_matrix<double>(exponential(random.vec3(violation)))).eval();
      model.add_joint(body % 5 == 4 ? "fixed" : kind, "joint " + name, i, j, at);
      if (body % 5 < 2) model.add_force(rotor, "rotor " + name, i, j, at, {{0.2 * body + 0.1, -1}});
    }
    check_by_block(System(model), random, false, violation > 1.0 ? 1e-9 : 1e-11);
    check_by_block(System(model), random, true);
  }
}

TEST_CASE("large inertances that are not along what a joint leaves free cost no digits") {
  Random random(318);
  constexpr std::pair<const char*, const char*> joints[] = {{"revolute", "translational_inerter"},
                                                            {"revolute", "rotational_inerter"},
                                                            {"translational", "translational_inerter"}};
  for (const auto& [kind, rotor] : joints)
    for (const double inertance : {1e5, 1e8, 1e10}) {
      INFO(std::string(rotor), " of ", inertance, " on ", std::string(kind));
      Model model = random_chain(random, 1, kind);
      model.add_force(rotor, "rotor", ground, 0, random_attachment(random), {{inertance, -1}});
      const System system(model);
      const Evaluation at = evaluate_initially(system);
      const VectorXd a = random.vector(6), none = VectorXd::Zero(5);
      const VectorXd g = dense_D(system, at).fullPivLu().kernel().col(0);  // M u_dot = a along the one freedom
      const double inertia = g.dot(dense_M(model) * g), along = system.inerters().rate(0, at.D.data(), g.data());
      const VectorXd expected = g * (g.dot(a) / (inertia + inertance * along * along));
      for (int level = 0; level < instruction_set_count(); ++level) {
        INFO("kernels of ", std::string(instruction_set(level).name));
        const auto solver = detail::with_inerters(block::make_block_solver(instruction_set(level)));
        VectorXd x(6), lambda(5);
        solver->analyze(system, at);
        solver->factorize_and_solve(at, none, a, none, x, lambda);
        CHECK(relative_error(x, expected) < 1e-13);
      }
    }
}

TEST_CASE("with vanishing inertance the solution is that without inerters") {
  Random random(315);
  const Model plain = random_chain(random, 5, "universal");
  Model model = plain;
  for (int body = 0; body < 5; ++body) add_inerter(model, random, 1, 1e-300, body - 1, body);
  const System with(model), without(plain);
  const Evaluation at = evaluate_initially(with), plain_at = evaluate_initially(without);
  const VectorXd a = random.vector(with.v_size()), b = random.vector(with.row_count()), e = VectorXd::Zero(b.size());
  VectorXd x(a.size()), lambda(b.size()), plain_x(a.size()), plain_lambda(b.size());
  const auto solve = [&](const System& system, const Evaluation& where, VectorXd& to, VectorXd& multipliers) {
    const auto solver = make_saddle_solver("kkt", linear_solver_info("block"), system);
    solver->analyze(system, where);
    solver->factorize_and_solve(where, e, a, b, to, multipliers);
  };
  solve(with, at, x, lambda);
  solve(without, plain_at, plain_x, plain_lambda);
  CHECK(relative_error(x, plain_x) < 1e-13);
  CHECK(relative_error(lambda, plain_lambda) < 1e-13);
}

TEST_CASE("in loops, beside joints and across, and on hubs inerters are solved") {
  Random random(316);
  for (const int arms : {5, 16}) {  // 16 joints make the body a hub
    INFO(arms, " arms");
    Model model;
    model.add_body("platform", random_body(random));
    for (int arm = 1; arm <= arms; ++arm) {
      const std::string number = std::to_string(arm);
      model.add_body("arm" + number, random_body(random));
      add_joint(model, random, "universal", "shoulder" + number, 0, arm);
      add_inerter(model, random, arm % 3, 0.1 * arm, arm, 0);
      if (arm % 4 == 0) add_inerter(model, random, 1, 2.0, 0, arm);
      if (arm % 5 == 0) add_inerter(model, random, 0, 0.7, arm - 1, arm);
    }
    for (int arm = 1; arm <= arms; ++arm) {
      add_joint(model, random, "distance", "loop" + std::to_string(arm), arm, 1 + arm % arms);
      if (arm % 3 == 0) add_inerter(model, random, 2, 0.4, arm, 1 + arm % arms);
    }
    add_joint(model, random, "revolute", "axle", ground, 0);
    add_inerter(model, random, 1, 3.0, ground, 0);
    const System system(model);
    check_by_block(system, random, false, 1e-9);
    check_by_block(system, random, true, 1e-9);
  }
}
