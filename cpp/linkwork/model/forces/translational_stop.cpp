#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// End stops of a slider.
struct TranslationalStop : Stop<Displacement> {
  static KindInfo info() {
    return {
        .name = "translational_stop",
        .placement = Displacement::placement,
        .parameters =
            {{"lower", "m", "end of the free range", Takes::differentiable, {.example = -0.1, .not_above = "upper"}},
             {"upper", "m", "end of the free range", Takes::differentiable, {.example = 0.1}},
             {"stiffness", "N/m", "beyond the ends", Takes::differentiable, {.example = 100.0, .bounds = positive}},
             {"damping",
              "N s/m^2",
              "beyond the ends, by depth",
              Takes::function,
              {.usual = 0.0, .example = 10.0, .bounds = not_negative}}},
        .documentation =
            "End stops along a joint axis: where the shift of b against a [m] is beyond `lower` or "
            "`upper` by d, the force k |d| + c |d| x_dot [N] acts against it, never back; k [N/m], c [N "
            "s/m^2]."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(translational_stop, TranslationalStop)

}  // namespace linkwork
