#include <cmath>
#include <numbers>

#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// Rotational spring, damper and actuator about the z axis of a joint frame.
struct RotationalSpringDamper {
  static constexpr int memory = 1;  // the last angle: theta is continued over full turns

  static KindInfo info() {
    return {.name = "rotational_spring_damper",
            .placement = "axis",
            .parameters = {"stiffness", "damping", "free_angle", "torque"},
            .differentiated = {"stiffness", "free_angle"},
            .documentation =
                "Spring [N m/rad], damper [N m s/rad] and actuator [N m] about a joint axis: the torque on b about the "
                "axis is -k (theta - theta_0) - c theta_dot + n, theta the angle of b against a [rad], zero where the "
                "joint frames agree and continued over full turns."};
  }

  // theta = atan2(s, c) with s = y_i . x_j, c = x_i . x_j; its row D_theta = (c D_s - s D_c) / (c^2 + s^2) is exact for
  // every pose, and g = n D_theta^T keeps the power balance even where the axes are not parallel.
  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Real* memory, Wrenches<Real>& out) {
    Real Phi[2], Phi_t[2], gamma[2], D_i[12], D_j[12];
    const Rows<Real, 2> rows{Phi, Phi_t, gamma, D_i, D_j};
    perpendicular<Real>(i, j, at.y_i(), at.x_j(), rows.template slice<0, 1>());
    perpendicular<Real>(i, j, at.x_i(), at.x_j(), rows.template slice<1, 1>());
    const Real s = Phi[0], c = Phi[1], scale = Real(1) / (c * c + s * s);
    using Row = Eigen::Map<const Vec3<Real>>;
    const Vec3<Real> row_i = scale * (c * Row(D_i + 3) - s * Row(D_i + 9));
    const Vec3<Real> row_j = scale * (c * Row(D_j + 3) - s * Row(D_j + 9));

    const Real theta = continued(std::atan2(s, c), memory[0]);
    memory[0] = theta;
    const Real rate = row_i.dot(i.omega) + row_j.dot(j.omega);
    const Real stiffness = parameters[0].value, damping = parameters[1].value;
    const Real deflection = theta - parameters[2].value;
    const Real dissipative = parameters[3].value - damping * rate;
    const Real torque = dissipative - stiffness * deflection;
    out.torque_i = torque * row_i;
    out.torque_j = torque * row_j;
    out.potential = Real(0.5) * stiffness * deflection * deflection;
    out.power = dissipative * rate + Real(0.5) * parameters[0].rate * deflection * deflection -
                stiffness * deflection * parameters[2].rate;
  }

  /// The angle equal to `angle` modulo a full turn that is nearest to `last`.
  template <class Real>
  static Real continued(Real angle, Real last) {
    constexpr double turn = 2.0 * std::numbers::pi;
    return angle + turn * std::round((last - angle) / turn);
  }
};

LINKWORK_DEFINE_FORCE(rotational_spring_damper, RotationalSpringDamper)

}  // namespace linkwork
