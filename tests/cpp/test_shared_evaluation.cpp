#include <doctest/doctest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "allocation_counter.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/thread_pool.hpp"
#include "mechanisms.hpp"

using namespace support;

/// Several threads share one evaluation: nothing that is found depends on how many they are.
namespace {

// Bodies: three chunks, and more work than one task takes; two chunks where sanitizers make it slow.
constexpr int many = sanitized ? 4200 : 10500, side = sanitized ? 40 : 60, breakdowns = sanitized ? 10 : 100;

/// A row of four-bars, each on the rocker of the one before: three of its equations in every loop are redundant.
Model ladder() {
  Model model(Vec3<double>(0.3, -9.81, 0.1));
  const auto bar = [&](const std::string& name, const Vec3<double>& from, const Vec3<double>& to) {
    return model.add_body(name, body_at(0.5 * (from + to)));
  };
  int left = bar("bar", {0, 0, 0}, {0, 1, 0});
  join(model, "revolute", "foot", ground, left, {0, 0, 0});
  for (int k = 0; 2 * k < many; ++k) {
    const std::string number = std::to_string(k);
    const Vec3<double> low(k + 1, 0, 0), high(k + 1, 1, 0), before(k, 1, 0);
    const int right = bar("bar " + number, low, high), across = bar("rail " + number, before, high);
    join(model, "revolute", "foot " + number, ground, right, low);
    join(model, "revolute", "left " + number, left, across, before);
    join(model, "revolute", "right " + number, across, right, high);
    left = right;
  }
  return model;
}

/// Hubs in a square and rods between them, on balls: n^2 + 2 n (n - 1) bodies.
Model net(int n) {
  Model model(Vec3<double>(0.0, 0.2, -9.81));
  std::vector<int> hub;
  for (int k = 0; k < n * n; ++k)
    hub.push_back(model.add_body("hub " + std::to_string(k), body_at(Vec3<double>(k % n, k / n, 0.0))));
  const auto rod = [&](int from, int to) {
    const Vec3<double> a = model.bodies()[hub[from]].position, b = model.bodies()[hub[to]].position;
    const std::string name = std::to_string(from) + " " + std::to_string(to);
    const int body = model.add_body("rod " + name, body_at(0.5 * (a + b)));
    join(model, "spherical", "first " + name, hub[from], body, a + 0.1 * (b - a));
    join(model, "spherical", "second " + name, body, hub[to], b - 0.1 * (b - a));
  };
  for (int k = 0; k < n * n; ++k) {
    if (k % n + 1 < n) rod(k, k + 1);
    if (k / n + 1 < n) rod(k, k + n);
  }
  join(model, "spherical", "corner", ground, hub.front(), {0, 0, 0});
  return model;
}

/// Joints of every kind, driven ones and those of couplers among them, with rods that close loops, two of them alike
/// now and then, and with more forces than a thread works on at a time.
Model mixed() {
  Random random(17);
  Model model = random_tree(random, many);
  for (int k = 5; k + 40 < many; k += 40) {
    const Attachment<double> at = random_attachment(random);
    for (int copy = 0; copy < (k % 3 == 0 ? 2 : 1); ++copy) {
      const std::string name = "rod " + std::to_string(k) + " " + std::to_string(copy);
      const Body &i = model.bodies()[k], &j = model.bodies()[k + 30];
      const Vec3<double> d = i.position + rotation_matrix<double>(i.orientation) * at.s_i - j.position -
                             rotation_matrix<double>(j.orientation) * at.s_j;
      model.add_joint("distance", name, k, k + 30, at, {{d.norm(), -1}});
    }
  }
  for (int k = 0; k < many / 2; ++k)
    for (const std::string kind : {"spring_damper", "linear_damping"}) {
      const KindInfo& info = force_kinds()[force_kind_index(kind)].info;
      model.add_force(kind, kind + std::to_string(k), k % 7 == 0 ? ground : random.integer(0, many / 3), many / 3 + k,
                      random_attachment(random), force_parameters(model, random, info));
    }
  return model;
}

/// Of different lengths, from one body.
Model branches() {
  Random random(5);
  Model model(random.vec3(9.81));
  model.add_body("trunk", random_body(random));
  add_joint(model, random, "universal", "root", ground, 0);
  for (int branch = 0, k = 1; k < many; ++branch)
    for (int length = 0; length < 1 + 700 * (branch % 5) && k < many; ++length, ++k) {
      model.add_body("link " + std::to_string(k), random_body(random));
      add_joint(model, random, branch % 2 ? "revolute" : "spherical", "joint " + std::to_string(k),
                length == 0 ? 0 : k - 1, k);
    }
  return model;
}

/// With a rotor beside each joint, and some inerters elsewhere.
Model with_rotors(Model model) {
  Random random(31);
  const auto joints = static_cast<int>(model.joints().size());
  for (int k = 0; k < joints; ++k) {
    const Element joint = model.joints()[k];
    model.add_force("rotational_inerter", "rotor " + std::to_string(k), joint.i, joint.j, joint.at,
                    {{random.number(0.01, 1.0), -1}});
    if (k % 1000 == 7)
      model.add_force("inerter", "inerter " + std::to_string(k), joint.j, k / 2, random_attachment(random),
                      {{0.1, -1}});
  }
  return model;
}

struct Found {
  VectorXd rows, g, numbers, v_dot, lambda, y_dot;
  MatrixXd reactions;
  bool operator==(const Found&) const = default;
};

/// Everything of one state, away from the initial one.
Found found(Dynamics& dynamics) {
  Random random(29);
  const System& system = dynamics.system();
  VectorXd y = dynamics.initial_y();
  for (Eigen::Index k = 0; k < y.size(); ++k) y[k] += 1e-3 * random.number();
  Found out;
  out.v_dot.resize(system.v_size());
  out.lambda.resize(system.row_count());
  out.y_dot.resize(dynamics.y_size());
  dynamics.evaluate(0.3, y);
  dynamics.rates(out.y_dot);
  dynamics.solve(out.y_dot.segment(7, system.v_size()), dynamics.evaluation().Phi, out.v_dot, out.lambda);
  dynamics.accelerations(out.v_dot, out.lambda);
  const Evaluation& at = dynamics.evaluation();
  out.rows.resize(4 * system.row_count() + static_cast<Eigen::Index>(at.D.size()));
  out.rows << at.Phi, at.Phi_t, at.Phi_dot, at.gamma, Eigen::Map<const VectorXd>(at.D.data(), std::ssize(at.D));
  out.g = at.g.head(system.v_size());
  out.numbers = Eigen::Vector2d(at.potential, at.power);
  Eigen::Matrix3Xd force(3, system.joint_count()), torque(3, system.joint_count());
  system.reactions(at, y.head(system.q_size()), out.lambda, force, torque);
  out.reactions.resize(6, system.joint_count());
  out.reactions << force, torque;
  return out;
}

/// Four threads look for the rank themselves.
void check_same_bits(const Model& model, Options options = {}) {
  options.threads = 1;
  Dynamics one(model, options);
  const Found alone = found(one);
  CHECK(alone.v_dot.allFinite());
  CHECK(alone.lambda.allFinite());
  for (const int threads : {2, 3, 4, 8}) {
    if (sanitized && threads != 4) continue;
    CAPTURE(threads);
    options.threads = threads;
    Dynamics several(model, options, threads == 4 ? nullptr : &one);
    CHECK(several.options().threads == threads);
    CHECK(found(several) == alone);
  }
}

}  // namespace

TEST_CASE("a chain has the same bits with any number of threads") {
  Random random(3);
  check_same_bits(random_chain(random, many, "revolute"));
}

TEST_CASE("branches of any length have the same bits with any number of threads") { check_same_bits(branches()); }

TEST_CASE("rotors beside the joints of chains, branches and loops have the same bits with any number of threads") {
  Random random(3);
  if (!sanitized) check_same_bits(with_rotors(random_chain(random, many, "revolute")));
  check_same_bits(with_rotors(branches()));
  check_same_bits(with_rotors(ladder()));
}

TEST_CASE("a ladder with redundant equations has the same bits with any number of threads") {
  check_same_bits(ladder());
}

TEST_CASE("a net has the same bits with any number of threads") {
  check_same_bits(net(side));
  check_same_bits(net(side), options_of("augmented_lagrangian"));
}

TEST_CASE("joints of all kinds, loops and forces have the same bits with any number of threads") {
  check_same_bits(mixed(), options_of("augmented_lagrangian"));
}

TEST_CASE("sparse solvers share the evaluation, and have the same bits with any number of threads") {
  Random random(3);
  check_same_bits(random_chain(random, many, "spherical"), options_of("standard", "schur", "eigen_ldlt"));
}

TEST_CASE("a small model takes one thread, whatever was asked for") {
  Random random(4);
  Options options;
  options.threads = 8;
  CHECK(Dynamics(random_chain(random, 50, "revolute"), options).options().threads == 1);
}

namespace {

/// Solutions by the block solver on so many threads; what a breakdown says, or nothing.
class Solutions {
 public:
  Solutions(const Model& model, int threads) : system_(model) {
    system_.use(std::make_shared<ThreadPool>(threads));
    at_ = evaluate_initially(system_);
    solver_ = make_saddle_solver("kkt", linear_solver_info("block"), system_);
    solver_->analyze(system_, at_);
    CHECK(solver_->shares_work());
  }

  std::string solve() {
    x_.setZero(system_.v_size());
    lambda_.setZero(system_.row_count());
    try {
      solver_->factorize_and_solve(at_, {}, at_.g.head(system_.v_size()), at_.gamma, x_, lambda_);
    } catch (const SingularSystemError& error) {
      return error.what();
    }
    return {};
  }

  /// As `solve` where this joint holds nothing.
  std::string solve_without(int joint) {
    const auto whole = at_.D;
    for (const int index : system_.joint_blocks(joint)) {
      const ConstraintBlock& block = system_.blocks()[index];
      std::fill_n(at_.D.begin() + block.offset, 6 * block.rows, 0.0);
    }
    const std::string found = solve();
    at_.D = whole;
    return found;
  }

  const System& system() const { return system_; }
  const VectorXd& x() const { return x_; }

 private:
  System system_;
  Evaluation at_;
  std::unique_ptr<SaddleSolver> solver_;
  VectorXd x_, lambda_;
};

}  // namespace

TEST_CASE("a hundred breakdowns anywhere end with the error of one thread, and the next solution has its bits") {
  const Model model = net(30);
  Solutions one(model, 1), four(model, 4);
  CHECK(one.solve().empty());
  const VectorXd right = one.x();
  Random random(37);
  for (int round = 0; round < breakdowns; ++round) {
    const int joint = random.integer(0, one.system().joint_count() - 1);
    CAPTURE(joint);
    const std::string found = four.solve_without(joint);
    CHECK(found.find("'" + model.joint_name(joint) + "'") != std::string::npos);
    CHECK(found == one.solve_without(joint));
    CHECK(four.solve().empty());
    CHECK(four.x() == right);
  }
}

#if CAN_COUNT_ALLOCATIONS
TEST_CASE("several threads allocate nothing in an evaluation after the first") {
  const Options standard, tolerant = options_of("augmented_lagrangian");
  for (const auto& [model, given] : {std::pair(branches(), standard), std::pair(net(30), standard),
                                     std::pair(ladder(), standard), std::pair(with_rotors(ladder()), standard),
                                     std::pair(with_rotors(branches()), standard), std::pair(mixed(), tolerant)}) {
    Options options = given;
    options.threads = 3;
    Dynamics dynamics(model, options);
    CHECK(dynamics.options().threads == 3);
    VectorXd y_dot(dynamics.y_size());
    const VectorXd y = dynamics.initial_y();
    const auto evaluate = [&] {
      dynamics.evaluate(0.1, y);
      dynamics.rates(y_dot);
    };
    evaluate();
    CHECK(allocations(evaluate) == 0);
  }
}
#endif
