#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A sleeve on a shaft: the bodies share an axis (4 equations).
struct Cylindrical {
  static constexpr int rows = 4;

  static KindInfo info() {
    return {.name = "cylindrical",
            .placement = "axis",
            .equations = {translation_along(Axis::x), translation_along(Axis::y),
                          rotation_about(Axis::y, Axis::z, Axis::x), rotation_about(Axis::x, Axis::z, Axis::y)},
            .coordinates = {&turn_about_axis, &shift_along_axis},
            .documentation =
                "Sleeve on a shaft: bodies a and b share an axis; sliding along it and rotation about it are free."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    on_line<Real>(i, j, at, out.template slice<0, 2>());
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out.template slice<2, 2>());
  }
};

LINKWORK_DEFINE_JOINT(cylindrical, Cylindrical)

}  // namespace linkwork
