#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// End stops of a hinge.
struct RotationalStop {
  static constexpr int memory = Angle::memory;

  static KindInfo info() {
    return {.name = "rotational_stop",
            .placement = Angle::placement,
            .parameters = {"lower", "upper", "stiffness", "damping"},
            .differentiated = {"lower", "upper", "stiffness"},
            .defaults = {no_default, no_default, no_default, 0.0},
            .documentation =
                "End stops about a joint axis: where the angle of b against a [rad] is beyond `lower` or "
                "`upper` by d, the torque k |d| + c |d| theta_dot [N m] acts against it, never back; k [N "
                "m/rad], c [N m s/rad^2]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    Equation<Real> along;
    const Real x = Angle::evaluate(at, i, j, memory, along), rate = along.rate(i, j);
    const bool above = x > parameters[1].value, below = x < parameters[0].value;
    if (!above && !below) return;
    const Signal<Real> limit = parameters[above ? 1 : 0];
    const Real depth = x - limit.value;  // negative below
    const Real spring = parameters[2].value * depth, damper = parameters[3].value * std::abs(depth) * rate;
    const Real force = (spring + damper) * depth > Real(0) ? -(spring + damper) : Real(0);  // never pulls back
    act(along, force, out);
    out.potential = Real(0.5) * spring * depth;
    out.power = (force + spring) * rate - spring * limit.rate + Real(0.5) * parameters[2].rate * depth * depth;
  }
};

LINKWORK_DEFINE_FORCE(rotational_stop, RotationalStop)

}  // namespace linkwork
