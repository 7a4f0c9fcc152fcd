#include "linkwork/constraints/least_constrained_motion.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// A body without mass and inertia at the origin, held by a joint with axes along those of space.
std::string motion_of_massless(const std::string& kind) {
  Model model;
  Body body = body_at({0, 0, 0});
  body.mass = 0.0;
  body.inertia.setZero();
  model.add_body("ghost", body);
  join(model, kind, "joint", ground, 0, {0, 0, 0});
  const System system(model);
  return describe_least_constrained_motion(system, evaluate_initially(system), 0);
}

}  // namespace

TEST_CASE("the motion of a massless body that its joint leaves free is named") {
  CHECK(motion_of_massless("revolute") == "its rotation about (0, 0, 1) in body axes");
  CHECK(motion_of_massless("translational") == "its translation along (0, 0, 1)");
}

TEST_CASE("a body without inertia about one axis is free about that one, whatever else its joint leaves free") {
  Model model;
  Body body = body_at({0, 0, 0});
  body.inertia = Vec3<double>(1, 0, 1).asDiagonal();  // without inertia about y alone
  model.add_body("needle", body);
  join(model, "spherical", "joint", ground, 0, {0, 0, 0});
  const System system(model);
  CHECK(describe_least_constrained_motion(system, evaluate_initially(system), 0) ==
        "its rotation about (0, 1, 0) in body axes");
}
