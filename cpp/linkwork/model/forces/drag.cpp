#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Resistance of a medium that grows with the square of the speed.
struct Drag {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {
        .name = "drag",
        .placement = "point",
        .parameters =
            {{"coefficient", "N s^2/m^2", "rho c_d A / 2", Takes::function, {.example = 5.0, .bounds = not_negative}}},
        .documentation =
            "Drag of a medium fixed in a (usually the ground) on a point of b: the force on b is -c |u| u "
            "[N], u the velocity of the point against the medium [m/s] and `coefficient` c = rho c_d A / "
            "2 [N s^2/m^2]. Nothing acts on a."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j, HistoryVariable<Real>&,
                                          Wrenches<Real>& out) {
    using std::sqrt;
    const Vec3<Real> arm = j.A * at.s_j;
    const Vec3<Real> point_dot = j.r_dot + j.A * j.omega.cross(at.s_j);
    const Vec3<Real> u = point_dot - i.r_dot - (i.A * i.omega).cross(way_to(i, j, at.s_j));
    const Vec3<Real> F = -parameters[0].value * sqrt(u.squaredNorm()) * u;
    out.force_j = F;
    out.torque_j = j.A.transpose() * arm.cross(F);
    out.power = F.dot(point_dot);
  }
};

LINKWORK_DEFINE_FORCE_PACKS(drag, Drag)

}  // namespace linkwork
