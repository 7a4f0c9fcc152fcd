#include <numbers>

#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// A wheel rolls on a rack (1 equation).
struct RackPinion {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "rack_pinion",
            .placement = "two_axes",
            .parameters = {{"radius", "m", "of the pitch circle", Takes::number, {.example = 0.3}}},
            .equations = {{"rolling of the pitch circle"}},
            .symmetric = false,
            .documentation =
                "Rack and pinion: pinion b of pitch `radius` [m] rolls on rack a. Of the two axes the first "
                "is the rack's direction, the second the pinion's axis; the rack is on the side of direction "
                "x axis, with a negative radius on the other side. Other joints keep the pinion on the rack."};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    const Real radius = parameters[0].value;
    Equation<Real> shift, turn;
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, shift.rows());
    angle<Real>(i, j, at.x_i(), at.z_i(), at.x_j(), turn.rows());
    combine<Real, 2>({Real(1), radius}, {shift, turn}, out);
    out.Phi[0] = wrapped<Real>(out.Phi[0], Real(2.0 * std::numbers::pi) * radius);
  }
};

LINKWORK_DEFINE_JOINT(rack_pinion, RackPinion)

}  // namespace linkwork
