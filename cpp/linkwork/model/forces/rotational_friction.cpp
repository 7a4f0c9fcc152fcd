#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Friction of a hinge.
struct RotationalFriction : Friction<Angle> {
  static KindInfo info() {
    return {.name = "rotational_friction",
            .placement = Angle::placement,
            .parameters = {{"coulomb",
                            "N m",
                            "Coulomb friction",
                            Takes::function,
                            {.usual = 0.0, .example = 20.0, .bounds = not_negative}},
                           {"viscous",
                            "N m s/rad",
                            "viscous friction",
                            Takes::function,
                            {.usual = 0.0, .example = 10.0, .bounds = not_negative}},
                           {"transition",
                            "rad/s",
                            "speed of regularization",
                            Takes::number,
                            {.usual = 1e-2, .example = 0.1, .bounds = positive}}},
            .documentation =
                "Friction about a joint axis: the torque on b is -n_c tanh(w / w_t) - c w [N m], w the "
                "relative speed [rad/s]: Coulomb friction `coulomb` [N m], regularized below the speed "
                "`transition` [rad/s], and `viscous` friction [N m s/rad]."};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(rotational_friction, RotationalFriction)

}  // namespace linkwork
