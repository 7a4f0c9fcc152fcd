#include "linkwork/integration/stored_energy_jumps.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

constexpr double soft = 10.0, stiff = 50.0, free_length = 1.0, jump = 0.5;

/// A body that a spring along x holds, of another stiffness from 0.5 s on.
Model held() {
  Model model = free_body();
  const int stiffness = model.add_signal(piecewise_polynomial({0.0, jump, 2.0}, {soft, stiff}));
  const Vec3<double> o = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring", ground, 0, {o, o, I, I},
                  {{0.0, stiffness}, {0.0, -1}, {free_length, -1}, {0.0, -1}});
  return model;
}

VectorXd at(const System& system, double x, double speed) {
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1);
  y[0] = x;
  y[3] = 1.0;
  y[system.q_size()] = speed;
  return y;
}

double work_at(double x) { return 0.5 * (stiff - soft) * (x - free_length) * (x - free_length); }

}  // namespace

TEST_CASE("a stiffness that jumps does the work that the spring stores more, where the body is then") {
  const System system(held());
  const BreakPoints breaks(system.model(), {});
  const StoredEnergyJumps jumps(system);
  const VectorXd none;
  CHECK(jumps.any());
  CHECK(jumps.work(breaks.before(jump), breaks.after(jump), at(system, 1.4, 0.0), none) ==
        doctest::Approx(work_at(1.4)).epsilon(1e-12));
  CHECK(jumps.work(0.2, 0.3, at(system, 1.4, 0.0), none) == 0.0);
  constexpr double h = 0.1, speed = 2.0;
  const VectorXd y = at(system, 1.4, speed), y_new = at(system, 1.4 + h * speed, speed);
  CHECK(jumps.work_in_step(breaks, 0.47, 0.57, y, y_new, none) ==
        doctest::Approx(work_at(1.4 + 0.03 * speed)).epsilon(1e-12));
}

TEST_CASE("a break between two steps counts once, whichever of them sees it") {
  const System system(held());
  const BreakPoints breaks(system.model(), {});
  const StoredEnergyJumps jumps(system);
  const VectorXd none, y = at(system, 1.4, 0.0);
  for (const double between : {breaks.before(jump), jump, breaks.after(jump)}) {
    const double both =
        jumps.work_in_step(breaks, 0.4, between, y, y, none) + jumps.work_in_step(breaks, between, 0.6, y, y, none);
    CHECK(both == doctest::Approx(work_at(1.4)).epsilon(1e-12));
  }
}

TEST_CASE("a spring that is the same at all times stores no more at breaks of others") {
  const System system(free_body());
  CHECK(!StoredEnergyJumps(system).any());
}

TEST_CASE("a free length that jumps does the work of a spring by its characteristic, too") {
  Model model = free_body();
  const int free = model.add_signal(piecewise_polynomial({0.0, jump, 2.0}, {free_length, 0.7}));
  const int spring = model.add_signal(characteristic(polynomial({0.0, soft, 0.0, stiff}), "spring"));
  const Vec3<double> o = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("nonlinear_spring_damper", "spring", ground, 0, {o, o, I, I},
                  {{0.0, spring}, {2.0, -1}, {0.0, free}});
  const System system(model);
  const BreakPoints breaks(system.model(), {});
  const auto stored = [](double x) { return soft / 2 * x * x + stiff / 4 * x * x * x * x; };
  const StoredEnergyJumps jumps(system);
  CHECK(jumps.work(breaks.before(jump), breaks.after(jump), at(system, 1.4, 0.0), VectorXd()) ==
        doctest::Approx(stored(0.7) - stored(0.4)).epsilon(1e-12));
}
