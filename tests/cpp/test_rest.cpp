#include "linkwork/integration/rest.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double length = 0.5;  // m

/// A body of 2 kg that nothing holds, and what a run made of it in one step of 0.1 s.
struct Free {
  Free(double gravity, double speed, double moved) : dynamics(model(gravity, speed), Options()) {
    step.h = 0.1;
    step.y = step.y_new = dynamics.initial_y();
    step.y_new[0] += speed * step.h + moved;
  }
  std::optional<Rest> found() {
    return find_rest(dynamics, {&step}, StepParts({}, golden_share), VectorXd::Constant(1, length))[0];
  }

  static Model model(double gravity, double speed) {
    Model out({0.0, 0.0, -gravity});
    Body body;
    body.mass = 2.0;
    body.velocity = {speed, 0.0, 0.0};
    out.add_body("free", body);
    return out;
  }

  Dynamics dynamics;
  KeptStep step;
};

}  // namespace

TEST_CASE("a body that no force moves rests in axes that fly along: what the run moved it is its error") {
  for (const double speed : {0.0, 7600.0}) {
    const std::optional<Rest> rest = Free(0.0, speed, 1e-7).found();
    REQUIRE(rest);
    REQUIRE(rest->moved.size() == 1);
    CHECK(rest->moved[0].position == doctest::Approx(1e-7).epsilon(1e-2));
    CHECK(rest->speed == doctest::Approx(length / 0.1));
    CHECK(rest->energy == doctest::Approx(0.5 * 2.0 * rest->speed * rest->speed));
  }
}

TEST_CASE("what falls, or has left its place, does not rest") {
  CHECK(!Free(9.81, 0.0, 0.0).found());
  CHECK(!Free(0.0, 0.0, 1e-5 * length).found());
}

TEST_CASE("one of two bodies that nothing connects rests beside the other, which a force moves") {
  Model model(Vec3<double>::Zero());
  Body body;
  body.mass = 2.0;
  model.add_body("still", body);
  model.add_body("pushed", body);
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j.setZero();
  at.C_i = at.C_j = Mat3<double>::Identity();
  model.add_force("applied", "push", ground, 1, at,
                  {{1e-3, -1}, {0.0, -1}, {0.0, -1}, {0.0, -1}, {0.0, -1}, {0.0, -1}});
  Dynamics dynamics(model, Options());
  KeptStep step;
  step.h = 0.1;
  step.y = step.y_new = dynamics.initial_y();
  const VectorXd lengths = VectorXd::Constant(2, length);
  const auto found = find_rest(dynamics, {&step}, StepParts({}, golden_share), lengths);
  CHECK(found[0]);
  CHECK(!found[1]);
  step.y_new[0] += 1e-5 * length;
  CHECK(!find_rest(dynamics, {&step}, StepParts({}, golden_share), lengths)[0]);
}
