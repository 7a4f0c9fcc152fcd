// Compiled once per instruction set and, without LINKWORK_ISA, for the choice among them.
#include "linkwork/assembly/body_forces.hpp"

#if defined(LINKWORK_ISA)

#include "linkwork/math/pack.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork {

using simd::LINKWORK_ISA::Pack;

namespace LINKWORK_ISA {

double body_forces(int count, const MassBlock* mass, const double* gravity, const double* q, const double* v,
                   double* g) {
  using namespace simd::LINKWORK_ISA;
  const Vec3<Pack> down{Pack(gravity[0]), Pack(gravity[1]), Pack(gravity[2])};
  constexpr int sums = 8;  // the same order of summation whatever the width
  double partial[sums] = {};
  for (int first = 0; first < count; first += width) {
    const int used = count - first < width ? count - first : width;
    const double *masses[width], *positions[width], *velocities[width];
    double* out[width];
    for (int l = 0; l < width; ++l) {
      const long body = first + (l < used ? l : used - 1);
      masses[l] = &mass[body].m;
      positions[l] = q + 7 * body;
      velocities[l] = v + 6 * body;
      out[l] = g + 6 * body;
    }
    Pack M[10], r[3], velocity[6], force[6];
    gather<10>(masses, M);
    gather<3>(positions, r);
    gather<6>(velocities, velocity);
    const Vec3<Pack> omega(velocity[3], velocity[4], velocity[5]), position(r[0], r[1], r[2]);
    Vec3<Pack> momentum;
    for (int k = 0; k < 3; ++k)
      momentum[k] = M[1 + 3 * k] * omega[0] + M[2 + 3 * k] * omega[1] + M[3 + 3 * k] * omega[2];
    const Vec3<Pack> weight = M[0] * down, torque = momentum.cross(omega);
    for (int k = 0; k < 3; ++k) {
      force[k] = weight[k];
      force[3 + k] = torque[k];
    }
    scatter<6>(force, out);  // the last body more than once, with the same numbers
    const Pack potential = weight.dot(position);
    for (int l = 0; l < used; ++l) partial[(first + l) % sums] -= potential.v[l];
  }
  double total = 0.0;
  for (const double part : partial) total += part;
  return total;
}

}  // namespace LINKWORK_ISA
}  // namespace linkwork

#else

#include "linkwork/math/choice_by_instruction_set.hpp"

namespace linkwork {

LINKWORK_CHOOSE_BY_INSTRUCTION_SET(BodyForces, body_forces)

}  // namespace linkwork

#endif
