#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// An axis of b stays parallel to an axis of a (2 equations).
struct ParallelAxes {
  static constexpr int rows = 2;

  static KindInfo info() {
    return {
        .name = "parallel_axes",
        .placement = "direction",
        .equations = {rotation_about(Axis::y, Axis::z, Axis::x), rotation_about(Axis::x, Axis::z, Axis::y)},
        .documentation = "An axis of b stays parallel to an axis of a: shifts and rotation about the axis are free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out);
  }
};

LINKWORK_DEFINE_JOINT(parallel_axes, ParallelAxes)

}  // namespace linkwork
