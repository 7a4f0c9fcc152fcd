// Compiled once for the kinds and once per instruction set for their evaluation, as joints are.
#include "linkwork/model/coordinate_rows.hpp"

#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// The distance of two points.
struct LengthRow {
  static constexpr int rows = 1;
  static KindInfo info() { return {.name = "length"}; }

  template <class Real>
  LINKWORK_INLINE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                       const BodyState<Real>& j, Rows<Real, rows> out) {
    separation<Real>(i, j, at.s_i, at.s_j, {Real(0), Real(0), Real(0)}, out);
  }
};

/// The angle about z_i.
struct AngleRow {
  static constexpr int rows = 1;
  static KindInfo info() { return {.name = "angle"}; }

  template <class Real>
  LINKWORK_INLINE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                       const BodyState<Real>& j, Rows<Real, rows> out) {
    angle<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), out);
  }
};

/// The same without the angle itself.
struct TurningRow {
  static constexpr int rows = 1;
  static KindInfo info() { return {.name = "turning"}; }

  template <class Real>
  LINKWORK_INLINE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                       const BodyState<Real>& j, Rows<Real, rows> out) {
    turning<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), out);
  }
};

/// The shift along z_i.
struct DisplacementRow {
  static constexpr int rows = 1;
  static KindInfo info() { return {.name = "displacement"}; }

  template <class Real>
  LINKWORK_INLINE static void evaluate(const Attachment<Real>& at, const Signal<Real>*, const BodyState<Real>& i,
                                       const BodyState<Real>& j, Rows<Real, rows> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out);
  }
};

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
