#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Friction of a slider.
struct TranslationalFriction {
  static constexpr int memory = Displacement::memory;

  static KindInfo info() {
    return {.name = "translational_friction",
            .placement = Displacement::placement,
            .parameters = {"coulomb", "viscous", "transition"},
            .constants = {"transition"},
            .bounds = {not_negative("coulomb"), not_negative("viscous"), positive("transition")},
            .defaults = {0.0, 0.0, 1e-3},
            .documentation =
                "Friction along a joint axis: the force on b is -f_c tanh(v / v_t) - c v [N], v the relative "
                "speed [m/s]: Coulomb friction `coulomb` [N], regularized below the speed `transition` [m/s], "
                "and `viscous` friction [N s/m]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    friction<Displacement>(at, parameters, i, j, memory, out);
  }
};

LINKWORK_DEFINE_FORCE(translational_friction, TranslationalFriction)

}  // namespace linkwork
