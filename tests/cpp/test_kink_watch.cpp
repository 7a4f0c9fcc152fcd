#include "linkwork/integration/kink_watch.hpp"

#include "support.hpp"

using namespace support;

namespace {

const Vec3<double> O = Vec3<double>::Zero();
const Mat3<double> I = Mat3<double>::Identity();

/// A wheel and a ball, each with a spring whose slope jumps at 0.5 (and whose curvature at -1); its rate is linear.
Model sprung() {
  Model model(O);
  model.add_body("wheel", {});
  model.add_body("ball", {});
  const int table = model.add_signal(
      characteristic(piecewise_polynomial({-100.0, -1.0, 0.5, 100.0},
                                          {-98.5, 1.0, 0.0, 0.0, 0.5, 1.0, 0.3, -0.3 / 4.5, 2.0, 3.0, 0.0, 0.0}),
                     "spring"));
  model.add_force("rotational_spring_damper", "linear", ground, 0, {O, O, I, I},
                  {{1.0, -1}, {0.0, -1}, {0.0, -1}, {0.0, -1}});
  model.add_force("nonlinear_rotational_spring_damper", "turned", ground, 0, {O, O, I, I},
                  {{0.0, table}, {2.0, -1}, {0.0, -1}});
  const int free_length = model.add_signal(polynomial({1.0, 0.25}));
  model.add_force("nonlinear_spring_damper", "pulled", ground, 1, {O, O, I, I},
                  {{0.0, table}, {2.0, -1}, {0.0, free_length}});
  return model;
}

}  // namespace

TEST_CASE("pieces are told by extensions, over full turns, and where a spring is free may be a function of time") {
  const System system(sprung());
  KinkWatch watch(system);
  REQUIRE(watch.elements() == std::vector<int>{1, 2});
  VectorXd q = VectorXd::Zero(system.q_size()), v = VectorXd::Zero(system.v_size());
  VectorXd history = system.initial_history();
  const auto pieces = [&](double t, double angle, double way) {
    q.segment<4>(3) << std::cos(angle / 2), 0, 0, std::sin(angle / 2);
    q.segment<4>(10) << 1, 0, 0, 0;
    q[7] = way;
    return watch.pieces(t, q, v, history);
  };
  const std::vector<int> first = pieces(0.0, 0.4, 1.2);
  CHECK(pieces(0.0, 0.49, 1.49) == first);
  CHECK(pieces(0.0, 0.51, 1.49) == std::vector{first[0] + 1, first[1]});
  CHECK(pieces(0.0, 0.4, 1.51) == std::vector{first[0], first[1] + 1});
  CHECK(pieces(1.0, 0.4, 1.51) == first);                            // free at 1.25 m
  for (int k = 0; k < system.history_size(); ++k) history[k] = 6.0;  // rad, so that 0.4 rad is a turn more
  CHECK(pieces(0.0, 0.4, 1.2) == std::vector{first[0] + 1, first[1]});
}

TEST_CASE("linear springs have no kinks, nor has a function that nobody knows") {
  Model model(O);
  model.add_body("ball", {});
  const int law = model.add_signal(characteristic(callback([](double x) { return x; }), "spring"));
  model.add_force("spring_damper", "linear", ground, 0, {O, O, I, I}, {{1.0, -1}, {0.0, -1}, {0.5, -1}, {0.0, -1}});
  model.add_force("nonlinear_spring_damper", "of Python", ground, 0, {O, O, I, I}, {{0.0, law}, {2.0, -1}, {0.0, -1}});
  CHECK(KinkWatch(System(model)).empty());
}
