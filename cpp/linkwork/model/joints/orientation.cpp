#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// The bodies keep their relative orientation (3 equations).
struct Orientation {
  static constexpr int rows = 3;

  static KindInfo info() {
    return {.name = "orientation",
            .placement = "orientation",
            .equations = {rotation_about(Axis::z, Axis::x, Axis::y), rotation_about(Axis::x, Axis::y, Axis::z),
                          rotation_about(Axis::y, Axis::z, Axis::x)},
            .documentation = "Orientation lock: bodies a and b keep their relative orientation; all shifts are free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    perpendicular<Real>(i, j, at.x_i(), at.y_j(), out.template slice<0, 1>());
    perpendicular<Real>(i, j, at.y_i(), at.z_j(), out.template slice<1, 1>());
    perpendicular<Real>(i, j, at.z_i(), at.x_j(), out.template slice<2, 1>());
  }
};

LINKWORK_DEFINE_JOINT(orientation, Orientation)

}  // namespace linkwork
