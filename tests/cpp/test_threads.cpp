#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

/// Rods that hang one from the other, with hinges about y.
Model chain(int bodies) {
  Model model;
  Attachment<double> at;
  at.C_i = at.C_j = (Mat3<double>() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  at.s_j = {-0.5, 0.0, 0.0};
  for (int k = 0; k < bodies; ++k) {
    Body rod;
    rod.mass = 1.0;
    rod.inertia = Vec3<double>(0.01, 0.1, 0.1).asDiagonal();
    rod.position = {k + 0.5, 0.0, 0.0};
    const std::string number = std::to_string(k);
    model.add_body("rod " + number, rod);
    at.s_i = {k == 0 ? 0.0 : 0.5, 0.0, 0.0};
    model.add_joint("revolute", "hinge " + number, k == 0 ? ground : k - 1, k, at);
  }
  return model;
}

struct Found {
  VectorXd v_dot, lambda;
  bool operator==(const Found& other) const { return v_dot == other.v_dot && lambda == other.lambda; }
};

Found accelerations(Dynamics& dynamics, const VectorXd& y) {
  Found out{VectorXd(dynamics.system().v_size()), VectorXd(dynamics.system().row_count())};
  dynamics.evaluate(0.0, y);
  dynamics.accelerations(out.v_dot, out.lambda);
  return out;
}

Options with(const std::string& solver) {
  Options options;
  options.linear_solver = solver;
  if (solver != "block") options.matrix_form = "schur";
  return options;
}

template <class Work>
void in_threads(int count, Work work) {
  std::vector<std::thread> threads;
  for (int k = 0; k < count; ++k) threads.emplace_back(work, k);
  for (std::thread& thread : threads) thread.join();
}

constexpr int threads = 4, repeats = 30;

}  // namespace

TEST_CASE("dynamics that threads share work for one of them at a time, and tell the others at once") {
  const Model model = chain(40);
  for (const LinearSolverInfo& solver : linear_solvers()) {
    if (!solver.available()) continue;
    CAPTURE(solver.name);
    Dynamics dynamics(model, with(solver.name));
    const VectorXd y = dynamics.initial_y();
    const Found alone = accelerations(dynamics, y);
    std::atomic<int> right = 0, refused = 0;
    in_threads(threads, [&](int) {
      for (int k = 0; k < repeats; ++k) try {
          const Busy busy(dynamics);
          if (accelerations(dynamics, y) == alone) ++right;
        } catch (const BusyError&) {
          ++refused;
        }
    });
    CHECK(right > 0);
    CHECK(right + refused == threads * repeats);
    CHECK(accelerations(dynamics, y) == alone);
  }
}

TEST_CASE("dynamics of one model are free of each other in threads") {
  const Model model = chain(40);
  for (const LinearSolverInfo& solver : linear_solvers()) {
    if (!solver.available()) continue;
    CAPTURE(solver.name);
    Dynamics one(model, with(solver.name));
    const Found alone = accelerations(one, one.initial_y());
    std::atomic<int> right = 0;
    in_threads(threads, [&](int) {
      Dynamics mine(model, with(solver.name));
      for (int k = 0; k < repeats; ++k) right += accelerations(mine, mine.initial_y()) == alone ? 1 : 0;
    });
    CHECK(right == threads * repeats);
  }
}

TEST_CASE("dynamics are busy from when they are entered until they are left") {
  const Model model = chain(1);
  Dynamics dynamics(model, Options()), other(model, Options());
  {
    const Busy busy(dynamics);
    CHECK_THROWS_AS(Busy{dynamics}, BusyError);
    CHECK_THROWS_AS(Busy{dynamics}, BusyError);
    CHECK_NOTHROW(Busy{other});
  }
  CHECK_NOTHROW(Busy{dynamics});
}
