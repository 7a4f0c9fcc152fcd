#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A massless link, hinged on a, with a ball on b (2 equations).
struct RevoluteSpherical {
  static constexpr int rows = 2;

  static KindInfo info() {
    return {.name = "revolute_spherical",
            .placement = "centers",
            .parameters = {{"length",
                            "m",
                            "from the axis to the ball",
                            Takes::differentiable,
                            {.initial_distance = true, .example = 1.0, .bounds = positive}}},
            .equations = {translation_along(Axis::z), distance_of_points()},
            .symmetric = false,
            .documentation =
                "Massless link, hinged on an axis of a and with a ball joint on b: the ball stays on a circle "
                "of a with radius `length` [m] about the axis, constant or a function of time."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out.template slice<0, 1>());
    separation<Real>(i, j, at.s_i, at.s_j, parameters[0], out.template slice<1, 1>());
  }
};

LINKWORK_DEFINE_JOINT(revolute_spherical, RevoluteSpherical)

}  // namespace linkwork
