#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A weld: no relative motion (6 equations).
struct Fixed {
  static constexpr int rows = 6;
  static constexpr bool holds_point = true;

  static KindInfo info() {
    return {.name = "fixed",
            .placement = "frame",
            .equations = {translation(Axis::x), translation(Axis::y), translation(Axis::z),
                          rotation_about(Axis::z, Axis::x, Axis::y), rotation_about(Axis::x, Axis::y, Axis::z),
                          rotation_about(Axis::y, Axis::z, Axis::x)},
            .documentation = "Weld: bodies a and b keep their relative position and orientation."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    coincident<Real>(i, j, at.s_i, at.s_j, out.template slice<0, 3>());
    same_axes<Real>(i, j, at, out.template slice<3, 3>());
  }
};

LINKWORK_DEFINE_JOINT(fixed, Fixed)

}  // namespace linkwork
