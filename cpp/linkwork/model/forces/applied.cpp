#include "linkwork/model/force_kind.hpp"

namespace linkwork {

/// A force and a torque on body j at its point, components in the joint frame of body i: i = ground gives inertial
/// components, i = j components that turn with the body. Nothing acts on i.
struct Applied {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {.name = "applied",
            .placement = "frame",
            .parameters = {{"force_x", "N", "along the frame's x axis", Takes::function, {.example = 20.0}},
                           {"force_y", "N", "along the frame's y axis", Takes::function, {.example = 20.0}},
                           {"force_z", "N", "along the frame's z axis", Takes::function, {.example = 20.0}},
                           {"torque_x", "N m", "about the frame's x axis", Takes::function, {.example = 20.0}},
                           {"torque_y", "N m", "about the frame's y axis", Takes::function, {.example = 20.0}},
                           {"torque_z", "N m", "about the frame's z axis", Takes::function, {.example = 20.0}}},
            .documentation =
                "Force [N] and torque [N m] on body b at a point of b, constant or functions of time, with "
                "components in the frame of body a (ground: inertial; b itself: body-fixed)."};
  }

  // force: F = A_i C_i f;   torque about the centre of mass, body axes: s_j x A_j^T F + A_j^T A_i C_i n
  // power: F . (r_dot + A_j w x s_j) + n . w
  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j, HistoryVariable<Real>&,
                                          Wrenches<Real>& out) {
    const Vec3<Real> f(parameters[0].value, parameters[1].value, parameters[2].value);
    const Vec3<Real> n(parameters[3].value, parameters[4].value, parameters[5].value);
    const Vec3<Real> F = i.A * (at.C_i * f);
    const Vec3<Real> N = i.A * (at.C_i * n);
    out.force_j = F;
    out.torque_j = at.s_j.cross(Vec3<Real>(j.A.transpose() * F)) + j.A.transpose() * N;
    out.power = F.dot(j.r_dot) + out.torque_j.dot(j.omega);
  }
};

LINKWORK_DEFINE_FORCE_PACKS(applied, Applied)

}  // namespace linkwork
