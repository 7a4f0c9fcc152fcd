#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// Translational spring, damper and actuator between two points. Reference: Flores (2015), section on force elements.
struct SpringDamper {
  static constexpr HistoryKind history = HistoryKind::none;

  static KindInfo info() {
    return {.name = "spring_damper",
            .placement = "two_points",
            .parameters = {{"stiffness", "N/m", "of the spring", Takes::differentiable, {.example = 100.0}},
                           {"damping", "N s/m", "of the damper", Takes::function, {.example = 10.0}},
                           {"free_length",
                            "m",
                            "where the spring is free",
                            Takes::differentiable,
                            {.initial_distance = true, .example = 1.0}},
                           {"force", "N", "of the actuator, pull positive", Takes::function, {.example = 20.0}}},
            .documentation =
                "Spring [N/m], damper [N s/m] and actuator [N] between a point of a and a point of b: the "
                "pull is f = k (l - l_0) + c l_dot + f_a, positive in tension."};
  }

  // The element acts along the coordinate l = |d| whose row D is that of `separation`: g = -f D^T. Its power without a
  // potential is that of damper and actuator, and dV/dt at rest where stiffness or free length change in time.
  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j, HistoryVariable<Real>&,
                                          Wrenches<Real>& out) {
    using std::sqrt;
    const Real stiffness = parameters[0].value, damping = parameters[1].value, actuator = parameters[3].value;
    const Vec3<Real> d = way_between(i, j, at.s_i, at.s_j);
    const Real l = sqrt(d.squaredNorm());
    const Real extension = l - parameters[2].value;
    out.potential = Real(0.5) * stiffness * extension * extension;
    out.power = Real(0.5) * parameters[0].rate * extension * extension - stiffness * extension * parameters[2].rate;
    // where the points coincide the direction of the pull is undefined: a zero-length spring rests
    const Vec3<Real> u = d / select(l == Real(0), Real(1), l);
    const Vec3<Real> u_in_i = i.A.transpose() * u, u_in_j = j.A.transpose() * u;
    const Vec3<Real> arm_i = at.s_i.cross(u_in_i), arm_j = at.s_j.cross(u_in_j);
    const Real rate = u.dot(j.r_dot - i.r_dot) + arm_j.dot(j.omega) - arm_i.dot(i.omega);
    const Real pull = stiffness * extension + damping * rate + actuator;
    out.force_i = pull * u;
    out.torque_i = pull * arm_i;
    out.force_j = -pull * u;
    out.torque_j = -pull * arm_j;
    out.power -= (damping * rate + actuator) * rate;
  }
};

LINKWORK_DEFINE_FORCE_PACKS(spring_damper, SpringDamper)

}  // namespace linkwork
