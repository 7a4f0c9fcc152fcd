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
    same_axes<Real>(i, j, at, out);
  }
};

LINKWORK_DEFINE_JOINT(orientation, Orientation)

}  // namespace linkwork
