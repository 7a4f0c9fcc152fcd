#include "linkwork/model/forces/contact.hpp"

namespace linkwork {

/// Two spheres.
struct SphereSphereContact {
  static constexpr HistoryKind history = HistoryKind::onset;
  static constexpr int switches = 1;

  static KindInfo info() {
    return {.name = "sphere_sphere_contact",
            .placement = "two_points",
            .parameters = contact_parameters(
                {{"radius_a", "m", "of the sphere of a", Takes::number, {.example = 2.0, .bounds = positive}},
                 {"radius_b", "m", "of the sphere of b", Takes::number, {.example = 2.0, .bounds = positive}}}),
            .documentation =
                "Contact of a sphere of a with a sphere of b, by their centers and radii [m]; stiffness K "
                "[N/m^n] and exponent n, hysteresis factor c, coefficient of friction, transition speed "
                "[m/s]. F = K d^n (1 + c d_dot / d_dot_0) at the depth d [m], d_dot_0 the speed at which "
                "contact began; see linkwork.contact_hysteresis."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, HistoryVariable<Real>& history, Wrenches<Real>& out) {
    const Vec3<Real> d = way_between(i, j, at.s_i, at.s_j);
    const Real distance = d.norm(), depth = parameters[0].value + parameters[1].value - distance;
    const Vec3<Real> n = distance > Real(0) ? Vec3<Real>(d / distance) : Vec3<Real>(i.A * at.z_i());
    const Real half = Real(0.5) * depth, to_i = parameters[0].value - half, to_j = half - parameters[1].value;
    contact<Real>(parameters, 2, {i, i.A * at.s_i, to_i}, {j, j.A * at.s_j, to_j}, n, depth, history, out);
  }
};

LINKWORK_DEFINE_FORCE(sphere_sphere_contact, SphereSphereContact)

}  // namespace linkwork
