#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// An axis of b stays perpendicular to an axis of a (1 equation).
struct PerpendicularAxes {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "perpendicular_axes",
            .placement = "two_directions",
            .equations = {rotation_named("rotation about both axes' normal", {{Axis::z, Axis::z}})},
            .documentation =
                "An axis of b stays perpendicular to an axis of a; shifts and rotations about both axes are "
                "free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    perpendicular<Real>(i, j, at.z_i(), at.z_j(), out);
  }
};

LINKWORK_DEFINE_JOINT(perpendicular_axes, PerpendicularAxes)

}  // namespace linkwork
