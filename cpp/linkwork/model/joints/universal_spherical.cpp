#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A massless rod with a Cardan joint on a and a ball on b (1 equation).
struct UniversalSpherical {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "universal_spherical",
            .placement = "two_points",
            .parameters = {{"length",
                            "m",
                            "of the rod",
                            Takes::differentiable,
                            {.initial_distance = true, .example = 1.0, .bounds = positive}}},
            .equations = {distance_of_points()},
            .documentation =
                "Massless rod with a Cardan joint on a and a ball joint on b: the two points keep the "
                "distance `length` [m], constant or a function of time. Where the rod turns to about itself "
                "bears on neither body, so this is the equation of `distance`."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    separation<Real>(i, j, at.s_i, at.s_j, parameters[0], out);
  }
};

LINKWORK_DEFINE_JOINT(universal_spherical, UniversalSpherical)

}  // namespace linkwork
