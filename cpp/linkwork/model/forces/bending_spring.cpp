#include "linkwork/model/forces/coordinates.hpp"

#include "linkwork/math/elementary.hpp"

namespace linkwork {

/// A spring and damper that hold two axes parallel, in all directions alike.
struct BendingSpring {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {.name = "bending_spring",
            .placement = "direction",
            .parameters = {{"stiffness",
                            "N m/rad",
                            "against the angle between the axes",
                            Takes::differentiable,
                            {.usual = 0.0, .example = 100.0}},
                           {"damping",
                            "N m s/rad",
                            "against rotation across the axis",
                            Takes::function,
                            {.usual = 0.0, .example = 10.0}}},
            .documentation =
                "Bending spring [N m/rad] and damper [N m s/rad] that hold an axis of b parallel to an axis "
                "of a, in all directions alike: the torque k beta against the angle beta between the axes, "
                "and c times the relative rotation across the axis of a."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j, HistoryVariable<Real>&,
                                          Wrenches<Real>& out) {
    // V = k beta^2 / 2;  torque on j: -k beta n - c w, n = z_i x z_j / sin(beta), w the relative rotation across z_i
    using elementary::arc_tangent;
    using std::sqrt;
    const Vec3<Real> z_i = i.A * at.z_i(), z_j = j.A * at.z_j(), normal = z_i.cross(z_j);
    const Real sine = sqrt(normal.squaredNorm()), cosine = z_i.dot(z_j), beta = arc_tangent(sine, cosine);
    const Vec3<Real> omega = j.A * j.omega - i.A * i.omega, across = omega - omega.dot(z_i) * z_i;
    const Real stiffness = parameters[0].value, damping = parameters[1].value;
    const Vec3<Real> torque = -damping * across - stiffness * beta / select(sine == Real(0), Real(1), sine) * normal;
    out.torque_i = -(i.A.transpose() * torque);
    out.torque_j = j.A.transpose() * torque;
    out.potential = Real(0.5) * stiffness * beta * beta;
    out.power = Real(0.5) * parameters[0].rate * beta * beta - damping * across.squaredNorm();
  }
};

LINKWORK_DEFINE_FORCE_PACKS(bending_spring, BendingSpring)

}  // namespace linkwork
