#include "linkwork/integration/recorder.hpp"

#include <chrono>
#include <thread>

#include "integrators.hpp"
#include "linkwork/math/interruption.hpp"

using namespace support;

TEST_CASE("a frame holds the state, its energies and how far it is off the constraints") {
  const Model model = displaced_slider();  // 1 kg, off the z axis by (1e-2, -2e-2) m, moving off it
  Dynamics dynamics(model, unstabilized());
  const VectorXd y = dynamics.initial_y();
  Recorder recorder(dynamics);
  dynamics.evaluate(0.0, y);
  recorder.record(0.5, y);
  CHECK(recorder.count() == 1);
  const Frames frames = recorder.take();
  CHECK(recorder.count() == 0);
  CHECK(frames.t == std::vector<double>{0.5});
  CHECK((last(frames.q, 7) - y.head<7>()).norm() == 0.0);
  CHECK((last(frames.v, 6) - y.segment<6>(7)).norm() == 0.0);
  CHECK(frames.kinetic[0] == doctest::Approx(0.5 * (0.25 + 0.04 + 1.0)).epsilon(1e-14));
  CHECK(frames.potential[0] == doctest::Approx(0.3 * 9.81).epsilon(1e-14));
  CHECK(frames.violation[0] == doctest::Approx(2e-2).epsilon(1e-14));
  CHECK(frames.violation[1] == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(frames.violation[2] < 1e-13);
  CHECK(frames.lambda.size() == 5);
}

TEST_CASE("accelerations that are not finite are an error, never a frame") {
  Dynamics dynamics(free_body(), {});
  Recorder recorder(dynamics);
  const VectorXd y = dynamics.initial_y(), v_dot = VectorXd::Constant(6, NAN);
  dynamics.evaluate(0.0, y);
  CHECK_THROWS_AS(recorder.record(0.0, y, v_dot, VectorXd(0)), NotFiniteError);
  CHECK(recorder.count() == 0);
}

TEST_CASE("recording in the course of a step changes no bit of it, and waits for its first solution") {
  Dynamics watched(spherical_pendulum(), {}), alone(spherical_pendulum(), {});
  const VectorXd y = watched.initial_y();
  VectorXd a(y.size()), b(y.size());
  Recorder recorder(watched);
  watched.evaluate(0.0, y);
  alone.evaluate(0.0, y);
  recorder.record_in_step(0.0, y);
  CHECK(recorder.count() == 0);
  watched.rates(a);
  alone.rates(b);
  CHECK(recorder.count() == 1);
  CHECK((a - b).norm() == 0.0);
}

TEST_CASE("a frame that waits for a step which does not come is recorded at the end") {
  Dynamics dynamics(spherical_pendulum(), {});
  Recorder recorder(dynamics);
  dynamics.evaluate(0.0, dynamics.initial_y());
  recorder.record_in_step(0.0, dynamics.initial_y());
  recorder.finish();
  CHECK(recorder.count() == 1);
}

namespace {

struct Reactions {
  Eigen::Matrix3Xd force, torque;

  static Reactions at(const System& system, double t, const VectorXd& y, const VectorXd& lambda) {
    Evaluation anew = system.make_evaluation();
    Reactions out{{3, system.joint_count()}, {3, system.joint_count()}};
    const auto q = y.head(system.q_size());
    system.evaluate_constraints(t, q, VectorXd::Zero(system.v_size()), system.initial_history(), anew);
    system.reactions(anew, q, lambda, out.force, out.torque);
    return out;
  }
  static Reactions of(const Frames& frames, std::size_t frame, Eigen::Index joints) {
    const auto columns = [&](const std::vector<double>& list) {
      return Eigen::Map<const Eigen::Matrix3Xd>(list.data() + 3 * joints * frame, 3, joints);
    };
    return {columns(frames.reaction_force), columns(frames.reaction_torque)};
  }
  bool operator==(const Reactions& other) const { return force == other.force && torque == other.torque; }
};

VectorXd lambda_of(const Frames& frames, std::size_t frame, const System& system) {
  return Eigen::Map<const VectorXd>(frames.lambda.data() + frame * static_cast<std::size_t>(system.row_count()),
                                    system.row_count());
}

}  // namespace

TEST_CASE("reactions come with frames where they are asked for, those of redundant joints, too") {
  Dynamics dynamics(four_bar(), unstabilized());
  const System& system = dynamics.system();
  const VectorXd y = dynamics.initial_y();
  REQUIRE(dynamics.dropped().count() == 3);
  Recorder recorder(dynamics);
  dynamics.evaluate(0.0, y);
  recorder.record(0.0, y);
  CHECK(recorder.take().reaction_force.empty());
  recorder.record_reactions();
  recorder.record(0.0, y);
  CHECK(dynamics.has_D_of(0.0, y.head(system.q_size())));
  const Frames frames = recorder.take();
  const Reactions found = Reactions::of(frames, 0, system.joint_count());
  CHECK(found == Reactions::at(system, 0.0, y, lambda_of(frames, 0, system)));
  CHECK(found.force.norm() > 1.0);
}

TEST_CASE("reactions are those of the frame, be the evaluation at hand of another pose") {
  Dynamics dynamics(four_bar(), unstabilized());
  const System& system = dynamics.system();
  const VectorXd y = dynamics.initial_y();
  VectorXd other = y;
  other.segment<4>(3) = Vec4<double>(std::cos(0.1), 0, 0, std::sin(0.1));
  Recorder recorder(dynamics);
  recorder.record_reactions();
  dynamics.evaluate(0.0, y);
  recorder.record(0.0, y);
  recorder.record(0.5, other);
  recorder.record(1.0, y);
  CHECK(!dynamics.has_D_of(0.5, other.head(system.q_size())));
  const Frames frames = recorder.take();
  REQUIRE(frames.reaction_force.size() == 3 * 3 * 4);
  for (const std::size_t k : {0, 1, 2})
    CHECK(Reactions::of(frames, k, 4) ==
          Reactions::at(system, frames.t[k], k == 1 ? other : y, lambda_of(frames, k, system)));
  CHECK(!(Reactions::of(frames, 0, 4) == Reactions::of(frames, 1, 4)));
}

TEST_CASE("a frame in which the run is interrupted is there as a whole or not at all") {
  struct Ended {};
  Dynamics dynamics(four_bar(), unstabilized());
  const VectorXd y = dynamics.initial_y();
  Recorder recorder(dynamics);
  recorder.record_reactions();
  dynamics.evaluate(0.0, y);
  set_interruption([] { throw Ended(); });
  for (int phase = 0; phase < 4; ++phase) {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    const auto for_ever = [&] {
      for (;;) recorder.record(0.0, y);
    };
    CHECK_THROWS_AS(for_ever(), Ended);
    recorder.record(0.0, y);
    const Frames frames = recorder.take();
    const std::size_t count = frames.t.size();
    CHECK(count > 100);
    CHECK(frames.q.size() == count * 21);
    CHECK(frames.history.size() == 0);
    CHECK(frames.violation.size() == 3 * count);
    CHECK(frames.reaction_force.size() == 12 * count);
    CHECK(frames.reaction_torque.size() == 12 * count);
  }
  set_interruption(nullptr);
}
