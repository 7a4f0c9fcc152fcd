// Compiled once per instruction set and, without LINKWORK_ISA, for the choice among them.
#include "linkwork/assembly/joint_reactions.hpp"

#if defined(LINKWORK_ISA)

#include "linkwork/math/pack.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace simd::LINKWORK_ISA {
namespace {

/// Where the numbers of a joint are, and those of the body that it is found from: of what acts on the ground, the other.
struct Place {
  const double *D, *q, *lambda;
  double *force, *torque;
  bool grounded;
};

LINKWORK_INLINE Place place_of(const JointArrays& joints, int joint, int rows, const double* D, const double* q,
                               const double* lambda, double* force, double* torque) {
  const bool grounded = joints.body_j[joint] < 0;
  return {D + joints.D[joint] + (grounded ? 0 : 6 * rows),
          q + 7l * (grounded ? joints.body_i : joints.body_j)[joint],
          lambda + joints.row[joint],
          force + 3l * joints.number[joint],
          torque + 3l * joints.number[joint],
          grounded};
}

/// Of `width` joints: rows of D, multipliers, and where the body is, each number of all of them.
template <int rows>
struct Gathered {
  Pack D[6 * rows], lambda[rows], q[7], sign;
  Mask grounded;

  LINKWORK_INLINE Mat3<Pack> orientation() const { return rotation_matrix<Pack>(Vec4<Pack>(q[3], q[4], q[5], q[6])); }
};

/// The rows from `first_row` on.
template <int first_row, int rows>
LINKWORK_INLINE void gather_rows(const Place* places, Gathered<rows>& out) {
  const double *D[width], *q[width], *lambda[width];
  Pack sign;
  for (int l = 0; l < width; ++l) {
    D[l] = places[l].D + 6 * first_row;
    q[l] = places[l].q;
    lambda[l] = places[l].lambda;
    sign.v[l] = places[l].grounded ? -1.0 : 1.0;
  }
  out.sign = sign;
  out.grounded = Pack(0.0) > out.sign;
  if constexpr (first_row < rows) gather<6 * (rows - first_row)>(D, out.D + 6 * first_row);
  gather<rows>(lambda, out.lambda);
  gather<7>(q, out.q);
}

/// The joint's point on its first (0) or second body, of `width` joints from `first` on.
LINKWORK_INLINE Vec3<Pack> point_of(const JointArrays& joints, int side, int first) {
  const AttachmentPart& part = joints.attachment[side];
  Vec3<Pack> s;
  for (int k = 0; k < 3; ++k) s[k].v = load_native(part.from + part.step * (joints.first + first) + k * width);
  return s;
}

LINKWORK_INLINE Vec3<Pack> turned(const Mat3<Pack>& A, const Vec3<Pack>& s) {
  Vec3<Pack> out;
  for (int k = 0; k < 3; ++k) out[k] = A(k, 0) * s[0] + A(k, 1) * s[1] + A(k, 2) * s[2];
  return out;
}

struct Wrench {
  Vec3<Pack> force, torque;
};

/// D^T lambda, moved from the body to the point.
template <int rows>
LINKWORK_INLINE Wrench react(const JointArrays& joints, int first, const Place* places) {
  Gathered<rows> of;
  gather_rows<0>(places, of);
  Vec3<Pack> F = Vec3<Pack>::Zero(), T = Vec3<Pack>::Zero();
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r) LINKWORK_UNROLL
    for (int k = 0; k < 3; ++k) {
      F[k] += of.lambda[r] * of.D[6 * r + k];
      T[k] += of.lambda[r] * of.D[6 * r + 3 + k];
    }
  const Mat3<Pack> A = of.orientation();
  const Vec3<Pack> s_j = point_of(joints, 1, first);
  Vec3<Pack> arm = turned(A, s_j);
  for (int k = 0; k < 3; ++k) arm[k] = select(of.grounded, s_j[k] - of.q[k], arm[k]);
  const Vec3<Pack> moved = turned(A, T), moment = arm.cross(F);
  Wrench out;
  for (int k = 0; k < 3; ++k) {
    out.force[k] = of.sign * F[k];
    out.torque[k] = of.sign * (moved[k] - moment[k]);
  }
  return out;
}

/// The same of joints that hold a point, where the forces of the first rows act; the others have torques alone. What
/// acts on the ground is moved from the body's point to the ground's.
template <int rows>
LINKWORK_INLINE Wrench react_at_point(const JointArrays& joints, int first, const Place* places) {
  Gathered<rows> of;
  gather_rows<3>(places, of);
  const Mat3<Pack> A = of.orientation();
  Wrench out;
  for (int k = 0; k < 3; ++k) out.force[k] = -of.lambda[k];
  out.torque = Vec3<Pack>::Zero();
  if constexpr (rows > 3) {
    Vec3<Pack> T = Vec3<Pack>::Zero();
    LINKWORK_UNROLL for (int r = 3; r < rows; ++r) LINKWORK_UNROLL
      for (int k = 0; k < 3; ++k) T[k] += of.lambda[r] * of.D[6 * r + 3 + k];
    const Vec3<Pack> moved = turned(A, T);
    for (int k = 0; k < 3; ++k) out.torque[k] = of.sign * moved[k];
  }
  if (any(of.grounded)) {
    const Vec3<Pack> s_i = turned(A, point_of(joints, 0, first)), s_j = point_of(joints, 1, first);
    Vec3<Pack> arm;
    for (int k = 0; k < 3; ++k) arm[k] = of.q[k] + s_i[k] - s_j[k];
    const Vec3<Pack> moment = arm.cross(out.force);
    for (int k = 0; k < 3; ++k) out.torque[k] = select(of.grounded, out.torque[k] + moment[k], out.torque[k]);
  }
  return out;
}

template <int rows, bool holds_point>
LINKWORK_INLINE void find_pack(const JointArrays& joints, int first, const Place* places) {
  Wrench found;
  if constexpr (holds_point) found = react_at_point<rows>(joints, first, places);
  else found = react<rows>(joints, first, places);
  double *force[width], *torque[width];
  for (int l = 0; l < width; ++l) {
    force[l] = places[l].force;
    torque[l] = places[l].torque;
  }
  scatter<3>(found.force.data(), force);
  scatter<3>(found.torque.data(), torque);
}

/// Asks for what a large model has in memory only: what reactions of `width` joints are found from, and where they go.
template <int rows, bool holds_point>
LINKWORK_INLINE void prefetch_places(const JointArrays& joints, int first, const double* D, const double* q,
                                     double* force, double* torque) {
  constexpr int line = 8;
  for (int joint = first; joint < first + width; ++joint) {
    const double* D_j = D + joints.D[joint] + 6 * rows;
    for (int k = holds_point ? 6 * 3 + 3 : 0; k < 6 * rows; k += line) __builtin_prefetch(D_j + k, 0, 2);
    __builtin_prefetch(q + 7l * joints.body_j[joint]);
    __builtin_prefetch(force + 3l * joints.number[joint], 1);
    __builtin_prefetch(torque + 3l * joints.number[joint], 1);
  }
}

/// The last joint may be found more than once, with the same numbers.
template <int rows, bool holds_point>
void find(const JointArrays& joints, const double* D, const double* q, const double* lambda, double* force,
          double* torque) {
  constexpr int ahead = 16, many = 2000;
  for (int first = 0; first < joints.count; first += width) {
    if (joints.count > many && first + ahead + width <= joints.count)
      prefetch_places<rows, holds_point>(joints, first + ahead, D, q, force, torque);
    Place places[width];
    for (int l = 0; l < width; ++l)
      places[l] =
          place_of(joints, first + l < joints.count ? first + l : joints.count - 1, rows, D, q, lambda, force, torque);
    find_pack<rows, holds_point>(joints, first, places);
  }
}

}  // namespace
}  // namespace simd::LINKWORK_ISA

namespace LINKWORK_ISA {

void joint_reactions(const JointArrays& joints, int rows, bool holds_point, const double* D, const double* q,
                     const double* lambda, double* force, double* torque) {
  using namespace simd::LINKWORK_ISA;
  using Find = decltype(&find<1, false>);
  constexpr Find of_rows[] = {&find<1, false>, &find<2, false>, &find<3, false>,
                              &find<4, false>, &find<5, false>, &find<6, false>};
  constexpr Find of_points[] = {&find<3, true>, &find<4, true>, &find<5, true>, &find<6, true>};
  (holds_point ? of_points[rows - 3] : of_rows[rows - 1])(joints, D, q, lambda, force, torque);
}

}  // namespace LINKWORK_ISA
}  // namespace linkwork

#else

#include "linkwork/math/choice_by_instruction_set.hpp"

namespace linkwork {

LINKWORK_CHOOSE_BY_INSTRUCTION_SET(JointReactions, joint_reactions)

}  // namespace linkwork

#endif
