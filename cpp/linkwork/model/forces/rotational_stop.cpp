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
            .bounds = {positive("stiffness"), not_negative("damping")},
            .ordered = {{"lower", "upper"}},
            .defaults = {no_default, no_default, no_default, 0.0},
            .documentation =
                "End stops about a joint axis: where the angle of b against a [rad] is beyond `lower` or "
                "`upper` by d, the torque k |d| + c |d| theta_dot [N m] acts against it, never back; k [N "
                "m/rad], c [N m s/rad^2]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    stop<Angle>(at, parameters, i, j, memory, out);
  }
};

LINKWORK_DEFINE_FORCE(rotational_stop, RotationalStop)

}  // namespace linkwork
