#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Spring, damper and actuator along the z axis of a joint frame.
struct TranslationalSpringDamper : LinearSpring<Displacement> {
  static KindInfo info() {
    return {
        .name = "translational_spring_damper",
        .placement = Displacement::placement,
        .parameters = {{"stiffness", "N/m", "of the spring", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
                       {"damping", "N s/m", "of the damper", Takes::function, {.usual = 0.0, .example = 10.0}},
                       {"free_displacement",
                        "m",
                        "where the spring is free",
                        Takes::differentiable,
                        {.usual = 0.0, .example = 0.1}},
                       {"force", "N", "of the actuator", Takes::function, {.usual = 0.0, .example = 20.0}}},
        .documentation =
            "Spring [N/m], damper [N s/m] and actuator [N] along a joint axis: the force on b along the axis "
            "is -k (x - x_0) - c x_dot + f, x the shift of the point of b against that of a along the "
            "axis of a [m], which may have either sign."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(translational_spring_damper, TranslationalSpringDamper)

}  // namespace linkwork
