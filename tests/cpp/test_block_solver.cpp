#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <set>

#include "block_solver_checks.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/model/special/coupler.hpp"

using namespace support;

namespace {

/// A square net of n x n nodes, rods between neighbours joined by balls, the first node on the ground.
Model net(Random& random, int n) {
  Model model;
  std::vector<std::vector<std::pair<int, double>>> rods_at(n * n);  // (body, end along its x)
  std::vector<Vec3<double>> nodes;
  for (int k = 0; k < n * n; ++k) nodes.emplace_back(k % n, k / n, 0.3 * random.number());
  const auto add_rod = [&](int a, int b) {
    const Vec3<double> along = nodes[b] - nodes[a];
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3<double>::UnitX(), along);
    Body rod;
    rod.inertia = Vec3<double>(0.002, 0.08, 0.08).asDiagonal();
    rod.position = 0.5 * (nodes[a] + nodes[b]);
    rod.orientation = {turn.w(), turn.x(), turn.y(), turn.z()};
    const int body = model.add_body("rod" + std::to_string(model.bodies().size()), rod);
    rods_at[a].emplace_back(body, -0.5 * along.norm());
    rods_at[b].emplace_back(body, 0.5 * along.norm());
  };
  for (int k = 0; k < n * n; ++k) {
    if (k % n + 1 < n) add_rod(k, k + 1);
    if (k + n < n * n) add_rod(k, k + n);
  }
  for (std::size_t node = 0; node < rods_at.size(); ++node)
    for (std::size_t k = node == 0 ? 0 : 1; k < rods_at[node].size(); ++k) {
      const auto& [body, end] = rods_at[node][k];
      const bool grounded = node == 0 && k == 0;
      const auto& [other, other_end] = grounded ? std::pair<int, double>(ground, 0.0) : rods_at[node].front();
      Attachment<double> at{Vec3<double>(other_end, 0, 0), Vec3<double>(end, 0, 0), Mat3<double>::Identity(),
                            Mat3<double>::Identity()};
      if (grounded) at.s_i = nodes[0];
      model.add_joint("spherical", "ball" + std::to_string(model.joints().size()), other, body, at);
    }
  return model;
}

/// A tree with loops closed by every kind of joint.
Model loops(Random& random, int bodies) {
  Model model = random_tree(random, bodies);
  for (std::size_t kind = 0; kind < joint_kinds().size(); ++kind) {
    const int i = random.integer(0, bodies - 1), j = random.integer(ground, bodies - 1);
    if (i != j) add_joint(model, random, joint_kinds()[kind].info.name, "closing" + std::to_string(kind), i, j);
  }
  return model;
}

/// So many times the same mechanism of hinges between bodies.
Model copies(const Model& model, int count) {
  Model out;
  const auto n = static_cast<int>(model.bodies().size());
  for (int copy = 0; copy < count; ++copy) {
    const std::string name = std::to_string(copy) + " ";
    for (int k = 0; k < n; ++k) out.add_body(name + model.body_name(k), model.bodies()[k]);
    for (std::size_t k = 0; k < model.joints().size(); ++k) {
      const Element& it = model.joints()[k];
      const int i = it.i == ground ? ground : it.i + copy * n;
      out.add_joint("revolute", name + model.joint_name(static_cast<int>(k)), i, it.j + copy * n, it.at);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("open branches of every kind of joint are solved on every instruction set") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(11);
    for (const JointKind& kind : joint_kinds()) {
      INFO(kind.info.name);
      const System system(random_chain(random, 12, kind.info.name));
      check_solves(solver, system, random, false);
      check_solves(solver, system, random, true);
    }
    const System tree(random_tree(random, 60));
    check_solves(solver, tree, random, false);
  });
}

TEST_CASE("hinges, welds and sliders on the ground that are violated by far are solved, too") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(13);
    int turned_away = 0;  // axes that are nearly perpendicular
    for (int trial = 0; trial < 20; ++trial) {
      Model model;
      for (int body = 0; body < 8; ++body) {
        model.add_body("body" + std::to_string(body), random_body(random));
        const Attachment<double> at = random_attachment(random);
        const int i = random.integer(ground, body - 1);
        const char* kind = body % 3 == 2 ? "fixed" : i == ground && body % 2 == 1 ? "translational" : "revolute";
        model.add_joint(kind, "joint" + std::to_string(body), i, body, at);
        const Mat3<double> A_i = i == ground ? Mat3<double>(Mat3<double>::Identity())
                                             : rotation_matrix<double>(model.bodies()[i].orientation);
        const Vec3<double> z_j = rotation_matrix<double>(model.bodies()[body].orientation) * at.C_j.col(2);
        turned_away += std::abs((A_i * at.C_i.col(2)).dot(z_j)) < 0.1;
      }
      check_solves(solver, System(model), random, false);
    }
    CHECK(turned_away > 5);
  });
}

TEST_CASE("loops closed by every kind of joint, dependent rows included, are solved with compliance") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(12);
    for (int trial = 0; trial < 20; ++trial) {
      const System system(loops(random, random.integer(3, 25)));
      check_solves(solver, system, random, true);
    }
  });
}

TEST_CASE("nets, whose fronts are wider than a vector, are solved exactly") {
  for_every_instruction_set([](SaddleSolver& solver) {
    for (const int n : {2, 3, 5, 9, 14}) {
      INFO("net ", n);
      Random random(static_cast<std::uint64_t>(n));
      const System system(net(random, n));
      check_solves(solver, system, random, false);
      check_solves(solver, system, random, true);
    }
  });
}

TEST_CASE("fronts of every width and height are eliminated on every instruction set") {
  std::set<int> widths, heights, lanes_filled;
  for_every_instruction_set([&](SaddleSolver& solver) {
    Random random(14);
    for (int trial = 0; trial < 120; ++trial) {
      const int rows = 3 + trial % 40;
      INFO(rows, " rows");
      Model model;
      const int bodies = std::max(3, rows / 5);
      for (int body = 0; body < bodies; ++body) model.add_body("body" + std::to_string(body), random_body(random));
      while (model.row_count() < rows) {
        const int k = static_cast<int>(model.joints().size()), i = k % bodies;
        const int j = k < bodies ? (i + 1) % bodies : random.integer(ground, bodies - 1);
        const char* kind = rows - model.row_count() >= 3 && random.number() > 0.6 ? "spherical" : "distance";
        if (i != j) add_joint(model, random, kind, "joint" + std::to_string(k) + kind, i, j);
        else add_joint(model, random, kind, "joint" + std::to_string(k) + kind, ground, j);
      }
      const System system(model);
      check_solves(solver, system, random, true);
      const block::SymbolicFactorization symbolic(system);
      for (const block::Front& front : symbolic.fronts) {
        widths.insert(front.width);
        heights.insert(front.size);
        lanes_filled.insert((front.size - front.width) % block::lanes);
      }
    }
  });
  for (int width = 1; width <= 2 * block::lanes; ++width) CHECK_MESSAGE(widths.count(width) == 1, width, " wide");
  for (int height = 3; height < 3 * block::lanes; ++height) CHECK_MESSAGE(heights.count(height) == 1, height, " high");
  CHECK(lanes_filled.size() == block::lanes);
}

TEST_CASE("accelerations agree with dense elimination where masses are spread over six decades") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(13);
    Model model = net(random, 3);
    Model scaled;
    for (std::size_t k = 0; k < model.bodies().size(); ++k) {
      Body body = model.bodies()[k];
      const double factor = std::pow(10.0, random.number(-3.0, 3.0));
      body.mass *= factor;
      body.inertia *= factor;
      scaled.add_body(model.body_name(static_cast<int>(k)), body);
    }
    for (const Element& joint : model.joints())
      scaled.add_joint("spherical", "j" + std::to_string(scaled.joints().size()), joint.i, joint.j, joint.at);
    const System system(scaled);
    const Evaluation at = evaluate_initially(system);
    const MatrixXd M = dense_M(scaled), D = dense_D(system, at);
    const VectorXd a = M * random.vector(system.v_size()), b = random.vector(system.row_count());
    const MatrixXd W = dense_inverse(M);
    const VectorXd l = dense_solution(dense_delassus(M, D), b - D * (W * a)), exact = W * (a + D.transpose() * l);
    VectorXd x(a.size()), lambda(b.size());
    solver.analyze(system, at);
    solver.factorize_and_solve(at, VectorXd::Zero(b.size()), a, b, x, lambda);
    CHECK(relative_error(x, exact) < 1e-10);
  });
}

TEST_CASE("a body without joints falls freely") {
  Random random(14);
  Model model;
  model.add_body("free", random_body(random));
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const VectorXd a = random.vector(6);
  VectorXd x(6), lambda(0), exact(6);
  system.multiply_inverse_mass(a, exact);
  for_every_instruction_set([&](SaddleSolver& solver) {
    solver.analyze(system, at);
    solver.factorize_and_solve(at, VectorXd(0), a, VectorXd(0), x, lambda);
    CHECK(relative_error(x, exact) < 1e-14);
  });
}

namespace {

/// A body with balls to `arms` others whose neighbors are at fixed distances from each other, all round.
Model hub(Random& random, int arms, bool loops, const Model& start = Model()) {
  Model model = start;
  const int hub = static_cast<int>(model.bodies().size()), first = hub + 1;
  model.add_body("hub" + std::to_string(hub), random_body(random));
  for (int arm = 0; arm < arms; ++arm) {
    const std::string number = std::to_string(first + arm);
    model.add_body("arm" + number, random_body(random));
    add_joint(model, random, "spherical", "shoulder" + number, hub, first + arm);
  }
  for (int arm = 0; loops && arm < arms; ++arm)
    add_joint(model, random, "distance", "loop" + std::to_string(first + arm), first + arm, first + (arm + 1) % arms);
  return model;
}

}  // namespace

TEST_CASE("a hub with many arms costs in proportion to its arms, with loops too") {
  const auto flops = [](int arms, bool loops) {
    Random random(15);
    return block::SymbolicFactorization(System(hub(random, arms, loops))).flops;
  };
  for (const bool loops : {false, true}) CHECK(flops(3000, loops) / flops(300, loops) < 10.1);
}

TEST_CASE("hubs in loops, with branches, joined to the ground and to each other, are solved exactly") {
  for_every_instruction_set([](SaddleSolver& solver) {
    for (const int arms : {14, 40}) {
      Random random(static_cast<std::uint64_t>(arms));
      Model model = hub(random, arms, true);
      add_joint(model, random, "universal", "axle", ground, 0);
      for (int branch = 0; branch < 3; ++branch) {
        model.add_body("branch" + std::to_string(branch), random_body(random));
        add_joint(model, random, "revolute", "pin" + std::to_string(branch), 0, arms + 1 + branch);
      }
      const int other = static_cast<int>(model.bodies().size());
      model = hub(random, arms, true, model);
      add_joint(model, random, "distance", "link", 0, other);
      add_joint(model, random, "distance", "rope", 3, other + 5);
      const System system(model);
      CHECK(block::SymbolicFactorization(system).hubs.size() == 2);
      check_solves(solver, system, random, false);
      check_solves(solver, system, random, true);
    }
  });
}

TEST_CASE("joints that a held hub would make dependent wait for the hub") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(17);
    Model model;
    model.add_body("platform", random_body(random));
    for (int leg = 1; leg <= 16; ++leg) {  // six of them with one equation more than a leg has freedoms
      const std::string number = std::to_string(leg);
      model.add_body("leg" + number, random_body(random));
      add_joint(model, random, "spherical", "foot" + number, ground, leg);
      add_joint(model, random, leg % 2 && leg < 12 ? "universal" : "distance", "ankle" + number, leg, 0);
    }
    const System system(model);
    CHECK(block::SymbolicFactorization(system).hubs.size() == 1);
    check_solves(solver, system, random, false);
    check_solves(solver, system, random, true);
  });
}

TEST_CASE("a pivot that was delayed stays so, also in a solver that goes on from where another has come to") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(18);
    const System system(hub(random, 16, true));
    REQUIRE(block::SymbolicFactorization(system).hubs.size() == 1);
    const Evaluation at = evaluate_initially(system);
    Evaluation held = at;  // two equations of a joint depend on each other while the hub is held
    for (const int index : system.joint_blocks(0))
      if (const ConstraintBlock& block = system.blocks()[index]; block.body != 0) {
        Eigen::Map<Eigen::Matrix<double, velocity_size, 3>> rows(held.D.data() + block.offset);
        rows.col(1) = rows.col(0) + 1e-6 * rows.col(1);
      }
    const VectorXd a = random.vector(system.v_size()), b = random.vector(system.row_count());
    const VectorXd none = VectorXd::Zero(b.size());
    const auto solution = [&](SaddleSolver& by) {
      VectorXd out(a.size() + b.size());
      by.factorize_and_solve(at, none, a, b, out.head(a.size()), out.tail(b.size()));
      return out;
    };
    solver.analyze(system, at);
    const VectorXd usual = solution(solver);
    solver.factorize(held, none);
    const VectorXd delayed = solution(solver);
    CHECK(relative_error(delayed, usual) < 1e-10);
    CHECK((delayed.array() != usual.array()).any());
    Archive written;
    solver.keep(written);
    const std::string state = written.take();
    solver.analyze(system, at);
    Archive read(state);
    solver.keep(read);
    CHECK((solution(solver).array() == delayed.array()).all());
  });
}

TEST_CASE("couplers among many bodies are solved, of trees, loops and hubs") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(21);
    for (int trial = 0; trial < 30; ++trial) {
      Model model = trial % 3 == 0   ? random_tree(random, random.integer(2, 30))
                    : trial % 3 == 1 ? loops(random, random.integer(3, 25))
                                     : hub(random, random.integer(8, 20), trial % 2);
      std::vector<CoupledCoordinate> angles;
      for (int k = 0; k < 4; ++k) {
        const int i = random.integer(ground, static_cast<int>(model.bodies().size()) - 2), j = i + 1;
        add_joint(model, random, "revolute", "hinge" + std::to_string(k), i, j);
        angles.push_back({static_cast<int>(model.joints().size()) - 1, "angle", random.number(0.5, 2.0)});
      }
      for (int k = 0; k < 2; ++k) {
        const std::vector<CoupledCoordinate> some(angles.begin() + k, angles.begin() + 2 + random.integer(k, 2));
        const Element& first = model.joints()[some.front().joint];
        model.add_special_joint("coupler", "coupler" + std::to_string(k), first.i, first.j, first.at,
                                std::make_shared<Coupler>(model, some), {Parameter{}});
      }
      const System system(model);
      check_solves(solver, system, random, true);
    }
    Model gears = random_chain(random, 8, "revolute");  // exact, where nothing is redundant
    for (int k = 0; k < 2; ++k)
      gears.add_special_joint(
          "coupler", "coupler" + std::to_string(k), 0, 1, gears.joints()[0].at,
          std::make_shared<Coupler>(gears,
                                    std::vector<CoupledCoordinate>{{3 * k, "angle", 1.0}, {3 * k + 1, "angle", -2.5}}),
          {Parameter{}});
    check_solves(solver, System(gears), random, false);
  });
}

TEST_CASE("dropped rows are left out, whole joints included, as if they were not there") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(19);
    for (int trial = 0; trial < 20; ++trial) {
      Model model = trial % 2 ? loops(random, random.integer(3, 25)) : hub(random, random.integer(8, 20), true);
      const Element doubled = model.joints()[1];
      const KindInfo& kind = joint_kinds()[doubled.kind].info;
      model.add_joint(kind.name, "again", doubled.i, doubled.j, doubled.at,
                      std::vector<Parameter>(kind.parameters.size(), Parameter{1.0, -1}));
      const System system(model);
      Evaluation at = evaluate_initially(system);
      VectorXd e = 1e-3 * (random.vector(system.row_count()).array() + 1.5), b = random.vector(system.row_count());
      const VectorXd a = random.vector(system.v_size());
      std::vector<int> dropped;
      for (int row = 0; row < system.row_count(); ++row)
        if (random.integer(0, 9) == 0 || system.model().joint_of_row(row) == system.joint_count() - 1)
          dropped.push_back(row);
      for (const ConstraintBlock& block : system.blocks())
        for (int k = 0; k < block.rows; ++k)
          if (std::find(dropped.begin(), dropped.end(), block.row + k) != dropped.end())
            std::fill_n(at.D.begin() + block.offset + 6 * k, 6, 0.0);
      for (const int row : dropped) b[row] = 0.0;
      VectorXd x(a.size()), lambda(b.size()), x_all(a.size()), lambda_all(b.size());
      solver.drop({});
      solver.analyze(system, at);
      solver.factorize_and_solve(at, e, a, b, x_all, lambda_all);
      const auto nonzeros = solver.factor_nonzeros();
      solver.drop(dropped);
      solver.analyze(system, at);
      lambda.setConstant(NAN);
      solver.factorize_and_solve(at, e, a, b, x, lambda);
      CHECK(relative_error(x, x_all) < 1e-11);
      CHECK(relative_error(lambda, lambda_all) < 1e-11);
      CHECK(solver.factor_nonzeros() < nonzeros);
    }
  });
}

TEST_CASE("a doubled joint is refused and named, and so is a body without mass") {
  for_every_instruction_set([](SaddleSolver& solver) {
    Random random(16);
    Model model = random_chain(random, 3, "revolute");
    const Element& pin = model.joints()[1];
    model.add_joint("revolute", "again", pin.i, pin.j, pin.at);
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    solver.analyze(system, at);
    try {
      solver.factorize(at, VectorXd::Zero(system.row_count()));
      FAIL("a doubled joint was factorized");
    } catch (const SingularSystemError& error) {
      REQUIRE(error.details.joints.size() == 1);
      const std::string& joint = error.details.joints.front();
      CHECK((joint == "again" || joint == "revolute1"));
    }
  });
  Model model;
  Body massless;
  massless.mass = 0.0;
  model.add_body("ghost", massless);
  const System system(model);
  CHECK_THROWS_WITH_AS(block::make_block_solver()->analyze(system, evaluate_initially(system)),
                       doctest::Contains("ghost"), OptionError);
}

TEST_CASE("the same numbers give the same factors to the last bit") {
  Random random(18);
  const System system(net(random, 6));
  const Evaluation at = evaluate_initially(system);
  const VectorXd e = VectorXd::Zero(system.row_count()), a = random.vector(system.v_size()),
                 b = random.vector(system.row_count());
  for_every_instruction_set([&](SaddleSolver& solver) {
    VectorXd x(a.size()), lambda(b.size()), x_again(a.size()), lambda_again(b.size());
    solver.analyze(system, at);
    solver.factorize_and_solve(at, e, a, b, x, lambda);
    solver.factorize_and_solve(at, (e.array() + 2.0).matrix(), 3.0 * a, b, x_again, lambda_again);
    solver.factorize_and_solve(at, e, a, b, x_again, lambda_again);
    CHECK((x_again.array() == x.array()).all());
    CHECK((lambda_again.array() == lambda.array()).all());
  });
}

TEST_CASE("factors that are written past the caches, as those of many bodies are, have the bits of others") {
  constexpr int count = 700;  // of 40 bodies with 640 bytes each
  Random random(21);
  const Model model = random_chain(random, 40, "revolute");
  const System one(copies(model, 1)), many(copies(model, count));
  const Evaluation at_one = evaluate_initially(one), at_many = evaluate_initially(many);
  const VectorXd e, a = random.vector(one.v_size()), b = random.vector(one.row_count());
  VectorXd x(one.v_size()), lambda(one.row_count()), x_many(many.v_size()), lambda_many(many.row_count());
  for_every_instruction_set([&](SaddleSolver& solver) {
    solver.analyze(one, at_one);
    solver.factorize_and_solve(at_one, e, a, b, x, lambda);
    solver.analyze(many, at_many);
    solver.factorize_and_solve(at_many, e, a.replicate(count, 1).eval(), b.replicate(count, 1).eval(), x_many,
                               lambda_many);
    CHECK((x_many.array() == x.replicate(count, 1).array()).all());
    CHECK((lambda_many.array() == lambda.replicate(count, 1).array()).all());
  });
}

TEST_CASE("a state that is not a number never factorizes") {
  Random random(17);
  for (const bool open : {true, false}) {
    const System system(open ? random_chain(random, 4, "revolute") : net(random, 3));
    Evaluation at = evaluate_initially(system);
    at.D[system.blocks().back().offset] = NAN;
    for_every_instruction_set([&](SaddleSolver& solver) {
      solver.analyze(system, at);
      CHECK_THROWS_AS(solver.factorize(at, VectorXd::Zero(system.row_count())), SingularSystemError);
    });
  }
}

namespace {

/// Accelerations by elimination of D M^-1 D^T in extended precision.
VectorXd extended_accelerations(const System& system, const Evaluation& at, const VectorXd& a, const VectorXd& b) {
  using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const Matrix D = dense_D(system, at).cast<long double>();
  Matrix G = D.transpose();             // M^-1 D^T
  Vector free = a.cast<long double>();  // M^-1 a
  for (int body = 0; body < system.body_count(); ++body) {
    const Eigen::Matrix<long double, 3, 3> J_inverse = system.inertia(body).cast<long double>().inverse();
    G.middleRows<3>(6 * body) /= system.mass(body);
    G.middleRows<3>(6 * body + 3) = (J_inverse * G.middleRows<3>(6 * body + 3)).eval();
    free.segment<3>(6 * body) /= system.mass(body);
    free.segment<3>(6 * body + 3) = (J_inverse * free.segment<3>(6 * body + 3)).eval();
  }
  const Vector lambda = (D * G).ldlt().solve(b.cast<long double>() - D * free);
  return (free + G * lambda).cast<double>();
}

}  // namespace

TEST_CASE("accelerations of large mechanisms agree with extended precision, with masses 1e6 : 1 as well") {
  Random random(21);
  const Model chain = random_chain(random, 60, "revolute"), tree = random_tree(random, 100), mesh = net(random, 7);
  for (const Model* model : {&chain, &tree, &mesh})
    for (const bool spreads : {false, true}) {
      const System system(spreads ? spread(*model, random, 6.0) : *model);
      CAPTURE(system.body_count());
      CAPTURE(spreads);
      const Evaluation at = evaluate_initially(system);
      const VectorXd a = at.g.head(system.v_size()), e = VectorXd::Zero(system.row_count());
      const VectorXd exact = extended_accelerations(system, at, a, at.gamma);
      // a light body between heavy ones: forces cancel by six digits
      const double roundoff = spreads ? 1e-9 : 1e-12;
      for_every_instruction_set([&](SaddleSolver& solver) {
        VectorXd x(a.size()), lambda(e.size());
        solver.analyze(system, at);
        solver.factorize_and_solve(at, e, a, at.gamma, x, lambda);
        const auto [first, second] = residuals(system, at, e, a, at.gamma, x, lambda);
        CHECK(first < roundoff);
        CHECK(second < roundoff);
        CHECK(relative_error(x, exact) < 1e-10);
      });
    }
}
