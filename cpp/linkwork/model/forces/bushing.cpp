#include "linkwork/math/elementary.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// An elastic bearing: springs and dampers along and about three axes.
struct Bushing {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {
        .name = "bushing",
        .placement = "frame",
        .parameters =
            {{"stiffness_x", "N/m", "along x", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"stiffness_y", "N/m", "along y", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"stiffness_z", "N/m", "along z", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"rotational_stiffness_x", "N m/rad", "about x", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"rotational_stiffness_y", "N m/rad", "about y", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"rotational_stiffness_z", "N m/rad", "about z", Takes::differentiable, {.usual = 0.0, .example = 100.0}},
             {"damping_x", "N s/m", "along x", Takes::function, {.usual = 0.0, .example = 10.0}},
             {"damping_y", "N s/m", "along y", Takes::function, {.usual = 0.0, .example = 10.0}},
             {"damping_z", "N s/m", "along z", Takes::function, {.usual = 0.0, .example = 10.0}},
             {"rotational_damping_x", "N m s/rad", "about x", Takes::function, {.usual = 0.0, .example = 10.0}},
             {"rotational_damping_y", "N m s/rad", "about y", Takes::function, {.usual = 0.0, .example = 10.0}},
             {"rotational_damping_z", "N m s/rad", "about z", Takes::function, {.usual = 0.0, .example = 10.0}}},
        .documentation =
            "Elastic bearing between frames of a and b: along the axes of a's frame -k u - c u_dot [N] "
            "acts on the point of b, u its shift [m]; about them -J (K phi + C phi_dot) [N m], phi the rotation "
            "vector of b's frame against a's [rad], below half a turn, and J(phi) what makes phi_dot of the angular "
            "velocity: 1 for small angles. The energy is phi^T K phi / 2."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, HistoryVariable<Real>&, Wrenches<Real>& out) {
    // u = F_i^T d, u_dot = F_i^T d_dot - w_i x u in the frame F_i = A_i C_i;  R = F_i^T F_j = exp(phi), phi_dot = J w
    // with w = F_j^T (omega_j - omega_i) and J = 1 + phi~/2 + (1/a^2 - (1 + cos a) / (2 a sin a)) phi~^2, a = |phi|.
    const Mat3<Real> F_i = i.A * at.C_i, F_j = j.A * at.C_j;
    const Vec3<Real> arm_i = i.A * at.s_i, arm_j = j.A * at.s_j, d = way_between(i, j, at.s_i, at.s_j);
    const Vec3<Real> omega_i = i.A * i.omega, omega_j = j.A * j.omega;
    const Vec3<Real> d_dot = j.r_dot + omega_j.cross(arm_j) - i.r_dot - omega_i.cross(arm_i);
    const Vec3<Real> u = F_i.transpose() * d, u_dot = F_i.transpose() * (d_dot - omega_i.cross(d));
    const Vec3<Real> phi = rotation_vector<Real>(F_i.transpose() * F_j);
    const Mat3<Real> tilde = skew<Real>(phi);
    const Real a2 = phi.squaredNorm(), a = std::sqrt(a2);
    constexpr double small = 1e-6;  // square of an angle up to which the series is as exact
    const Real factor = a2 < Real(small)
                            ? Real(1) / Real(12) + a2 / Real(720)
                            : Real(1) / a2 - (Real(1) + elementary::cosine(a)) / (Real(2) * a * elementary::sine(a));
    const Mat3<Real> J = Mat3<Real>::Identity() + Real(0.5) * tilde + factor * tilde * tilde;
    const Vec3<Real> phi_dot = J * (F_j.transpose() * (omega_j - omega_i));

    Vec3<Real> force, moment;  // in the frame of a, and along phi
    for (int k = 0; k < 3; ++k) {
      const auto [K, K_dot, K_ddot] = parameters[k];
      const auto [Q, Q_dot, Q_ddot] = parameters[3 + k];
      static_cast<void>(K_ddot), static_cast<void>(Q_ddot);
      const Real c = parameters[6 + k].value, C = parameters[9 + k].value;
      force[k] = -K * u[k] - c * u_dot[k];
      moment[k] = -Q * phi[k] - C * phi_dot[k];
      out.potential += Real(0.5) * (K * u[k] * u[k] + Q * phi[k] * phi[k]);
      out.power += Real(0.5) * (K_dot * u[k] * u[k] + Q_dot * phi[k] * phi[k]) - c * u_dot[k] * u_dot[k] -
                   C * phi_dot[k] * phi_dot[k];
    }
    const Vec3<Real> F = F_i * force, T = F_j * (J.transpose() * moment);
    out.force_j = F;
    out.torque_j = j.A.transpose() * (arm_j.cross(F) + T);
    out.force_i = -F;
    out.torque_i = -(i.A.transpose() * ((arm_i + d).cross(F) + T));
  }
};

LINKWORK_DEFINE_FORCE(bushing, Bushing)

}  // namespace linkwork
