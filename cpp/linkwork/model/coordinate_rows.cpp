// Compiled once for the kinds and once per instruction set for their evaluation, as joints are.
#include "linkwork/model/coordinate_rows.hpp"

#include "linkwork/model/forces/coordinates.hpp"

namespace linkwork {

template <class Coordinate, bool valued>
struct RowOf {
  static constexpr int rows = 1;
  static constexpr bool turns = Coordinate::kind == CoordinateKind::angle;
  static KindInfo info() { return {.name = "coordinate"}; }

  template <class Real>
  LINKWORK_INLINE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                       const BodyState<Real>& j, Rows<Real, rows> out) {
    Coordinate::template row<valued>(at, i, j, out);
  }
};

using LengthRow = RowOf<Length, true>;
using AngleRow = RowOf<Angle, true>;
using TurningRow = RowOf<Angle, false>;
using DisplacementRow = RowOf<Displacement, true>;

LINKWORK_DEFINE_JOINT(length_row, LengthRow)
LINKWORK_DEFINE_JOINT(angle_row, AngleRow)
LINKWORK_DEFINE_JOINT(turning_row, TurningRow)
LINKWORK_DEFINE_JOINT(displacement_row, DisplacementRow)

#if !defined(LINKWORK_ISA)
JointKind coordinate_rows(CoordinateKind kind, bool valued) {
  if (kind == CoordinateKind::length) return length_row_joint();
  if (kind == CoordinateKind::displacement) return displacement_row_joint();
  return valued ? angle_row_joint() : turning_row_joint();
}
#endif

}  // namespace linkwork
