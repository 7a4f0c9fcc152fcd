#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// End stops of a slider.
struct TranslationalStop {
  static constexpr int memory = Displacement::memory;

  static KindInfo info() {
    return {.name = "translational_stop",
            .placement = Displacement::placement,
            .parameters = {"lower", "upper", "stiffness", "damping"},
            .differentiated = {"lower", "upper", "stiffness"},
            .defaults = {no_default, no_default, no_default, 0.0},
            .documentation =
                "End stops along a joint axis: where the shift of b against a [m] is beyond `lower` or "
                "`upper` by d, the force k |d| + c |d| x_dot [N] acts against it, never back; k [N/m], c [N "
                "s/m^2]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    Equation<Real> along;
    const Real x = Displacement::evaluate(at, i, j, memory, along), rate = along.rate(i, j);
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

LINKWORK_DEFINE_FORCE(translational_stop, TranslationalStop)

}  // namespace linkwork
