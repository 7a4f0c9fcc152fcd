#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A slider: the bodies share an axis and do not turn against each other (5 equations).
struct Translational {
  static constexpr int rows = 5;
  static constexpr bool slides = true;

  static KindInfo info() {
    return {
        .name = "translational",
        .placement = "axis",
        .equations = {translation_along(Axis::x), translation_along(Axis::y), rotation_about(Axis::y, Axis::z, Axis::x),
                      rotation_about(Axis::x, Axis::z, Axis::y), rotation_about(Axis::z, Axis::x, Axis::y)},
        .coordinates = {&shift_along_axis},
        .documentation = "Slider: body b slides on body a along an axis; no rotation is free."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                          const BodyState<Real>& j, Rows<Real, rows> out) {
    on_line<Real>(i, j, at, out.template slice<0, 2>());
    const RelativeRotation<Real> rotation(i, j);
    parallel<Real>(rotation, at.z_i(), at.x_j(), at.y_j(), out.template slice<2, 2>());
    rotation.perpendicular(rotation.direction(at.x_i()), at.y_j(), out.template slice<4, 1>());
  }
};

LINKWORK_DEFINE_JOINT(translational, Translational)

}  // namespace linkwork
