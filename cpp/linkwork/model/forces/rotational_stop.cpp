#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// End stops of a hinge.
struct RotationalStop : Stop<Angle> {
  static KindInfo info() {
    return {
        .name = "rotational_stop",
        .placement = Angle::placement,
        .parameters =
            {{"lower", "rad", "end of the free range", Takes::differentiable, {.example = -0.1, .not_above = "upper"}},
             {"upper", "rad", "end of the free range", Takes::differentiable, {.example = 0.1}},
             {"stiffness", "N m/rad", "beyond the ends", Takes::differentiable, {.example = 100.0, .bounds = positive}},
             {"damping",
              "N m s/rad^2",
              "beyond the ends, by depth",
              Takes::function,
              {.usual = 0.0, .example = 10.0, .bounds = not_negative}}},
        .documentation =
            "End stops about a joint axis: where the angle of b against a [rad] is beyond `lower` or "
            "`upper` by d, the torque k |d| + c |d| theta_dot [N m] acts against it, never back; k [N "
            "m/rad], c [N m s/rad^2]."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(rotational_stop, RotationalStop)

}  // namespace linkwork
