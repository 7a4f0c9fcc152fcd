// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/ensemble/lane_speeds.hpp"

#include "linkwork/ensemble/lane_elimination.hpp"
#include "linkwork/math/pack.hpp"

namespace linkwork {
namespace {

struct Three {
  Native x, y, z;

  static LINKWORK_INLINE Three of(const double* from, std::ptrdiff_t k) {
    return {get(from, k), get(from, k + 1), get(from, k + 2)};
  }
  // In the order in which Eigen sums three products.
  friend LINKWORK_INLINE Native dot(const Three& a, const Three& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  LINKWORK_INLINE Native square() const { return dot(*this, *this); }
};

LINKWORK_INLINE Native larger(Native most, Native value) { return most < value ? value : most; }
LINKWORK_INLINE Native largest_component(Native most, const Three& a) {
  for (const Native& value : {a.x, a.y, a.z}) most = larger(most, value < Native{} ? -value : value);
  return most;
}

/// A vector without its part along an axis.
LINKWORK_INLINE Three without(const Three& a, const Three& axis) {
  const Native along = dot(axis, a);
  return {a.x - axis.x * along, a.y - axis.y * along, a.z - axis.z * along};
}

void speeds(int bodies, const double* in_loops, const double* rotors, const double* y, double* out) {
  Native component[2]{}, outside[2]{}, inside[2]{};  // linear, angular
  for (long body = 0; body < bodies; ++body) {
    const NativeIndex in_loop = get(in_loops, body) != Native{};
    for (int half = 0; half < 2; ++half) {
      Three v = Three::of(y, 7l * bodies + 6 * body + 3l * half);
      if (half == 1) v = without(v, Three::of(rotors, 3 * body));
      const Native square = v.square();
      component[half] = in_loop ? largest_component(component[half], v) : component[half];
      outside[half] = larger(outside[half], in_loop ? Native{} : square);
      inside[half] = larger(inside[half], in_loop ? square : Native{});
    }
  }
  for (int half = 0; half < 2; ++half) {
    put(out, half, component[half]);
    put(out, 2 + half, outside[half]);
    put(out, 4 + half, inside[half]);
  }
}

void kinetic_energy(int bodies, const double* mass, const double* y, double* out) {
  Native twice{};
  for (long body = 0; body < bodies; ++body) {
    const Three v = Three::of(y, 7l * bodies + 6 * body), omega = Three::of(y, 7l * bodies + 6 * body + 3);
    const auto row = [&](int k) { return dot(Three::of(mass, 10 * body + 1 + 3l * k), omega); };
    const Three momentum{row(0), row(1), row(2)};
    twice += get(mass, 10 * body) * v.square() + dot(omega, momentum);
  }
  put(out, 0, splat_native(0.5) * twice);
}

void look_at_rates(int bodies, int every, double h, const double* squared_length, const double* y, const double* y_new,
                   double* rates, double* out) {
  const Native per_second = splat_native(1.0 / h);
  Native sum{}, largest{};
  for (long body = 0; body < bodies; body += every) {
    Native rate_of[6], other[6];
    for (int k = 0; k < 6; ++k) {
      const std::ptrdiff_t v = 7l * bodies + 6 * body + k, own = 6 * body + k;
      const Native rate = rate_of[k] = (get(y_new, v) - get(y, v)) * per_second;
      other[k] = rate - get(rates, own);
      put(rates, own, rate);
    }
    const Three linear{other[0], other[1], other[2]}, angular{other[3], other[4], other[5]};
    sum += linear.square() + get(squared_length, 0) * angular.square();
    const Three acceleration{rate_of[0], rate_of[1], rate_of[2]}, spin{rate_of[3], rate_of[4], rate_of[5]};
    largest = larger(largest, acceleration.square() + get(squared_length, 0) * spin.square());
  }
  put(out, 0, sqrt(Pack(sum)).v);
  put(out, 1, sqrt(Pack(largest)).v);
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(lane_speeds_, ISA)

extern const LaneSpeeds LINKWORK_NAME(LINKWORK_ISA);
const LaneSpeeds LINKWORK_NAME(LINKWORK_ISA) = {&speeds, &kinetic_energy, &look_at_rates};

}  // namespace linkwork
