#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Spring and damper about an axis by their characteristics.
struct NonlinearRotationalSpringDamper : CharacteristicSpring<Angle> {
  static KindInfo info() {
    return {.name = "nonlinear_rotational_spring_damper",
            .placement = Angle::placement,
            .parameters =
                {{"spring",
                  "N m/rad",
                  "torque [N m] over the angle [rad], its slope",
                  Takes::characteristic,
                  {.usual = 0.0, .example = 100.0}},
                 {"damper",
                  "N m s/rad",
                  "torque [N m] over the rate [rad/s], its slope",
                  Takes::characteristic,
                  {.usual = 0.0, .example = 10.0}},
                 {"free_angle", "rad", "where the spring is free", Takes::function, {.usual = 0.0, .example = 1.0}}},
            .documentation =
                "Spring and damper about a joint axis by their characteristics: the torque on b is "
                "-spring(theta - theta_0) - damper(theta_dot) [N m]. Each is a function of its angle [rad] or "
                "rate [rad/s], such as linkwork.functions.table(x, n), or a number for a linear one. "
                "Springs by numbers, tables, polynomials, harmonics and sums of these store energy; with other "
                "functions, and where they are free by a function without derivatives, what is in them counts as "
                "work."};
  }
};

LINKWORK_DEFINE_FORCE(nonlinear_rotational_spring_damper, NonlinearRotationalSpringDamper)

}  // namespace linkwork
