#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A blade or a skate: no motion across it (1 equation of velocities).
struct KnifeEdge {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "knife_edge",
            .placement = "axis",
            .equations = {velocity_along(Axis::z)},
            .symmetric = false,
            .documentation =
                "Knife edge: the point of b has no velocity against a along an axis fixed in b; "
                "nonholonomic. Along the edge and about the point all motion is free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    const Vec3<Real> across = j.A * at.z_j();
    const Vec3<Real> point_dot = j.r_dot + j.A * j.omega.cross(at.s_j);
    const Vec3<Real> rho_i = i.A.transpose() * way_to(i, j, at.s_j);
    const Vec3<Real> rho_i_dot = i.A.transpose() * (point_dot - i.r_dot) - i.omega.cross(rho_i);
    no_slip<Real>(i, j, across, j.A * j.omega.cross(at.z_j()), rho_i, rho_i_dot, at.s_j, Vec3<Real>::Zero(), out);
  }
};

LINKWORK_DEFINE_JOINT(knife_edge, KnifeEdge)

}  // namespace linkwork
