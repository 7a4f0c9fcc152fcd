#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A massless link with two parallel hinges (4 equations).
struct RevoluteRevolute {
  static constexpr int rows = 4;

  static KindInfo info() {
    return {.name = "revolute_revolute",
            .placement = "centers",
            .parameters = {{"length",
                            "m",
                            "between the axes",
                            Takes::differentiable,
                            {.initial_distance = true, .example = 1.0, .bounds = positive}}},
            .equations = {rotation_about(Axis::y, Axis::z, Axis::x), rotation_about(Axis::x, Axis::z, Axis::y),
                          translation_along(Axis::z), distance_of_points()},
            .documentation =
                "Massless link, hinged on a and on b about parallel axes that are `length` [m] apart, "
                "constant or a function of time."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out.template slice<0, 2>());
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out.template slice<2, 1>());
    separation<Real>(i, j, at.s_i, at.s_j, parameters[0], out.template slice<3, 1>());
  }
};

LINKWORK_DEFINE_JOINT(revolute_revolute, RevoluteRevolute)

}  // namespace linkwork
