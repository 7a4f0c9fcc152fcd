#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Resistance in proportion to the relative motion, the same in all directions.
struct LinearDamping {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {.name = "linear_damping",
            .placement = "point",
            .parameters = {{"damping",
                            "N s/m",
                            "against the velocity of the point",
                            Takes::function,
                            {.usual = 0.0, .example = 10.0}},
                           {"rotational_damping",
                            "N m s/rad",
                            "against the angular velocity",
                            Takes::function,
                            {.usual = 0.0, .example = 10.0}}},
            .documentation =
                "Linear damping of all relative motion: the force on the point of b is -c u [N], u the velocity "
                "of that point as seen from a [m/s] and `damping` c [N s/m]; the torque on b is -C w "
                "[N m], w the angular velocity of b against a [rad/s] and `rotational_damping` C [N m s/rad]. "
                "Both act back on a, at the point of b."};
  }

  // u = P_j_dot - (r_i_dot + omega_i x (P_j - r_i)): seen from a, so that a common rigid motion is not resisted
  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j, HistoryVariable<Real>&,
                                          Wrenches<Real>& out) {
    const Vec3<Real> omega_i = i.A * i.omega, omega_j = j.A * j.omega;
    const Vec3<Real> arm = j.A * at.s_j, arm_i = way_to(i, j, at.s_j);
    const Vec3<Real> u = j.r_dot + omega_j.cross(arm) - i.r_dot - omega_i.cross(arm_i), w = omega_j - omega_i;
    const Vec3<Real> F = -parameters[0].value * u, N = -parameters[1].value * w;
    out.force_j = F;
    out.torque_j = j.A.transpose() * (arm.cross(F) + N);
    out.force_i = -F;
    out.torque_i = -(i.A.transpose() * (arm_i.cross(F) + N));
    out.power = F.dot(u) + N.dot(w);
  }
};

LINKWORK_DEFINE_FORCE_PACKS(linear_damping, LinearDamping)

}  // namespace linkwork
