#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A point of b stays on a line of a, the joint's axis (2 equations).
struct PointOnLine {
  static constexpr int rows = 2;

  static KindInfo info() {
    return {.name = "point_on_line",
            .placement = "axis",
            .equations = {translation_along(Axis::x), translation_along(Axis::y)},
            .symmetric = false,
            .documentation = "A point of b stays on a line of a, the axis; all rotations are free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    on_line<Real>(i, j, at, out);
  }
};

LINKWORK_DEFINE_JOINT(point_on_line, PointOnLine)

}  // namespace linkwork
