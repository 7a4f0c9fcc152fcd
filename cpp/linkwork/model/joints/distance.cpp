#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A massless rod with ball ends: two points keep a distance, constant or a function of time (1 equation).
struct Distance {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "distance",
            .placement = "two_points",
            .parameters = {{"length",
                            "m",
                            "of the rod",
                            Takes::differentiable,
                            {.initial_distance = true, .example = 1.0, .bounds = positive}}},
            .equations = {distance_of_points()},
            .documentation =
                "Massless rod with ball ends: a point of a and a point of b keep the distance `length` "
                "[m], constant or a function of time. The multiplier is the rod's force [N], "
                "compression positive."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    separation<Real>(i, j, at.s_i, at.s_j, parameters[0], out);
  }
};

LINKWORK_DEFINE_JOINT(distance, Distance)

}  // namespace linkwork
