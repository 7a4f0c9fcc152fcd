#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Rotational spring, damper and actuator about the z axis of a joint frame.
struct RotationalSpringDamper : LinearSpring<Angle> {
  static KindInfo info() {
    return {.name = "rotational_spring_damper",
            .placement = Angle::placement,
            .parameters = {{"stiffness", "N m/rad", "of the spring", Takes::differentiable, {.example = 100.0}},
                           {"damping", "N m s/rad", "of the damper", Takes::function, {.example = 10.0}},
                           {"free_angle", "rad", "where the spring is free", Takes::differentiable, {.example = 1.0}},
                           {"torque", "N m", "of the actuator", Takes::function, {.example = 20.0}}},
            .documentation =
                "Spring [N m/rad], damper [N m s/rad] and actuator [N m] about a joint axis: the torque on b "
                "about the axis is -k (theta - theta_0) - c theta_dot + n, theta the angle of b against a "
                "[rad], zero where the joint frames agree and continued over full turns."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(rotational_spring_damper, RotationalSpringDamper)

}  // namespace linkwork
