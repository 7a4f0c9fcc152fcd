#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A hinge: the bodies share a point and the axis through it (5 equations).
struct Revolute {
  static constexpr int rows = 5;
  static constexpr bool holds_point = true;

  static KindInfo info() {
    return {.name = "revolute",
            .placement = "axis",
            .equations = {translation(Axis::x), translation(Axis::y), translation(Axis::z),
                          rotation_about(Axis::y, Axis::z, Axis::x), rotation_about(Axis::x, Axis::z, Axis::y)},
            .coordinates = {&turn_about_axis},
            .documentation = "Hinge: bodies a and b share a point and an axis; rotation about the axis is free."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                          const BodyState<Real>& j, Rows<Real, rows> out) {
    coincident<Real>(i, j, at.s_i, at.s_j, out.template slice<0, 3>());
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out.template slice<3, 2>());
  }
};

LINKWORK_DEFINE_JOINT(revolute, Revolute)

}  // namespace linkwork
