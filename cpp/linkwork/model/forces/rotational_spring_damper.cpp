#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Rotational spring, damper and actuator about the z axis of a joint frame.
struct RotationalSpringDamper : LawAlong<RotationalSpringDamper, Angle> {
  static constexpr HistoryKind history = Angle::history;
  static constexpr bool valued = true;

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

  template <class Real>
  LINKWORK_PRIMITIVE static Along<Real> law(const ForceParameters<Real>& parameters, const Real& theta,
                                            const Real& rate, HistoryVariable<Real>& history) {
    const Real stiffness = parameters[0].value, damping = parameters[1].value;
    history.rate = select(stiffness == Real(0), Real(0), history.rate);
    const Real deflection = theta - parameters[2].value;
    const Real dissipative = parameters[3].value - damping * rate;
    return {.force = dissipative - stiffness * deflection,
            .potential = Real(0.5) * stiffness * deflection * deflection,
            .power = dissipative * rate + Real(0.5) * parameters[0].rate * deflection * deflection -
                     stiffness * deflection * parameters[2].rate};
  }
};

LINKWORK_DEFINE_FORCE_PACKS(rotational_spring_damper, RotationalSpringDamper)

}  // namespace linkwork
