#include <numbers>

#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// Spur gears on parallel axes, wherever these are held: their angles against the line of centers are in proportion
/// (1 equation). What is known of the angles up to full turns is known of the mesh up to one tooth.
struct Gear {
  static constexpr int rows = 1;

  static KindInfo info() {
    return {.name = "gear",
            .placement = "centers",
            .parameters = {{"teeth_a", "", "number of teeth of a", Takes::whole_number, {.example = 20.0}},
                           {"teeth_b", "", "number of teeth of b", Takes::whole_number, {.example = -37.0}}},
            .equations = {{"rolling of the pitch circles"}},
            .symmetric = false,
            .documentation =
                "Spur gears: wheels a and b with `teeth_a` and `teeth_b` teeth mesh on the line between their "
                "centers; their axes are kept parallel and apart by other joints, on a carrier that may move. "
                "A negative number of teeth is that of a ring gear with teeth inside, in which the other wheel, of "
                "fewer teeth, turns.",
            .contradiction = &contradiction};
  }

  static std::string contradiction(const Parameter* teeth) {
    const double a = teeth[0].constant, b = teeth[1].constant;
    if ((a > 0.0 && b > 0.0) || (a * b < 0.0 && a + b < 0.0)) return "";
    if (a < 0.0 && b < 0.0) return "two ring gears with teeth inside do not mesh";
    return "a wheel turns in a ring gear only if that has more teeth";
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    Equation<Real> of_i, of_j;
    bearing<Real>(i, j, at.x_i(), at.y_i(), at.s_i, at.s_j, of_i.rows());
    bearing<Real>(j, i, at.x_j(), at.y_j(), at.s_j, at.s_i, of_j.swapped());
    const Real a = parameters[0].value, b = parameters[1].value;
    combine<Real, 2>({Real(1), b / a}, {of_i, of_j}, out);
    out.Phi[0] = wrapped<Real>(out.Phi[0], Real(2.0 * std::numbers::pi) / a);
  }
};

LINKWORK_DEFINE_JOINT(gear, Gear)

}  // namespace linkwork
