#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A ball: the bodies share a point (3 equations).
struct Spherical {
  static constexpr int rows = 3;
  static constexpr bool holds_point = true;

  static KindInfo info() {
    return {.name = "spherical",
            .placement = "point",
            .equations = {translation(Axis::x), translation(Axis::y), translation(Axis::z)},
            .documentation = "Ball joint: bodies a and b share a point; all three rotations are free."};
  }

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                          const BodyState<Real>& j, Rows<Real, rows> out) {
    coincident<Real>(i, j, at.s_i, at.s_j, out);
  }
};

LINKWORK_DEFINE_JOINT(spherical, Spherical)

}  // namespace linkwork
