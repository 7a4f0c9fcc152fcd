#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Friction of a slider.
struct TranslationalFriction : Friction<Displacement> {
  static KindInfo info() {
    return {.name = "translational_friction",
            .placement = Displacement::placement,
            .parameters = {{"coulomb",
                            "N",
                            "Coulomb friction",
                            Takes::function,
                            {.usual = 0.0, .example = 20.0, .bounds = not_negative}},
                           {"viscous",
                            "N s/m",
                            "viscous friction",
                            Takes::function,
                            {.usual = 0.0, .example = 10.0, .bounds = not_negative}},
                           {"transition",
                            "m/s",
                            "speed of regularization",
                            Takes::number,
                            {.usual = 1e-3, .example = 0.1, .bounds = positive}}},
            .documentation =
                "Friction along a joint axis: the force on b is -f_c tanh(v / v_t) - c v [N], v the relative "
                "speed [m/s]: Coulomb friction `coulomb` [N], regularized below the speed `transition` [m/s], "
                "and `viscous` friction [N s/m]."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(translational_friction, TranslationalFriction)

}  // namespace linkwork
