#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Inertia of a relative rotation: armature, or reflected rotor inertia.
struct RotationalInerter : InertiaOf<Angle> {
  static KindInfo info() {
    return {
        .name = "rotational_inerter",
        .placement = Angle::placement,
        .parameters = {{"inertance", "kg m^2", "about the axis", Takes::number, {.example = 0.5, .bounds = positive}}},
        .documentation =
            "Rotational inerter about a joint axis, such as the rotor of a motor, its inertia times the "
            "square of the gear ratio: the torque on b about the axis is -b theta_ddot [N m], theta the "
            "angle of b against a and b the inertance [kg m2], also called armature. Its kinetic energy is b "
            "theta_dot^2 / 2; it weighs nothing."};
  }
};

LINKWORK_DEFINE_FORCE(rotational_inerter, RotationalInerter)

}  // namespace linkwork
