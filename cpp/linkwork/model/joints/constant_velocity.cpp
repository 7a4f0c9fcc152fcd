#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A homokinetic joint: the bodies share a point, and their relative rotation has no part about the shafts: its axis is
/// in the plane that halves the angle between them (4 equations).
struct ConstantVelocity {
  static constexpr int rows = 4;
  static constexpr bool holds_point = true;

  static KindInfo info() {
    return {.name = "constant_velocity",
            .placement = "shafts",
            .equations = {translation(Axis::x), translation(Axis::y), translation(Axis::z),
                          rotation_named("rotation about both shafts", {{Axis::x, Axis::y}, {Axis::y, Axis::x}})},
            .documentation =
                "Homokinetic joint: bodies a and b share a point, and the shaft of b turns about its axis "
                "exactly as the shaft of a does, at any angle between them below 180 degrees."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    coincident<Real>(i, j, at.s_i, at.s_j, out.template slice<0, 3>());
    const RelativeRotation<Real> rotation(i, j);
    Equation<Real> xy, yx;
    rotation.perpendicular(rotation.direction(at.x_i()), at.y_j(), xy.rows());
    rotation.perpendicular(rotation.direction(at.y_i()), at.x_j(), yx.rows());
    combine<Real, 2>({Real(0.5), Real(-0.5)}, {xy, yx}, out.template slice<3, 1>());
  }
};

LINKWORK_DEFINE_JOINT(constant_velocity, ConstantVelocity)

}  // namespace linkwork
