#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A point of b stays in a plane of a, normal to the joint's axis (1 equation).
struct PointOnPlane {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "point_on_plane",
            .placement = "axis",
            .equations = {translation_along(Axis::z)},
            .symmetric = false,
            .documentation = "A point of b stays in a plane of a through the joint's point, normal to the axis."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out);
  }
};

LINKWORK_DEFINE_JOINT(point_on_plane, PointOnPlane)

}  // namespace linkwork
