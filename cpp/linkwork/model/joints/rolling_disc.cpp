#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A thin disc rolls on a plane without slipping: it touches the plane (1 equation), and its lowest point has no
/// velocity along it (2 equations of velocities).
struct RollingDisc {
  static constexpr int rows = 3;

  static KindInfo info() {
    return {.name = "rolling_disc",
            .placement = "disc",
            .parameters = {{"radius", "m", "of the disc", Takes::number, {.example = 0.3, .bounds = positive}}},
            .equations = {translation_named("translation along the normal"), velocity_along(Axis::x),
                          velocity_along(Axis::y)},
            .symmetric = false,
            .documentation =
                "A thin disc of b rolls on a plane of a without slipping; non-holonomic. The joint's point is "
                "the point of the plane for a and the center of the disc for b, its axes are the normal of "
                "the plane, toward the disc, and the axis of the disc; `radius` [m]. Reactions are about the "
                "center of the disc."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    // C = P_j + R e with e = -m / w, the way from the center to the contact: m = n - (n.k) k, w = |m| = (1 -
    // (n.k)^2)^1/2.
    using std::sqrt;
    const Real radius = parameters[0].value;
    const Vec3<Real> n = i.A * at.z_i(), k = j.A * at.z_j();
    const Vec3<Real> n_dot = i.A * i.omega.cross(at.z_i()), k_dot = j.A * j.omega.cross(at.z_j());
    const Real kappa = n.dot(k), kappa_dot = n_dot.dot(k) + n.dot(k_dot);
    const Real w = sqrt(Real(1) - kappa * kappa), w_dot = -kappa * kappa_dot / w;
    const Vec3<Real> m = n - kappa * k, m_dot = n_dot - kappa_dot * k - kappa * k_dot;
    const Vec3<Real> e = -m / w, e_dot = -m_dot / w + m * (w_dot / (w * w));

    // Phi = n . (P_j - P_i) - R w
    Equation<Real> height, tilt;
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, height.rows());
    perpendicular<Real>(i, j, at.z_i(), at.z_j(), tilt.rows());
    const Rows<Real, 1> contact = out.template slice<0, 1>();
    combine<Real, 2>({Real(1), radius * kappa / w}, {height, tilt}, contact);
    contact.Phi[0] = height.Phi - radius * w;
    contact.gamma[0] -= radius * (kappa_dot * kappa_dot + w_dot * w_dot) / w;

    const Vec3<Real> C_dot = j.r_dot + j.A * j.omega.cross(at.s_j) + radius * e_dot;
    const auto place = [&](const BodyState<Real>& body) {
      return Vec3<Real>(body.A.transpose() * (way_to(body, j, at.s_j) + radius * e));
    };
    const auto place_dot = [&](const BodyState<Real>& body, const Vec3<Real>& rho) {
      return Vec3<Real>(body.A.transpose() * (C_dot - body.r_dot) - body.omega.cross(rho));
    };
    const Vec3<Real> rho_i = place(i), rho_j = place(j);
    const Vec3<Real> rho_i_dot = place_dot(i, rho_i), rho_j_dot = place_dot(j, rho_j);
    const auto rolls = [&](const Vec3<Real>& along, Rows<Real, 1> row) {
      no_slip<Real>(i, j, i.A * along, i.A * i.omega.cross(along), rho_i, rho_i_dot, rho_j, rho_j_dot, row);
    };
    rolls(at.x_i(), out.template slice<1, 1>());
    rolls(at.y_i(), out.template slice<2, 1>());
  }
};

LINKWORK_DEFINE_JOINT(rolling_disc, RollingDisc)

}  // namespace linkwork
