#pragma once

#include <cstddef>

#include "linkwork/linear/block/ground_elimination.hpp"

/// Bodies of open branches on a hinge on another body, without an inerter, number by number: the equations of
/// turning_kernels.hpp in one order of operations, for deterministic runs and for ensembles, where `Access` reads and
/// writes numbers of all lanes.
///
/// Of X are kept the columns that are no constants: those of the parent's rotation, of the right-hand side, and g_f.
/// The way back finds lambda from M_b x_b - a_b, which takes fewer operations than rows for it.
namespace linkwork::block {
namespace {

/// Where the numbers of a step are, each from its first one on.
struct HingePlaces {
  const double *D_body, *D_parent;
  const double* articulated_inertia;  ///< none of a body that has only its own mass
  const double *mass, *a;             ///< of the body
  double* factors;
};

template <class Access>
class HingeElimination {
 public:
  using Number = typename Access::Number;

  LINKWORK_INLINE explicit HingeElimination(const HingePlaces& places) : at_(places) {}

  /// What the joint says; returns the square of the determinant of R, below which the form is of no use when it is small.
  LINKWORK_INLINE Number read(const double* b) {
    const Number determinant = invert();
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
        X_[3 + m][c] = Z(3, c) * R_inverse_[0][m] + Z(4, c) * R_inverse_[1][m];
      X_[3 + m][right] = get(b, 3) * R_inverse_[0][m] + get(b, 4) * R_inverse_[1][m];
      X_[3 + m][free] = R_inverse_[2][m];
    }
    const Number s = get(at_.D_body, 0);
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      LINKWORK_UNROLL for (int c = 0; c < columns; ++c) {
        const Number turned = K(r, 0) * X_[3][c] + K(r, 1) * X_[4][c] + K(r, 2) * X_[5][c];
        if (c == free) X_[r][c] = -(s * turned);
        else X_[r][c] = s * ((c == right ? get(b, r) : Z(r, c)) - turned);
      }
    }
    return determinant * determinant;
  }

  /// W = M_b X - (0, a_b) and what follows of it for u_f; returns d.
  LINKWORK_INLINE Number release() {
    if (at_.articulated_inertia) multiply_by_inertia();
    else multiply_by_mass();
    Number n = X_[0][free] * W_[0][free];
    r_[6] = X_[0][free] * W_[0][right];
    LINKWORK_UNROLL for (int k = 1; k < 6; ++k) {
      n += X_[k][free] * W_[k][free];
      r_[6] += X_[k][free] * W_[k][right];
    }
    const Number inverse = 1.0 / n;
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c) {
      r_[c] = -W_[c][free];
      r_[3 + c] = product(c, free);
    }
    LINKWORK_UNROLL for (int c = 0; c < 7; ++c)
      t_[c] = -(r_[c] * inverse);
    return n;
  }

  /// Number r of column c of [M_p; a_p], r >= c, what is added to it.
  LINKWORK_INLINE Number parent(int c, int r) const {
    const Number through_u = r_[c] * t_[r];
    if (c >= 3) return product(c - 3, r == 6 ? right : r - 3) + through_u;
    if (r == 6) return through_u - W_[c][right];
    if (r >= 3) return through_u - W_[c][r - 3];
    return M_[c][r] + through_u;
  }

  LINKWORK_INLINE void store_way_back() const {
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) LINKWORK_UNROLL
      for (int c = 0; c < columns; ++c) put(at_.factors, columns * r + c, X_[r][c]);
    LINKWORK_UNROLL for (int c = 0; c < 7; ++c)
      put(at_.factors, of_t + c, t_[c]);
    LINKWORK_UNROLL for (int c = 0; c < 2; ++c) LINKWORK_UNROLL
      for (int m = 0; m < 3; ++m) put(at_.factors, of_R_inverse + 3 * c + m, R_inverse_[c][m]);
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      put(at_.factors, of_force + c, force(c));
    if (!at_.articulated_inertia) return;
    int place = of_inertia;
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
      for (int r = c; r < 6; ++r) put(at_.factors, place++, M_[c][r]);
  }

  /// x of the body from that of its parent, and lambda.
  LINKWORK_INLINE void go_back(const double* x_parent, double* x, double* lambda) {
    Number u = get(at_.factors, of_t + 6), moved[6], rest[6];
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      u -= get(at_.factors, of_t + c) * get(x_parent, c);
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
      moved[r] = get(at_.factors, columns * r + right) + get(at_.factors, columns * r + free) * u;
      if (r < 3) moved[r] += get(x_parent, r);
      LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
        moved[r] -= get(at_.factors, columns * r + c) * get(x_parent, 3 + c);
    }
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      put(x, r, moved[r]);
    find_rest(moved, rest);
    const Number s = get(at_.D_body, 0);
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      rest[r] = s * rest[r];
      put(lambda, r, rest[r]);
    }
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      rest[3 + m] -= K(0, m) * rest[0] + K(1, m) * rest[1] + K(2, m) * rest[2];
    LINKWORK_UNROLL for (int c = 0; c < 2; ++c) {
      const auto inverse = [&](int m) { return get(at_.factors, of_R_inverse + 3 * c + m); };
      put(lambda, 3 + c, inverse(0) * rest[3] + inverse(1) * rest[4] + inverse(2) * rest[5]);
    }
  }

 private:
  static constexpr int right = 3, free = 4, columns = 5;  // of X, behind those of the parent's rotation
  static constexpr int of_t = 6 * columns, of_R_inverse = of_t + 7, of_force = of_R_inverse + 6;
  static constexpr int of_inertia = of_force + 6, size = of_inertia + 21;
  static_assert(size < step_storage(5));

  static LINKWORK_INLINE Number get(const double* from, std::ptrdiff_t k) { return Access::get(from, k); }
  static LINKWORK_INLINE void put(double* to, std::ptrdiff_t k, Number x) { Access::put(to, k, x); }

  LINKWORK_INLINE Number K(int r, int c) const { return get(at_.D_body, 6 * r + 3 + c); }  ///< times s
  LINKWORK_INLINE Number Z(int r, int c) const { return get(at_.D_parent, 6 * r + 3 + c); }
  LINKWORK_INLINE Number J(int r, int c) const { return get(at_.mass, 1 + 3 * r + c); }
  LINKWORK_INLINE Number force(int k) const {
    return at_.articulated_inertia ? get(at_.articulated_inertia, 8 * k + right_hand_side) : get(at_.a, k);
  }

  /// The columns of R^-1 are the products of two rows of R, over the determinant, which is returned.
  LINKWORK_INLINE Number invert() {
    Number x[3], y[3];
    LINKWORK_UNROLL for (int k = 0; k < 3; ++k) {
      x[k] = K(3, k);
      y[k] = K(4, k);
    }
    return invert_pair(x, y, R_inverse_);
  }

  LINKWORK_INLINE void multiply_by_inertia() {
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
      for (int r = c; r < 6; ++r) M_[c][r] = get(at_.articulated_inertia, 8 * c + r);
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c) LINKWORK_UNROLL
      for (int r = 0; r < 6; ++r) {
        Number sum = M_[0][r] * X_[0][c];
        LINKWORK_UNROLL for (int k = 1; k < 6; ++k)
          sum += (k < r ? M_[k][r] : M_[r][k]) * X_[k][c];
        if (c == right) sum -= force(r);
        W_[r][c] = sum;
      }
  }

  /// Of a body without branches.
  LINKWORK_INLINE void multiply_by_mass() {
    const Number m = get(at_.mass, 0);
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c) LINKWORK_UNROLL
      for (int r = c; r < 3; ++r) M_[c][r] = r == c ? m : Number{};
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c) LINKWORK_UNROLL
      for (int r = 0; r < 3; ++r) {
        W_[r][c] = m * X_[r][c];
        W_[3 + r][c] = J(r, 0) * X_[3][c] + J(r, 1) * X_[4][c] + J(r, 2) * X_[5][c];
        if (c != right) continue;
        W_[r][c] -= force(r);
        W_[3 + r][c] -= force(3 + r);
      }
  }

  /// Of a column of X, of the parent's rotation, and one of W.
  LINKWORK_INLINE Number product(int c, int of_W) const {
    Number sum = X_[0][c] * W_[0][of_W];
    LINKWORK_UNROLL for (int k = 1; k < 6; ++k)
      sum += X_[k][c] * W_[k][of_W];
    return sum;
  }

  /// M_b x - a_b.
  LINKWORK_INLINE void find_rest(const Number* x, Number* rest) const {
    if (!at_.articulated_inertia) {
      LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
        rest[r] = get(at_.mass, 0) * x[r] - get(at_.factors, of_force + r);
        rest[3 + r] = J(r, 0) * x[3] + J(r, 1) * x[4] + J(r, 2) * x[5] - get(at_.factors, of_force + 3 + r);
      }
      return;
    }
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      rest[r] = -get(at_.factors, of_force + r);
    int place = of_inertia;
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
      LINKWORK_UNROLL for (int r = c; r < 6; ++r) {
        const Number M = get(at_.factors, place++);
        rest[r] += M * x[c];
        if (r != c) rest[c] += M * x[r];
      }
    }
  }

  const HingePlaces at_;
  Number R_inverse_[3][3];  ///< columns
  Number X_[6][columns], W_[6][columns], M_[6][6], r_[7], t_[7];
};

}  // namespace
}  // namespace linkwork::block
