#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

/// Spring and damper between two points by their characteristics.
struct NonlinearSpringDamper : CharacteristicSpring<Length> {
  static KindInfo info() {
    return {.name = "nonlinear_spring_damper",
            .placement = Length::placement,
            .parameters = {{"spring",
                            "N/m",
                            "pull [N] over the extension [m], its slope",
                            Takes::characteristic,
                            {.usual = 0.0, .example = 100.0}},
                           {"damper",
                            "N s/m",
                            "pull [N] over the rate [m/s], its slope",
                            Takes::characteristic,
                            {.usual = 0.0, .example = 10.0}},
                           {"free_length",
                            "m",
                            "where the spring is free",
                            Takes::function,
                            {.initial_distance = true, .example = 1.0}}},
            .documentation =
                "Spring and damper between a point of a and a point of b by their characteristics: the pull "
                "is spring(l - l_0) + damper(l_dot) [N], positive in tension. Each is a function of its "
                "extension [m] or rate [m/s], such as linkwork.functions.table(x, f), or a number for a "
                "linear one. Springs by numbers, tables, polynomials, harmonics and sums of these store energy; with "
                "other functions, and where they are free by a function without derivatives, what is in them counts "
                "as work."};
  }
};

LINKWORK_DEFINE_FORCE(nonlinear_spring_damper, NonlinearSpringDamper)

}  // namespace linkwork
