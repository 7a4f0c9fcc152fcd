#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A shift as a function of time (1 equation).
struct DisplacementDriver {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "displacement_driver",
            .placement = "axis",
            .parameters = {{"displacement", "m", "of the point of b, zero at the initial pose", Takes::differentiable}},
            .equations = {translation_named("translation along joint z")},
            .symmetric = false,
            .driver = true,
            .documentation =
                "Driver of a shift: the point of b is `displacement` [m] along the axis of a from where it is "
                "at the initial pose, constant or a function of time. The multiplier is the driving force on "
                "b [N]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out);
    out.Phi[0] -= parameters[0].value;
    out.Phi_t[0] = -parameters[0].rate;
    out.gamma[0] += parameters[0].acceleration;
  }
};

LINKWORK_DEFINE_JOINT(displacement_driver, DisplacementDriver)

}  // namespace linkwork
