#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Inertia of a relative displacement.
struct TranslationalInerter : InertiaOf<Displacement> {
  static KindInfo info() {
    return {.name = "translational_inerter",
            .placement = Displacement::placement,
            .parameters = {{"inertance", "kg", "along the axis", Takes::number, {.example = 0.5, .bounds = positive}}},
            .documentation =
                "Inerter along a joint axis, such as the rotor of a linear drive: the force on b is -b s_ddot "
                "[N], s its displacement along the axis of a and b the inertance [kg]. Its kinetic energy is b "
                "s_dot^2 / 2; it weighs nothing."};
  }
};

LINKWORK_DEFINE_FORCE(translational_inerter, TranslationalInerter)

}  // namespace linkwork
