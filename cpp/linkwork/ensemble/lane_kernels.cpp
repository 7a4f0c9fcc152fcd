// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/assembly/saddle_products.hpp"
#include "linkwork/ensemble/lane_elimination.hpp"
#include "linkwork/math/pack.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

template <int count>
LINKWORK_INLINE Eigen::Matrix<Pack, count, 1> get_vector(const double* from, std::ptrdiff_t k) {
  Eigen::Matrix<Pack, count, 1> out;
  LINKWORK_UNROLL for (int c = 0; c < count; ++c)
    out[c].v = get(from, k + c);
  return out;
}
template <class Vector>
LINKWORK_INLINE void put_vector(double* to, std::ptrdiff_t k, const Vector& x) {
  constexpr int count = Vector::SizeAtCompileTime;
  LINKWORK_UNROLL for (int c = 0; c < count; ++c)
    put(to, k + c, x.data()[c].v);
}

void states(int bodies, const double* y, double* out) {
  for (long body = 0; body <= bodies; ++body) {
    const bool ground = body == bodies;
    Vec3<Pack> r = Vec3<Pack>::Zero();
    Vec4<Pack> p(Pack(1.0), Pack(0.0), Pack(0.0), Pack(0.0));
    Eigen::Matrix<Pack, 6, 1> v = Eigen::Matrix<Pack, 6, 1>::Zero();
    if (!ground) {
      r = get_vector<3>(y, 7 * body);
      p = get_vector<4>(y, 7 * body + 3);
      v = get_vector<6>(y, 7l * bodies + 6 * body);
    }
    put_vector(out, 18 * body, r);
    put_vector(out, 18 * body + 3, rotation_matrix<Pack>(p));
    put_vector(out, 18 * body + 12, v);
  }
}

/// Of the sums of a chunk of bodies, which begin anew.
LINKWORK_INLINE Native sum_up(Native (&partial)[8]) {
  Native total{};
  for (Native& part : partial) {
    total += part;
    part = Native{};
  }
  return total;
}

// In the order of operations of assembly/body_forces.cpp.
void body_forces(int bodies, const double* mass, const double* gravity, const double* y, double* g, double* potential) {
  constexpr long sums = 8, chunk = 4096;  // of System
  const Vec3<Pack> down = get_vector<3>(gravity, 0);
  Native partial[sums]{}, total{};
  for (long body = 0; body < bodies; ++body) {
    if (body > 0 && body % chunk == 0) total += sum_up(partial);
    const Vec3<Pack> omega = get_vector<3>(y, 7l * bodies + 6 * body + 3);
    const auto M = get_vector<10>(mass, 10 * body);
    Vec3<Pack> momentum;
    for (int k = 0; k < 3; ++k)
      momentum[k] = M[1 + 3 * k] * omega[0] + M[2 + 3 * k] * omega[1] + M[3 + 3 * k] * omega[2];
    const Vec3<Pack> weight = M[0] * down;
    put_vector(g, 6 * body, weight);
    put_vector(g, 6 * body + 3, Vec3<Pack>(momentum.cross(omega)));
    partial[body % sums] -= weight.dot(get_vector<3>(y, 7 * body)).v;
  }
  put(potential, 0, total + sum_up(partial));
}

void inertia_forces(const ConstraintBlock* blocks, std::ptrdiff_t count, int first, const double* inertance,
                    const double* gamma, const double* D, double* g) {
  for (const ConstraintBlock* block = blocks; block < blocks + count; ++block) {
    const Native force = get(inertance, block->row - first) * get(gamma, block->row - first);
    for (int k = 0; k < 6; ++k)
      put(g, 6l * block->body + k, get(g, 6l * block->body + k) + force * get(D, block->offset + k));
  }
}

// In the order of operations of System::multiply_inverse_mass.
void accelerate_freely(int bodies, const double* inverse_mass, const double* a, double* x) {
  for (long body = 0; body < bodies; ++body) {
    const auto inverse = get_vector<10>(inverse_mass, 10 * body);
    const auto from = get_vector<6>(a, 6 * body);
    Eigen::Matrix<Pack, 6, 1> to;
    for (int k = 0; k < 3; ++k) {
      const auto row = inverse.segment<3>(1 + 3 * k);
      to[k] = inverse[0] * from[k];
      to[3 + k] = row[0] * from[3] + row[1] * from[4] + row[2] * from[5];
    }
    put_vector(x, 6 * body, to);
  }
}

void rates(int bodies, const double* y, const double* v_dot, double* y_dot) {
  const long q_size = 7l * bodies;
  for (long body = 0; body < bodies; ++body) {
    put_vector(y_dot, 7 * body, get_vector<3>(y, q_size + 6 * body));
    put_vector(y_dot, 7 * body + 3,
               euler_parameter_rates<Pack>(get_vector<4>(y, 7 * body + 3), get_vector<3>(y, q_size + 6 * body + 3)));
    put_vector(y_dot, q_size + 6 * body, get_vector<6>(v_dot, 6 * body));
  }
}

// In the order in which Eigen sums four squares, two at a time.
void normalize(int bodies, double* y) {
  for (long body = 0; body < bodies; ++body) {
    Vec4<Pack> p = get_vector<4>(y, 7 * body + 3);
    const Pack square = (p[0] * p[0] + p[2] * p[2]) + (p[1] * p[1] + p[3] * p[3]), length = sqrt(square);
    for (int k = 0; k < 4; ++k) {
      const Native unit = p[k].v / length.v;
      put(y, 7 * body + 3 + k, square.v > Native{} ? unit : p[k].v);
    }
  }
}

template <int terms>
LINKWORK_INLINE void combine_some(int count, const double* y, const double* factors, const double* const* x,
                                  double* out) {
  Native f[terms];
  const double* from[terms];
  LINKWORK_UNROLL for (int term = 0; term < terms; ++term) {
    f[term] = get(factors, term);
    from[term] = x[term];
  }
  for (int k = 0; k < count; ++k) {
    Native sum = get(y, k);
    LINKWORK_UNROLL for (int term = 0; term < terms; ++term)
      sum += f[term] * get(from[term], k);
    put(out, k, sum);
  }
}

/// Some terms at a time, whose factors stay in registers.
void combine(int count, const double* y, int terms, const double* factors, const double* const* x, double* out) {
  constexpr int most = 4;
  if (terms == 0)
    for (int k = 0; k < count; ++k) put(out, k, get(y, k));
  for (; terms > 0; terms -= most, factors += most * width, x += most, y = out)
    with_count<most>(terms < most ? terms : most, [&](auto some) { combine_some<some>(count, y, factors, x, out); });
}

void weigh(int count, const double* f, const double* x, const double* g, const double* z, double* out) {
  for (int k = 0; k < count; ++k) put(out, k, get(f, 0) * get(x, k) + get(g, 0) * get(z, k));
}

void largest(int count, const double* x, double* out) {
  Native most{}, doubtful{};
  for (int k = 0; k < count; ++k) {
    const Native value = get(x, k), size = value < Native{} ? -value : value;
    most = size > most ? size : most;
    doubtful += value - value;  // not zero of what is not finite
  }
  put(out, 0, doubtful == Native{} ? most : splat_native(__builtin_inf()));
}

struct LanesWithRoots : Lanes {
  static LINKWORK_INLINE Native root(Native x) { return sqrt(Pack(x)).v; }
};

/// y += sum b d^T d x.
void add_inerters(const LaneEquations& at, const double* x, double* y) {
  const ConstraintBlock *end = at.inerters + at.inerter_count, *next = at.inerters;
  for (const double* inertance = at.inertance; next < end; inertance += width) {
    const ConstraintBlock* first = next;
    Native rate{};
    for (; next < end && next->row == first->row; ++next)
      for (int k = 0; k < 6; ++k) rate += get(at.D, next->offset + k) * get(x, 6l * next->body + k);
    const Native factor = get(inertance, 0) * rate;
    for (const ConstraintBlock* part = first; part < next; ++part)
      for (int k = 0; k < 6; ++k)
        put(y, 6l * part->body + k, get(y, 6l * part->body + k) + factor * get(at.D, part->offset + k));
  }
}

void residuals(const LaneEquations& at, const double* a, const double* b, const double* x, const double* lambda,
               double* r_1, double* r_2) {
  for (int body = 0; body < at.bodies; ++body) saddle_products::multiply_mass<LanesWithRoots>(body, at.mass, x, r_1);
  add_inerters(at, x, r_1);
  for (int k = 0; k < 6 * at.bodies; ++k) put(r_1, k, get(a, k) - get(r_1, k));
  for (int k = 0; k < at.rows; ++k) put(r_2, k, Native{});
  for (const ConstraintBlock* block = at.blocks; block < at.blocks + at.block_count; ++block) {
    saddle_products::add_D_transposed<LanesWithRoots>(*block, at.D, lambda, r_1);
    saddle_products::add_D<LanesWithRoots>(*block, at.D, x, r_2);
  }
  for (int k = 0; k < at.rows; ++k) put(r_2, k, get(b, k) - get(r_2, k));
  if (!at.compliance) return;
  for (int k = 0; k < at.rows; ++k) put(r_2, k, get(r_2, k) - get(at.compliance, k) * get(lambda, k));
}

void motion(const LaneEquations& at, const double* x, double* out) {
  for (int k = 0; k < at.component_count; ++k) put(out, k, Native{});
  for (int body = 0; body < at.bodies; ++body) {
    const int k = at.components[body];
    const Native size = saddle_products::size<LanesWithRoots>(body, at.lengths, x), most = get(out, k);
    put(out, k, size - size == Native{} ? (most < size ? size : most) : splat_native(__builtin_inf()));
  }
}

void free_motion(const LaneEquations& at, const double* of_heaviest, const double* a, double* scratch, double* out) {
  double *forces = scratch, *masses = scratch + std::ptrdiff_t{width} * at.component_count;
  for (int k = 0; k < at.component_count; ++k)
    for (double* list : {forces, masses, out}) put(list, k, Native{});
  for (int body = 0; body < at.bodies; ++body) {
    const int k = at.components[body];
    const Native m = saddle_products::mass_of<LanesWithRoots>(body, at.mass);
    const Native size = saddle_products::size_of_forces<LanesWithRoots>(body, at.lengths, a);
    const Native most = get(out, k), force = get(forces, k), mass = get(masses, k);
    put(out, k, ((m > Native{}) & (most < size / m)) ? size / m : most);
    put(forces, k, force < size ? size : force);
    put(masses, k, mass < m ? m : mass);
  }
  for (int k = 0; k < at.component_count; ++k) {
    const Native mass = get(masses, k), by_heaviest = mass > Native{} ? get(forces, k) / mass : Native{};
    put(out, k, get(of_heaviest, 0) == Native{} ? get(out, k) : by_heaviest);
  }
}

void add(int count, const double* chosen, const double* dx, double* x) {
  const NativeIndex mask = get(chosen, 0) != Native{};
  for (int k = 0; k < count; ++k) put(x, k, mask ? get(x, k) + get(dx, k) : get(x, k));
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(lane_kernels_, ISA)

extern const LaneKernels LINKWORK_NAME(LINKWORK_ISA);
const LaneKernels LINKWORK_NAME(LINKWORK_ISA) = {
    width,  &states,  &body_forces, &inertia_forces, &accelerate_freely, &rates, &normalize, &combine,
    &weigh, &largest, &residuals,   &motion,         &free_motion,       &add};

}  // namespace linkwork
