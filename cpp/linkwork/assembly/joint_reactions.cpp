// Compiled once per instruction set and, without LINKWORK_ISA, for the choice among them.
#include "linkwork/assembly/joint_reactions.hpp"

#if defined(LINKWORK_ISA)

#include <type_traits>

#include "linkwork/math/pack.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace simd::LINKWORK_ISA {
namespace {

/// Where numbers of `width` joints are. What acts on the ground is found from the other body.
struct Places {
  const double *D[width], *q[width], *lambda[width];
  double *force[width], *torque[width];
  Pack sign;  ///< -1 where the second body is the ground
};

LINKWORK_INLINE Places places_of(const JointArrays& joints, int first, int rows, const double* D, const double* q,
                                 const double* lambda, double* force, double* torque) {
  Places at;
  for (int l = 0; l < width; ++l) {
    const int joint = first + l < joints.count ? first + l : joints.count - 1;
    const bool grounded = joints.body_j[joint] < 0;
    at.D[l] = D + joints.D[joint] + (grounded ? 0 : 6 * rows);
    at.q[l] = q + 7l * (grounded ? joints.body_i : joints.body_j)[joint];
    at.lambda[l] = lambda + joints.row[joint];
    at.force[l] = force + 3l * joints.number[joint];
    at.torque[l] = torque + 3l * joints.number[joint];
    at.sign.v[l] = grounded ? -1.0 : 1.0;
  }
  return at;
}

/// D^T lambda.
template <int rows>
LINKWORK_INLINE void sum_rows(const Places& at, Vec3<Pack>& force, Vec3<Pack>& torque) {
  Pack D[6 * rows], lambda[rows];
  gather<6 * rows>(at.D, D);
  gather<rows>(at.lambda, lambda);
  force = torque = Vec3<Pack>::Zero();
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r) {
    LINKWORK_UNROLL for (int k = 0; k < 3; ++k) {
      force[k] += lambda[r] * D[6 * r + k];
      torque[k] += lambda[r] * D[6 * r + 3 + k];
    }
  }
}

/// The last joint may be found more than once, with the same numbers.
template <int rows>
void find(const JointArrays& joints, const double* D, const double* q, const double* lambda, double* force,
          double* torque) {
  for (int first = 0; first < joints.count; first += width) {
    const Places at = places_of(joints, first, rows, D, q, lambda, force, torque);
    Vec3<Pack> F, T_in_body;
    sum_rows<rows>(at, F, T_in_body);
    Pack position[7];
    gather<7>(at.q, position);
    const Mat3<Pack> A = rotation_matrix<Pack>(Vec4<Pack>(position[3], position[4], position[5], position[6]));
    const AttachmentPart& part = joints.attachment[1];
    const double* numbers = part.from + part.step * (joints.first + first);
    Vec3<Pack> s_j;
    for (int k = 0; k < 3; ++k) s_j[k].v = load_native(numbers + k * width);
    const Vec3<Pack> turned = A * s_j;
    const Mask grounded = Pack(0.0) > at.sign;
    Vec3<Pack> arm;
    for (int k = 0; k < 3; ++k) arm[k] = select(grounded, s_j[k] - position[k], turned[k]);
    const Vec3<Pack> T = A * T_in_body - arm.cross(F);
    const Vec3<Pack> signed_F = at.sign * F, signed_T = at.sign * T;
    scatter<3>(signed_F.data(), at.force);
    scatter<3>(signed_T.data(), at.torque);
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

namespace linkwork {

#define LINKWORK_JOINT_REACTIONS \
  void joint_reactions(const JointArrays&, int, const double*, const double*, const double*, double*, double*)
namespace v2 {
LINKWORK_JOINT_REACTIONS;
}
#if LINKWORK_X86
namespace v3 {
LINKWORK_JOINT_REACTIONS;
}
namespace v4 {
LINKWORK_JOINT_REACTIONS;
}
#endif

JointReactions joint_reactions(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return &v4::joint_reactions;
  if (instructions.level == 1) return &v3::joint_reactions;
#endif
  static_cast<void>(instructions);
  return &v2::joint_reactions;
}

}  // namespace linkwork

#endif
