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

/// Number k of the joint's point on the second body, of `width` joints from `first` on.
LINKWORK_INLINE const double* point_of(const JointArrays& joints, int first, int k) {
  const AttachmentPart& part = joints.attachment[1];
  return part.from + part.step * (joints.first + first) + k * width;
}

template <class Real>
LINKWORK_INLINE Vec3<Real> turned(const Mat3<Real>& A, const Vec3<Real>& s) {
  Vec3<Real> out;
  for (int k = 0; k < 3; ++k) out[k] = A(k, 0) * s[0] + A(k, 1) * s[1] + A(k, 2) * s[2];
  return out;
}

/// D^T lambda, moved to the point; `arm_of(A)` leads there from the body.
template <int rows, class Real, class Arm>
LINKWORK_INLINE void react(const Real* D, const Real* lambda, const Real* q, const Real& sign, const Arm& arm_of,
                           Vec3<Real>& force, Vec3<Real>& torque) {
  Vec3<Real> F = Vec3<Real>::Zero(), T = Vec3<Real>::Zero();
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r) LINKWORK_UNROLL
    for (int k = 0; k < 3; ++k) {
      F[k] += lambda[r] * D[6 * r + k];
      T[k] += lambda[r] * D[6 * r + 3 + k];
    }
  const Mat3<Real> A = rotation_matrix<Real>(Vec4<Real>(q[3], q[4], q[5], q[6]));
  const Vec3<Real> arm = arm_of(A), moved = turned(A, T), moment = arm.cross(F);
  for (int k = 0; k < 3; ++k) {
    force[k] = sign * F[k];
    torque[k] = sign * (moved[k] - moment[k]);
  }
}

template <int rows>
LINKWORK_INLINE void find_one(const JointArrays& joints, int joint, const Place& at) {
  Vec3<double> s_j, force, torque;
  for (int k = 0; k < 3; ++k) s_j[k] = point_of(joints, joint - joint % width, k)[joint % width];
  const auto arm_of = [&](const Mat3<double>& A) {
    return at.grounded ? Vec3<double>(s_j[0] - at.q[0], s_j[1] - at.q[1], s_j[2] - at.q[2]) : turned(A, s_j);
  };
  react<rows>(at.D, at.lambda, at.q, at.grounded ? -1.0 : 1.0, arm_of, force, torque);
  for (int k = 0; k < 3; ++k) {
    at.force[k] = force[k];
    at.torque[k] = torque[k];
  }
}

template <int rows>
LINKWORK_INLINE void find_pack(const JointArrays& joints, int first, const Place* places) {
  const double *of_D[width], *of_q[width], *of_lambda[width];
  double *of_force[width], *of_torque[width];
  Pack sign;
  for (int l = 0; l < width; ++l) {
    of_D[l] = places[l].D;
    of_q[l] = places[l].q;
    of_lambda[l] = places[l].lambda;
    of_force[l] = places[l].force;
    of_torque[l] = places[l].torque;
    sign.v[l] = places[l].grounded ? -1.0 : 1.0;
  }
  Pack D[6 * rows], lambda[rows], q[7];
  gather<6 * rows>(of_D, D);
  gather<rows>(of_lambda, lambda);
  gather<7>(of_q, q);
  Vec3<Pack> s_j, force, torque;
  for (int k = 0; k < 3; ++k) s_j[k].v = load_native(point_of(joints, first, k));
  const auto arm_of = [&](const Mat3<Pack>& A) {
    Vec3<Pack> arm = turned(A, s_j);
    for (int k = 0; k < 3; ++k) arm[k] = select(Pack(0.0) > sign, s_j[k] - q[k], arm[k]);
    return arm;
  };
  react<rows>(D, lambda, q, sign, arm_of, force, torque);
  scatter<3>(force.data(), of_force);
  scatter<3>(torque.data(), of_torque);
}

/// Asks for what a large model has in memory only: what reactions of `width` joints are found from, and where they go.
template <int rows>
LINKWORK_INLINE void prefetch_places(const JointArrays& joints, int first, const double* D, const double* q,
                                     double* force, double* torque) {
  constexpr int line = 8;
  for (int joint = first; joint < first + width; ++joint) {
    const double* D_j = D + joints.D[joint] + 6 * rows;
    for (int k = 0; k < 6 * rows; k += line) __builtin_prefetch(D_j + k);
    __builtin_prefetch(q + 7l * joints.body_j[joint]);
    __builtin_prefetch(force + 3l * joints.number[joint], 1);
    __builtin_prefetch(torque + 3l * joints.number[joint], 1);
  }
}

/// Few one by one: a pack costs as much whatever it holds. The last joint may be found more than once, with the same
/// numbers.
template <int rows>
void find(const JointArrays& joints, const double* D, const double* q, const double* lambda, double* force,
          double* torque) {
  constexpr int few = 2;
  const auto place = [&](int joint) { return place_of(joints, joint, rows, D, q, lambda, force, torque); };
  if (joints.count <= few) {
    for (int joint = 0; joint < joints.count; ++joint) find_one<rows>(joints, joint, place(joint));
    return;
  }
  constexpr int ahead = 16, many = 2000;
  for (int first = 0; first < joints.count; first += width) {
    if (joints.count > many && first + ahead + width <= joints.count)
      prefetch_places<rows>(joints, first + ahead, D, q, force, torque);
    Place places[width];
    for (int l = 0; l < width; ++l) places[l] = place(first + l < joints.count ? first + l : joints.count - 1);
    find_pack<rows>(joints, first, places);
  }
}

}  // namespace
}  // namespace simd::LINKWORK_ISA

namespace LINKWORK_ISA {

void joint_reactions(const JointArrays& joints, int rows, const double* D, const double* q, const double* lambda,
                     double* force, double* torque) {
  using namespace simd::LINKWORK_ISA;
  constexpr decltype(&find<1>) of_rows[] = {&find<1>, &find<2>, &find<3>, &find<4>, &find<5>, &find<6>};
  of_rows[rows - 1](joints, D, q, lambda, force, torque);
}

}  // namespace LINKWORK_ISA
}  // namespace linkwork

#else

#include "linkwork/math/choice_by_instruction_set.hpp"

namespace linkwork {

LINKWORK_CHOOSE_BY_INSTRUCTION_SET(JointReactions, joint_reactions)

}  // namespace linkwork

#endif
