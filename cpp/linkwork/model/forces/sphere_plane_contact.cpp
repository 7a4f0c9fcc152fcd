#include "linkwork/model/forces/contact.hpp"

namespace linkwork {

/// A sphere of b on a plane of a.
struct SpherePlaneContact {
  static constexpr HistoryKind history = HistoryKind::onset;
  static constexpr int switches = 1;

  static KindInfo info() {
    return {.name = "sphere_plane_contact",
            .placement = "plane",
            .parameters = contact_parameters(
                {{"radius", "m", "of the sphere", Takes::number, {.example = 2.0, .bounds = positive}}}),
            .documentation =
                "Contact of a sphere of b, by its center and `radius` [m], with a plane of a, by a point and "
                "the normal toward b; stiffness K [N/m^n] and exponent n, hysteresis factor c, coefficient of "
                "friction, transition speed [m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], "
                "d_dot_0 the speed at which contact began; see linkwork.contact_hysteresis."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, HistoryVariable<Real>& history, Wrenches<Real>& out) {
    const Vec3<Real> n = i.A * at.z_i(), to_center = way_to(i, j, at.s_j);
    const Real height = n.dot(to_center - i.A * at.s_i);
    contact<Real>(parameters, 1, {i, to_center, -height}, {j, j.A * at.s_j, -height}, n, parameters[0].value - height,
                  history, out);
  }
};

LINKWORK_DEFINE_FORCE(sphere_plane_contact, SpherePlaneContact)

}  // namespace linkwork
