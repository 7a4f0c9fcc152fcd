#include <numbers>

#include "linkwork/model/joint_coordinates.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A nut on a thread: a cylindrical joint whose shift is in proportion to its rotation (5 equations).
struct Screw {
  static constexpr int rows = 5;

  static KindInfo info() {
    return {.name = "screw",
            .placement = "axis",
            .parameters = {{"pitch", "m", "advance of b for each turn", Takes::number, {.example = 0.3}}},
            .equations = {translation_along(Axis::x), translation_along(Axis::y),
                          translation_named("translation along the thread"), rotation_about(Axis::y, Axis::z, Axis::x),
                          rotation_about(Axis::x, Axis::z, Axis::y)},
            .coordinates = {&turn_about_axis, &shift_along_axis},
            .documentation =
                "Nut on a thread: bodies a and b share an axis, and b advances along it by `pitch` [m] for "
                "each turn against a; negative: a left-hand thread."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    on_line<Real>(i, j, at, out.template slice<0, 2>());
    parallel<Real>(i, j, at.z_i(), at.x_j(), at.y_j(), out.template slice<3, 2>());
    const Rows<Real, 1> thread = out.template slice<2, 1>();
    const Real pitch = parameters[0].value;
    Equation<Real> shift, turn;
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, shift.rows());
    angle<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), turn.rows());
    combine<Real, 2>({Real(1), pitch * Real(-0.5 / std::numbers::pi)}, {shift, turn}, thread);
    thread.Phi[0] = wrapped<Real>(thread.Phi[0], pitch);
  }
};

LINKWORK_DEFINE_JOINT(screw, Screw)

}  // namespace linkwork
