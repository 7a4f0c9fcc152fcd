#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// Two planes stay on each other (3 equations).
struct Planar {
  static constexpr int rows = 3;

  static KindInfo info() {
    return {.name = "planar",
            .placement = "axis",
            .equations = {translation_along(Axis::z), rotation_about(Axis::y, Axis::z, Axis::x),
                          rotation_about(Axis::x, Axis::z, Axis::y)},
            .documentation =
                "A plane of b slides on a plane of a: shifts normal to the axis and rotation about it are "
                "free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out.template slice<0, 1>());
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out.template slice<1, 2>());
  }
};

LINKWORK_DEFINE_JOINT(planar, Planar)

}  // namespace linkwork
