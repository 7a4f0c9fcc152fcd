#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A pin of a in a straight slot of b: a massless block, hinged on a, slides on b (4 equations).
struct RevoluteTranslational {
  static constexpr int rows = 4;

  static KindInfo info() {
    return {
        .name = "revolute_translational",
        .placement = "two_axes",
        .equations = {rotation_named("rotation about both axes' normal", {{Axis::z, Axis::z}}),
                      rotation_named("rotation about the slot", {{Axis::z, Axis::x}}),
                      translation_named("translation along the pin"), translation_named("translation across the slot")},
        .symmetric = false,
        .documentation =
            "Pin in a slot: a massless block, hinged on a about the first axis, slides on b along the "
            "second, which is perpendicular to the first."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    const RelativeRotation<Real> rotation(i, j);
    const auto pin = rotation.direction(at.z_i());
    rotation.perpendicular(pin, at.z_j(), out.template slice<0, 1>());
    rotation.perpendicular(pin, at.x_j(), out.template slice<1, 1>());
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out.template slice<2, 1>());
    const Rows<Real, 1> across = out.template slice<3, 1>();
    in_plane<Real>(j, i, at.x_j(), at.s_j, at.s_i, {across.Phi, across.Phi_t, across.gamma, across.D_j, across.D_i});
  }
};

LINKWORK_DEFINE_JOINT(revolute_translational, RevoluteTranslational)

}  // namespace linkwork
