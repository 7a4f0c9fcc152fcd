#include "linkwork/model/rod.hpp"

namespace linkwork {

/// A massless rod with ball ends: two points keep a distance, constant or a function of time (1 equation).
struct Distance : Rod {
  static KindInfo info() {
    return {.name = "distance",
            .placement = "two_points",
            .parameters = {length()},
            .equations = {distance_of_points()},
            .documentation =
                "Massless rod with ball ends: a point of a and a point of b keep the distance `length` "
                "[m], constant or a function of time. The multiplier is the rod's force [N], "
                "compression positive."};
  }
};

LINKWORK_DEFINE_JOINT(distance, Distance)

}  // namespace linkwork
