#include "linkwork/formulation/not_finite.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

struct Blame {
  std::vector<std::string> bodies, joints, forces;
  bool operator==(const Blame&) const = default;
};

/// What the error at t = 2 names; `alter` spoils the state.
template <class Alter>
Blame blamed(const Model& model, Alter alter) {
  const System system(model);
  VectorXd y(system.q_size() + system.v_size() + 1);
  y << model.initial_q(), model.initial_v(), 0.0;
  alter(y);
  try {
    throw_not_finite(system, y, 2.0);
  } catch (const NotFiniteError& error) {
    CHECK(error.details.time == 2.0);
    return {error.details.bodies, error.details.joints, error.details.forces};
  }
}

/// Two free bodies with a spring whose stiffness is a function of time.
Model two_bodies(const TimeFunctionPtr& force) {
  Model model = free_body();
  Body second = model.bodies()[0];
  second.position = {1, 0, 0};
  model.add_body("second", second);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  model.add_force("spring_damper", "good", ground, 1, {O, O, I, I}, {{1, -1}, {0, -1}, {0.1, -1}, {0, -1}});
  model.add_force("spring_damper", "bad", 0, 1, {O, O, I, I},
                  {{1, -1}, {0, -1}, {0.1, -1}, {0, model.add_signal(force)}});
  return model;
}

const auto as_it_is = [](VectorXd&) {};

}  // namespace

TEST_CASE("the body whose state is not finite is named before all else") {
  const Model model = two_bodies(callback([](double) { return NAN; }));
  CHECK(blamed(model, [](VectorXd& y) { y[7] = NAN; }) == Blame{{"second"}, {}, {}});
  CHECK(blamed(model, [](VectorXd& y) { y[14 + 3] = INFINITY; }) == Blame{{"brick"}, {}, {}});
}

TEST_CASE("a force that is not a number is named, others are not") {
  const auto breaks_down = [](double t) { return t > 1.0 ? NAN : 0.0; };
  CHECK(blamed(two_bodies(callback(breaks_down)), as_it_is) == Blame{{}, {}, {"bad"}});
}

TEST_CASE("a joint whose equations are not numbers is named, before forces") {
  Model model = two_bodies(callback([](double) { return NAN; }));
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> O = Vec3<double>::Zero();
  const auto undefined = [](double) { return NAN; };
  model.add_joint("distance", "rod", 0, 1, {O, O, I, I},
                  {{0.0, model.add_signal(callback(undefined, undefined, undefined))}});
  CHECK(blamed(model, as_it_is) == Blame{{}, {"rod"}, {}});
}

TEST_CASE("where all that acts is finite, the fastest body is named") {
  const Model model = two_bodies(polynomial({0.0}));
  CHECK(blamed(model, [](VectorXd& y) { y[14 + 6] = 1e60; }) == Blame{{"second"}, {}, {}});
}
