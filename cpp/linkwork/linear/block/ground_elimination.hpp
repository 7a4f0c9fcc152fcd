#pragma once

#include <cstddef>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/math/simd.hpp"

/// Bodies on a joint on the ground that leaves them one motion, a hinge or a slider, number by number in one order of
/// operations, for deterministic runs, for ensembles and in closed loops, where `Access` reads and writes numbers of
/// all lanes.
///
/// With the row of that motion behind its own, D of the joint is square, with the inverse (G_c, g): x = G_c b + g u,
/// and lambda = G_c^T (M x - a - f), where f is what the loops exert on the body. For the loops it is a body with the
/// mobility g g^T / n, n = g^T M g, and the acceleration `alone` without them.
namespace linkwork::block {
namespace {

constexpr double least_size = 0.01;  // of det^2: rows have length 1 where the joint is not violated

/// out = a x b.
template <class Number>
LINKWORK_INLINE void cross(const Number* a, const Number* b, Number* out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

template <class Number>
LINKWORK_INLINE Number dot(const Number* a, const Number* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Rows x, y of unit length and the one across: the columns of the inverse of the three, and det = |x x y|^2.
template <class Number>
LINKWORK_INLINE Number invert_pair(const Number* x, const Number* y, Number (*inverse)[3]) {
  Number across[3];
  cross(x, y, across);
  const Number determinant = dot(across, across), factor = 1.0 / determinant;
  cross(y, across, inverse[0]);
  cross(across, x, inverse[1]);
  LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
    inverse[0][m] = inverse[0][m] * factor;
    inverse[1][m] = inverse[1][m] * factor;
    inverse[2][m] = across[m] * factor;
  }
  return determinant;
}

/// Where the numbers of such a body are, each from its first one on.
struct GroundPlaces {
  const double* D;
  const double* articulated_inertia;  ///< none of a body that has only its own mass
  const double *mass, *a;             ///< of the body
  double* factors;
};

/// Three rows (s I, K), then two (0, R).
template <class Access>
struct HingeOnGround {
  using Number = typename Access::Number;
  static constexpr int kept = 6;

  /// The columns of R^-1, the last one the axis.
  LINKWORK_INLINE Number read(const double* D, const double* b, Number* right, Number* free) {
    Number x[3], y[3];
    LINKWORK_UNROLL for (int k = 0; k < 3; ++k) {
      x[k] = Access::get(D, 6 * 3 + 3 + k);
      y[k] = Access::get(D, 6 * 4 + 3 + k);
    }
    const Number determinant = invert_pair(x, y, inverse_), s = Access::get(D, 0);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      right[3 + m] = Access::get(b, 3) * inverse_[0][m] + Access::get(b, 4) * inverse_[1][m];
      free[3 + m] = inverse_[2][m];
    }
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      const auto turned = [&](const Number* column) {
        return Access::get(D, 6 * r + 3) * column[3] + Access::get(D, 6 * r + 4) * column[4] +
               Access::get(D, 6 * r + 5) * column[5];
      };
      right[r] = s * (Access::get(b, r) - turned(right));
      free[r] = -(s * turned(free));
    }
    return determinant * determinant;
  }

  LINKWORK_INLINE void keep(double* factors) const {
    LINKWORK_UNROLL for (int c = 0; c < 2; ++c) LINKWORK_UNROLL
      for (int m = 0; m < 3; ++m) Access::put(factors, 3 * c + m, inverse_[c][m]);
  }

  /// lambda from the forces and the moments `rest` of the joint.
  static LINKWORK_INLINE void find_multipliers(const double* D, const double* factors, Number* rest, double* lambda) {
    const Number s = Access::get(D, 0);
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      rest[r] = s * rest[r];
      Access::put(lambda, r, rest[r]);
    }
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      const auto K = [&](int r) { return Access::get(D, 6 * r + 3 + m); };
      rest[3 + m] -= K(0) * rest[0] + K(1) * rest[1] + K(2) * rest[2];
    }
    LINKWORK_UNROLL for (int c = 0; c < 2; ++c) {
      const auto inverse = [&](int m) { return Access::get(factors, 3 * c + m); };
      Access::put(lambda, 3 + c, inverse(0) * rest[3] + inverse(1) * rest[4] + inverse(2) * rest[5]);
    }
  }

 private:
  Number inverse_[3][3];
};

/// Two rows (T, C), then three (0, R).
template <class Access>
struct SliderOnGround {
  using Number = typename Access::Number;
  static constexpr int kept = 15;

  LINKWORK_INLINE Number read(const double* D, const double* b, Number* right, Number* free) {
    const Number size = read_rows(D);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      right[3 + m] =
          Access::get(b, 2) * turns_[0][m] + Access::get(b, 3) * turns_[1][m] + Access::get(b, 4) * turns_[2][m];
      free[m] = shifts_[2][m];
      free[3 + m] = Number{};
    }
    Number rest[2];
    LINKWORK_UNROLL for (int r = 0; r < 2; ++r)
      rest[r] = Access::get(b, r) - (Access::get(D, 6 * r + 3) * right[3] + Access::get(D, 6 * r + 4) * right[4] +
                                     Access::get(D, 6 * r + 5) * right[5]);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      right[m] = rest[0] * shifts_[0][m] + rest[1] * shifts_[1][m];
    return size;
  }

  LINKWORK_INLINE void keep(double* factors) const {
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      LINKWORK_UNROLL for (int c = 0; c < 2; ++c)
        Access::put(factors, 3 * c + m, shifts_[c][m]);
      LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
        Access::put(factors, 6 + 3 * c + m, turns_[c][m]);
    }
  }

  static LINKWORK_INLINE void find_multipliers(const double* D, const double* factors, Number* rest, double* lambda) {
    const auto product = [&](int place, const Number* force) {
      return Access::get(factors, place) * force[0] + Access::get(factors, place + 1) * force[1] +
             Access::get(factors, place + 2) * force[2];
    };
    Number l[2];
    LINKWORK_UNROLL for (int c = 0; c < 2; ++c) {
      l[c] = product(3 * c, rest);
      Access::put(lambda, c, l[c]);
    }
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      rest[3 + m] -= Access::get(D, 3 + m) * l[0] + Access::get(D, 6 + 3 + m) * l[1];
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
      Access::put(lambda, 2 + c, product(6 + 3 * c, rest + 3));
  }

 private:
  /// The columns of the inverses of T, with the axis across, and of R; the product of the squares of their determinants.
  LINKWORK_INLINE Number read_rows(const double* D) {
    Number t[2][3], r[3][3];
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      LINKWORK_UNROLL for (int k = 0; k < 2; ++k)
        t[k][m] = Access::get(D, 6 * k + m);
      LINKWORK_UNROLL for (int k = 0; k < 3; ++k)
        r[k][m] = Access::get(D, 6 * (2 + k) + 3 + m);
    }
    const Number shifts = invert_pair(t[0], t[1], shifts_);
    cross(r[1], r[2], turns_[0]);
    cross(r[2], r[0], turns_[1]);
    cross(r[0], r[1], turns_[2]);
    const Number determinant = dot(r[0], turns_[0]), factor = 1.0 / determinant;
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c) LINKWORK_UNROLL
      for (int m = 0; m < 3; ++m) turns_[c][m] = turns_[c][m] * factor;
    return (shifts * shifts) * (determinant * determinant);
  }

  Number shifts_[3][3], turns_[3][3];
};

/// What such a body is to loops.
template <class Number>
struct Grounded {
  Number direction[6];  ///< g
  Number alone[6];      ///< its acceleration without them
  Number mobility;      ///< 1/n
};

template <class Access, template <class> class Joint>
class GroundElimination {
 public:
  using Number = typename Access::Number;

  LINKWORK_INLINE explicit GroundElimination(const GroundPlaces& places) : at_(places) {}

  /// What the joint says; returns the square of a determinant, below which the form is of no use when it is small.
  LINKWORK_INLINE Number read(const double* b) { return joint_.read(at_.D, b, right_, free_); }

  /// What follows for u; returns n.
  LINKWORK_INLINE Number release() {
    Number forced[6], freed[6];  // M x - a of the two
    multiply(right_, forced);
    multiply(free_, freed);
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      forced[r] -= force(r);
    Number n = free_[0] * freed[0], sum = free_[0] * forced[0];
    LINKWORK_UNROLL for (int k = 1; k < 6; ++k) {
      n += free_[k] * freed[k];
      sum += free_[k] * forced[k];
    }
    mobility_ = 1.0 / n;
    u_ = -(sum * mobility_);
    return n;
  }

  LINKWORK_INLINE Grounded<Number> grounded() const {
    Grounded<Number> out{{}, {}, mobility_};
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
      out.direction[r] = free_[r];
      out.alone[r] = alone(r);
    }
    return out;
  }

  LINKWORK_INLINE void store_way_back() const {
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
      Access::put(at_.factors, r, alone(r));
      Access::put(at_.factors, 6 + r, free_[r]);
      Access::put(at_.factors, of_force + r, force(r));
    }
    Access::put(at_.factors, of_mobility, mobility_);
    joint_.keep(at_.factors + of_joint * Access::stride);
    if (!at_.articulated_inertia) return;
    int place = of_inertia;
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
      for (int r = c; r < 6; ++r) Access::put(at_.factors, place++, M(c, r));
  }

  /// x and lambda, where the joints of loops exert these forces on the body.
  LINKWORK_INLINE void go_back(const Number* forces, double* x, double* lambda) const {
    const auto free = [&](int r) { return Access::get(at_.factors, 6 + r); };
    Number sum = free(0) * forces[0], moved[6], rest[6];
    LINKWORK_UNROLL for (int r = 1; r < 6; ++r)
      sum += free(r) * forces[r];
    const Number u = Access::get(at_.factors, of_mobility) * sum;
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
      moved[r] = Access::get(at_.factors, r) + free(r) * u;
      Access::put(x, r, moved[r]);
    }
    find_rest(moved, forces, rest);
    Joint<Access>::find_multipliers(at_.D, at_.factors + of_joint * Access::stride, rest, lambda);
  }

 private:
  static constexpr int of_mobility = 12, of_force = 13, of_inertia = of_force + 6, of_joint = of_inertia + 21;
  static_assert(of_joint + Joint<Access>::kept < step_storage(5));

  LINKWORK_INLINE Number alone(int r) const { return right_[r] + free_[r] * u_; }
  LINKWORK_INLINE Number J(int r, int c) const { return Access::get(at_.mass, 1 + 3 * r + c); }
  /// r >= c.
  LINKWORK_INLINE Number M(int c, int r) const { return Access::get(at_.articulated_inertia, 8 * c + r); }
  LINKWORK_INLINE Number force(int k) const {
    return at_.articulated_inertia ? Access::get(at_.articulated_inertia, 8 * k + right_hand_side)
                                   : Access::get(at_.a, k);
  }

  LINKWORK_INLINE void multiply(const Number* x, Number* out) const {
    if (!at_.articulated_inertia) return multiply_by_own(x, out);
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
      out[r] = M(0, r) * x[0];
      LINKWORK_UNROLL for (int k = 1; k < 6; ++k)
        out[r] += (k < r ? M(k, r) : M(r, k)) * x[k];
    }
  }
  /// Of a body without branches.
  LINKWORK_INLINE void multiply_by_own(const Number* x, Number* out) const {
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      out[r] = Access::get(at_.mass, 0) * x[r];
      out[3 + r] = J(r, 0) * x[3] + J(r, 1) * x[4] + J(r, 2) * x[5];
    }
  }

  /// M x - a - forces.
  LINKWORK_INLINE void find_rest(const Number* x, const Number* forces, Number* rest) const {
    const auto given = [&](int r) { return Access::get(at_.factors, of_force + r) + forces[r]; };
    if (!at_.articulated_inertia) {
      multiply_by_own(x, rest);
      LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
        rest[r] -= given(r);
      return;
    }
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      rest[r] = -given(r);
    int place = of_inertia;
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
      LINKWORK_UNROLL for (int r = c; r < 6; ++r) {
        const Number M = Access::get(at_.factors, place++);
        rest[r] += M * x[c];
        if (r != c) rest[c] += M * x[r];
      }
    }
  }

  const GroundPlaces at_;
  Joint<Access> joint_;
  Number right_[6], free_[6], mobility_, u_;
};

}  // namespace
}  // namespace linkwork::block
