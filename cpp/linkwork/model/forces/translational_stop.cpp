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
            .bounds = {positive("stiffness"), not_negative("damping")},
            .ordered = {{"lower", "upper"}},
            .defaults = {no_default, no_default, no_default, 0.0},
            .documentation =
                "End stops along a joint axis: where the shift of b against a [m] is beyond `lower` or "
                "`upper` by d, the force k |d| + c |d| x_dot [N] acts against it, never back; k [N/m], c [N "
                "s/m^2]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    stop<Displacement>(at, parameters, i, j, memory, out);
  }
};

LINKWORK_DEFINE_FORCE(translational_stop, TranslationalStop)

}  // namespace linkwork
