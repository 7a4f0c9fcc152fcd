#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Friction of a hinge.
struct RotationalFriction {
  static constexpr int memory = Angle::memory;

  static KindInfo info() {
    return {.name = "rotational_friction",
            .placement = Angle::placement,
            .parameters = {"coulomb", "viscous", "transition"},
            .constants = {"transition"},
            .bounds = {not_negative("coulomb"), not_negative("viscous"), positive("transition")},
            .defaults = {0.0, 0.0, 1e-2},
            .documentation =
                "Friction about a joint axis: the torque on b is -n_c tanh(w / w_t) - c w [N m], w the "
                "relative speed [rad/s]: Coulomb friction `coulomb` [N m], regularized below the speed "
                "`transition` [rad/s], and `viscous` friction [N m s/rad]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    friction<Angle>(at, parameters, i, j, memory, out);
  }
};

LINKWORK_DEFINE_FORCE(rotational_friction, RotationalFriction)

}  // namespace linkwork
