#include "linkwork/ensemble/ensemble.hpp"
#include "linkwork/ensemble/lane_speeds.hpp"
#include "linkwork/ensemble/lane_trials.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

constexpr double duration = sanitized ? 0.01 : 0.05;  // of fixed steps [s]
constexpr int every = sanitized ? 2 : 10;             // of these a frame

Options deterministic(const char* stabilization = "sampled_baumgarte") {
  Options options;
  options.deterministic = true;
  options.stabilization = stabilization;
  return options;
}

/// The last q of each mechanism, by registers of one width.
std::vector<VectorXd> last_states(const std::vector<Model>& models, const Options& options,
                                  const InstructionSet& widest, int threads) {
  std::vector<std::unique_ptr<Dynamics>> dynamics;
  std::vector<Dynamics*> all;
  for (const Model& model : models) {
    dynamics.push_back(std::make_unique<Dynamics>(model, options));
    all.push_back(dynamics.back().get());
  }
  Ensemble ensemble(all, rk4(), FixedSteps(duration, 1e-3, every), widest);
  ensemble.run(threads);
  std::vector<VectorXd> out;
  for (const Ensemble::Member& member : ensemble.take()) {
    CHECK(member.reason == "");
    const std::vector<double>& q = member.frames.q;
    out.emplace_back(Eigen::Map<const VectorXd>(q.data() + q.size() / 6 * 5, q.size() / 6));
  }
  return out;
}

/// Beside a joint and between bodies that have none.
Model with_inerters(Model model, Random& random) {
  for (const auto& [i, j] : {std::pair{ground, 0}, {0, 1}, {ground, 2}})
    model.add_force("rotational_inerter", "rotor " + std::to_string(j), i, j, random_attachment(random), {{0.3, -1}});
  return model;
}

/// Of every kind, with functions of time, to the ground and between bodies.
Model with_forces(Model model, Random& random) {
  for (const ForceKind& kind : force_kinds())
    for (const auto& [i, j] : {std::pair{ground, 2}, {1, 4}})
      model.add_force(kind.info.name, kind.info.name + " " + std::to_string(j), i, j, random_attachment(random),
                      force_parameters(model, random, kind.info));
  return model;
}

std::vector<Model> trees_and_loops() {
  Random random(3);
  std::vector<Model> models;
  for (int k = 0; k < 5; ++k) models.push_back(random_tree(random, 6));
  for (int k = 0; k < 11; ++k) models.push_back(four_bar());
  for (int k = 0; k < 3; ++k) models.push_back(with_inerters(models[3 * k], random));
  return models;
}

/// Of one structure: hinges between bodies with and without branches, on the ground and beside other joints.
std::vector<Model> trees_of_hinges() {
  std::vector<Model> models;
  Random random(6);
  for (int k = 0; k < 9; ++k) {
    Model model(random.vec3(9.81));
    const int parents[] = {ground, 0, 1, 1, 0, ground, 5, 5, ground};
    for (int body = 0; body < 9; ++body) {
      model.add_body("body" + std::to_string(body), random_body(random));
      const char* kind = body == 2 || body == 6 ? "spherical" : body == 4 ? "fixed" : "revolute";
      add_joint(model, random, kind, "joint" + std::to_string(body), parents[body], body);
    }
    models.push_back(model);
  }
  return models;
}

std::vector<Model> trees_with_forces() {
  Random random(4);
  std::vector<Model> models;
  for (int k = 0; k < 9; ++k) {
    Random same(5);  // of one structure
    models.push_back(with_forces(random_tree(same, 6), random));
  }
  return models;
}

}  // namespace

TEST_CASE("lanes have the same bits at every width of registers, and those of the run by itself") {
  std::vector<Model> models = trees_and_loops();
  for (Model& it : trees_with_forces()) models.push_back(std::move(it));
  for (Model& it : trees_of_hinges()) models.push_back(std::move(it));
  for (const char* stabilization : {"sampled_baumgarte", "projection", "velocity_projection"}) {
    CAPTURE(stabilization);
    std::vector<VectorXd> single;
    for (const Model& model : models) {
      Dynamics dynamics(model, deterministic(stabilization));
      Simulation simulation(dynamics, make_runge_kutta(rk4()), {duration, 1e-3, every});
      const Frames frames = simulation.advance(1000, INFINITY);
      single.emplace_back(last(frames.q, static_cast<int>(frames.q.size() / 6)));
    }
    for (int level = 0; level < instruction_set_count(); ++level)
      for (const int threads : {1, 3}) {
        CAPTURE(level);
        const auto q = last_states(models, deterministic(stabilization), instruction_set(level), threads);
        for (std::size_t k = 0; k < models.size(); ++k) CHECK(q[k] == single[k]);
      }
  }
}

TEST_CASE("a hinge whose axes are turned away from each other leaves its lane, and no other one") {
  Random random(7);
  std::vector<std::unique_ptr<Dynamics>> dynamics;
  std::vector<Dynamics*> all;
  constexpr int violated = 1;
  for (int k = 0; k < 3; ++k) {
    Model model;
    model.add_body("rod", random_body(random));
    const Mat3<double> A = rotation_matrix<double>(model.bodies()[0].orientation).transpose();
    const Mat3<double> turn = rotation_matrix<double>(exponential(1.52 * Vec3<double>::UnitX()));
    Attachment<double> at = place(model, ground, 0, random.vec3(), Vec3<double>::Zero(), Mat3<double>::Identity(), A);
    at.s_i = model.bodies()[0].position + A.transpose() * at.s_j;
    at.C_j = k == violated ? Mat3<double>(A * turn) : A;
    model.add_joint("revolute", "pin", ground, 0, at);
    dynamics.push_back(std::make_unique<Dynamics>(model, deterministic()));
    all.push_back(dynamics.back().get());
  }
  for (int level = 0; level < instruction_set_count(); ++level) {
    Ensemble ensemble(all, rk4(), FixedSteps(0.01, 1e-3, 1), instruction_set(level));
    ensemble.run(1);
    const auto members = ensemble.take();
    for (int k = 0; k < 3; ++k) CHECK(members[k].reason == (k == violated ? "the equations are singular" : ""));
  }
}

TEST_CASE("runs that follow tolerances side by side are those by themselves, at every width, in every order") {
  const std::vector<Model> models = trees_and_loops();
  const AdaptiveSchedule schedule{.t_end = sanitized ? 0.04 : 0.2, .tolerances = {1e-5, 1e-8}, .record_every = 1};
  std::vector<Frames> single;
  for (const Model& model : models) {
    Dynamics dynamics(model, deterministic());
    AdaptiveSimulation run(dynamics, bs32(), schedule);
    single.push_back(run.advance(100000, INFINITY));
  }
  for (int level = 0; level < instruction_set_count(); ++level)
    for (const int threads : {1, 3}) {
      CAPTURE(level);
      std::vector<std::unique_ptr<Dynamics>> dynamics;
      std::vector<std::unique_ptr<AdaptiveSimulation>> owned;
      std::vector<AdaptiveSimulation*> runs;
      for (std::size_t k = models.size(); k-- > 0;) {
        dynamics.push_back(std::make_unique<Dynamics>(models[k], deterministic()));
        owned.push_back(std::make_unique<AdaptiveSimulation>(*dynamics.back(), bs32(), schedule));
        runs.push_back(owned.back().get());
      }
      for (const std::string& reason : run_trials(runs, instruction_set(level), threads)) CHECK(reason == "");
      for (std::size_t k = 0; k < models.size(); ++k) {
        const Frames frames = runs[models.size() - 1 - k]->take_frames(true);
        CHECK(frames.t == single[k].t);
        CHECK(frames.q == single[k].q);
        CHECK(frames.lambda == single[k].lambda);
      }
    }
}

TEST_CASE("steps are counted as in a run by itself") {
  CHECK(FixedSteps(0.3, 0.1, 1).count() == 3);
  const FixedSteps shortened(1.05, 0.1, 4);
  CHECK(shortened.count() == 11);
  CHECK(shortened.time(10) == 10 * 0.1);
  CHECK(shortened.time(11) == 1.05);
  CHECK(shortened.records(8));
  CHECK(!shortened.records(9));
  CHECK(shortened.records(11));
  CHECK_THROWS_AS(FixedSteps(1.0, 0.0, 1), OptionError);
  CHECK_THROWS_AS(FixedSteps(-1.0, 0.1, 1), OptionError);
  CHECK_THROWS_AS(FixedSteps(1.0, 0.1, 0), OptionError);
}

TEST_CASE("what lanes cannot hold says why") {
  Options other = deterministic();
  other.formulation = "augmented_lagrangian";
  Dynamics dynamics(four_bar(), other);
  Ensemble ensemble({&dynamics}, rk4(), FixedSteps(0.1, 0.01, 1), best_instruction_set());
  ensemble.run(1);
  const auto members = ensemble.take();
  CHECK(members.front().reason.find("standard") != std::string::npos);
  CHECK(members.front().frames.t.empty());
}

namespace {

/// Of three bodies, the second of which is in no loop; without what they spin about their axes.
void check_speeds(const LaneLayout& layout, int l, const AlignedDoubles& speeds, const VectorXd& v,
                  const Eigen::Matrix3Xd& axes) {
  const auto velocity = [&](int body, int half) {
    const Vec3<double> a = v.segment<3>(6 * body + 3 * half), axis = axes.col(body);
    return half == 0 ? a : Vec3<double>(a - axis * axis.dot(a));
  };
  const auto square = [&](int body, int half) { return velocity(body, half).squaredNorm(); };
  for (int half = 0; half < 2; ++half) {
    const auto largest = [&](int body) { return velocity(body, half).cwiseAbs().maxCoeff(); };
    CHECK(speeds[layout.index(half, l)] == std::max(largest(0), largest(2)));
    CHECK(speeds[layout.index(2 + half, l)] == square(1, half));
    CHECK(speeds[layout.index(4 + half, l)] == std::max(square(0, half), square(2, half)));
  }
}

}  // namespace

TEST_CASE("speeds and energies of lanes have the bits of a mechanism by itself, at every width") {
  const System system(four_bar());
  const OnePath path;
  const int n = system.body_count();
  const std::vector<double> in_loops = {1.0, 0.0, 1.0};
  Eigen::Matrix3Xd axes = Eigen::Matrix3Xd::Zero(3, n);
  axes.col(1) = Vec3<double>(0.6, 0.0, 0.8);
  for (int level = 0; level < instruction_set_count(); ++level) {
    CAPTURE(level);
    Random random(7);
    const LaneLayout layout{instruction_set(level).width};
    AlignedDoubles y, mass, loops, rotors, speeds, kinetic;
    layout.size(y, 13 * n + 1);
    layout.size(mass, 10 * n);
    layout.size(loops, n);
    layout.size(rotors, 3 * n);
    layout.size(speeds, 6);
    layout.size(kinetic, 1);
    std::vector<VectorXd> v;
    for (int l = 0; l < layout.width; ++l) {
      v.push_back(random.vector(6 * n, 3.0));
      layout.give(v[l].data(), 6 * n, l, y, 7 * n);
      layout.give(&system.mass_blocks()[0].m, 10 * n, l, mass, 0);
      layout.give(in_loops.data(), n, l, loops, 0);
      layout.give(axes.data(), 3 * n, l, rotors, 0);
    }
    lane_speeds(instruction_set(level)).speeds(n, loops.data(), rotors.data(), y.data(), speeds.data());
    lane_speeds(instruction_set(level)).kinetic_energy(n, mass.data(), y.data(), kinetic.data());
    const Evaluation at = system.make_evaluation();
    for (int l = 0; l < layout.width; ++l) {
      check_speeds(layout, l, speeds, v[l], axes);
      CHECK(kinetic[l] == system.kinetic_energy(at, v[l]));
    }
  }
}
