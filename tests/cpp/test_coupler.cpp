#include "linkwork/model/special/coupler.hpp"

#include <numbers>

#include "mechanisms.hpp"

using namespace support;

namespace {

/// Two wheels on hinges about z, and a belt between them: 2 angle_a - 3 angle_b = 0.
Model belt() {
  Model model;
  model.add_body("a", body_at({0, 0, 0}));
  model.add_body("b", body_at({5, 0, 0}));
  join(model, "revolute", "A", ground, 0, {0, 0, 0});
  join(model, "revolute", "B", ground, 1, {5, 0, 0});
  const auto coupler =
      std::make_shared<Coupler>(model, std::vector<CoupledCoordinate>{{0, "angle", 2.0}, {1, "angle", -3.0}});
  const Element& first = model.joints()[0];
  model.add_special_joint("coupler", "belt", first.i, first.j, first.at, coupler, {{0.0, -1}});
  return model;
}

/// Phi and Phi_dot of the belt with the wheels turned about z.
struct Belt {
  System system{belt()};
  Evaluation at = system.make_evaluation();
  VectorXd history = system.initial_history();

  void turn(double a, double b, double omega_a = 0.0, double omega_b = 0.0) {
    VectorXd q = system.model().initial_q(), v = VectorXd::Zero(12);
    q.segment<4>(3) = exponential({0, 0, a});
    q.segment<4>(10) = exponential({0, 0, b});
    v[5] = omega_a;
    v[11] = omega_b;
    system.evaluate(0.0, q, v, history, at);
  }
  double Phi() const { return at.Phi[10]; }
};

}  // namespace

TEST_CASE("a coupler is the weighted sum of the angles, and its rate that of the speeds") {
  Belt it;
  it.turn(0.3, 0.2, 1.5, 0.4);
  CHECK(std::abs(it.Phi()) < 1e-14);
  CHECK(it.at.Phi_dot[10] == doctest::Approx(2.0 * 1.5 - 3.0 * 0.4).epsilon(1e-13));
  it.turn(0.5, 0.2);
  CHECK(it.Phi() == doctest::Approx(0.4).epsilon(1e-13));
}

TEST_CASE("angles go on over full turns along the motion") {
  Belt it;
  for (double a = 0.0; a < 20.0; a += 0.25) {
    it.turn(a, 2.0 / 3.0 * a);
    CHECK(std::abs(it.Phi()) < 1e-12);
    it.history = it.at.history;
  }
}

TEST_CASE("gamma is zero where both axes are fixed: constant speeds stay on the relation") {
  Belt it;
  it.turn(0.7, 0.1, 3.0, 2.0);
  CHECK(std::abs(it.at.gamma[10]) < 1e-13);
}

TEST_CASE("coordinates that do not exist and factors of nothing are refused") {
  Model model = four_bar();
  const auto made = [&](int joint, const char* name, double factor) {
    Coupler(model, std::vector<CoupledCoordinate>{{joint, name, factor}});
  };
  CHECK_NOTHROW(made(0, "angle", 1.0));
  CHECK_THROWS_AS(made(9, "angle", 1.0), ModelError);
  CHECK_THROWS_AS(made(0, "displacement", 1.0), ModelError);
  CHECK_THROWS_AS(made(0, "angle", 0.0), ModelError);
}

TEST_CASE("without what is driven the others are as they were, a coupler behind it, too") {
  const Model given = belt();
  Model model = given.without_forces();
  const Element& B = given.joints()[1];
  model.add_joint("distance", "rod", B.i, B.j, B.at, {{1.0, model.add_signal(harmonic(0.1, 1.0, 0.0, 1.0))}});
  const auto coupler =
      std::make_shared<Coupler>(model, std::vector<CoupledCoordinate>{{0, "angle", 1.0}, {1, "angle", 1.0}});
  model.add_special_joint("coupler", "gears", B.i, B.j, B.at, coupler, {{0.5, -1}});
  const System driven(model), free(model.without_drivers());
  CHECK(driven.row_count() == 13);
  CHECK(free.row_count() == 12);
  CHECK(!free.time_dependent_constraints());
  CHECK(free.model().joint_name(3) == "gears");
  Evaluation with = driven.make_evaluation(), without = free.make_evaluation();
  driven.evaluate(0.0, model.initial_q(), VectorXd::Ones(12), driven.initial_history(), with);
  free.evaluate(0.0, model.initial_q(), VectorXd::Ones(12), free.initial_history(), without);
  CHECK(without.Phi.head(11) == with.Phi.head(11));
  CHECK(without.Phi[11] == with.Phi[12]);
  CHECK(without.Phi_dot[11] == with.Phi_dot[12]);
}
