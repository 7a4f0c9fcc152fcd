#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A Cardan joint: the bodies share a point; an axis of one stays perpendicular to an axis of the other (4 equations).
struct Universal {
  static constexpr int rows = 4;
  static constexpr bool holds_point = true;

  static KindInfo info() {
    return {.name = "universal",
            .placement = "two_axes",
            .equations = {translation(Axis::x), translation(Axis::y), translation(Axis::z),
                          rotation_named("rotation about both axes' normal", {{Axis::z, Axis::z}})},
            .coordinates = {&turn_about_axis_a, &turn_about_axis_b},
            .documentation =
                "Cardan joint: bodies a and b share a point; the axis fixed in a stays perpendicular to "
                "the axis fixed in b, and rotation about each is free."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                          const BodyState<Real>& j, Rows<Real, rows> out) {
    coincident<Real>(i, j, at.s_i, at.s_j, out.template slice<0, 3>());
    perpendicular<Real>(i, j, at.z_i(), at.z_j(), out.template slice<3, 1>());
  }
};

LINKWORK_DEFINE_JOINT(universal, Universal)

}  // namespace linkwork
