#include <numbers>

#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A rotation as a function of time (1 equation).
struct AngleDriver {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "angle_driver",
            .placement = "axis",
            .parameters = {{"angle", "rad", "of b against a, zero at the initial pose", Takes::differentiable}},
            .equations = {rotation_named("rotation about joint z")},
            .symmetric = false,
            .driver = true,
            .documentation =
                "Driver of a rotation: the angle of b against a about the axis, right-handed and zero at the "
                "initial pose, is `angle` [rad], constant or a function of time. Other joints keep the axis. "
                "The multiplier is the driving torque on b [N m]."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    angle<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), out);
    out.Phi[0] = wrapped<Real>(out.Phi[0] - parameters[0].value, Real(2.0 * std::numbers::pi));
    out.Phi_t[0] = -parameters[0].rate;
    out.gamma[0] += parameters[0].acceleration;
  }
};

LINKWORK_DEFINE_JOINT(angle_driver, AngleDriver)

}  // namespace linkwork
