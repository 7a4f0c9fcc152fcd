#include "linkwork/model/rod.hpp"

namespace linkwork {

/// A massless rod with a Cardan joint on a and a ball on b (1 equation).
struct UniversalSpherical : Rod {
  static KindInfo info() {
    return {.name = "universal_spherical",
            .placement = "two_points",
            .parameters = {length()},
            .equations = {distance_of_points()},
            .documentation =
                "Massless rod with a Cardan joint on a and a ball joint on b: the two points keep the "
                "distance `length` [m], constant or a function of time. Where the rod turns to about itself "
                "bears on neither body, so this is the equation of `distance`."};
  }
};

LINKWORK_DEFINE_JOINT(universal_spherical, UniversalSpherical)

}  // namespace linkwork
