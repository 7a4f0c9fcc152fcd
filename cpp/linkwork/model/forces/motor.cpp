#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// A motor about an axis: a torque by its speed curve.
struct Motor : LawAlong<Motor, Angle> {
  static constexpr HistoryKind history = HistoryKind::none;
  static constexpr bool valued = false;

  static KindInfo info() {
    return {.name = "motor",
            .placement = Angle::placement,
            .parameters = {{"curve",
                            "N m s/rad",
                            "torque [N m] over the speed [rad/s], its slope",
                            Takes::characteristic,
                            {.example = 20.0}},
                           {"throttle", "", "factor of the curve", Takes::function, {.usual = 1.0, .example = 1.0}}},
            .documentation =
                "Motor about a joint axis: the torque on b about the axis is throttle(t) curve(theta_dot) [N "
                "m], the curve a function of the speed [rad/s], such as linkwork.functions.table(speeds, "
                "torques)."};
  }

  static Along<double> law(const ForceParameters<double>& parameters, double, double rate, HistoryVariable<double>&) {
    const double torque = parameters[1].value * parameters.at(0, rate);
    return {.force = torque, .power = torque * rate};
  }
};

LINKWORK_DEFINE_FORCE(motor, Motor)

}  // namespace linkwork
