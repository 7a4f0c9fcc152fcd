#pragma once

#include "linkwork/linear/block/common_kernels.hpp"

/// Bodies of open branches on a hinge, with or without an inerter along its angle, or on a weld: as TreeStep, with one
/// division in the way to the root where the elimination row by row has as many as there are rows, six and those.
//
// With a row f for the freedom beside those of the joint, which is the inerter's where there is one, the rows of the
// body and of the parent are square. Those of translation are taken times the sign s that makes them
//   B = [I K; 0 R],   P = [-I K_p; 0 R_p],   G = B^-1 = [I -K R^-1; 0 R^-1].
// u = B x_b is what the joint prescribes, and u_f. With N = G^T M_b G, a' = G^T a_b, w = b - P x_p and the inertance
// beta along f, or 0,
//   N u - lambda = a',   u = w but for u_f,   lambda_f = beta (w_f - u_f).
// With d = N_ff + beta and h, which is column f of N but for h_f = -beta, that gives
//   u_f = (a'_f - h . w) / d,   lambda = C w - k,
//   C_c = N_c - h N_fc / d with 0 for N_fc in the first term,   C_f = N_f beta / d,
// and k likewise of the a' that stand behind the columns. Without a freedom C = N, k = a'. Along f nothing is a
// difference: what a free hinge does not carry is zero, and does not reach the parent. It gets
//   M_p += P^T C P,   a_p += P^T (C b - k).
// With y = (-x_p, 1) and Z = (P, b) the way back is u = Z y, but for u_f = z_f y, and lambda = C P (-x_p) + (C b - k).
namespace linkwork::block {
namespace {

template <int rows, bool scattered>
constexpr bool turns = width > 2 &&
                       (rows == 6 || (rows == 5 && !scattered));  // width 2: the path of deterministic runs

constexpr double least_determinant = 0.1;  // of R, whose rows have length 1 where the joint is not violated

/// Places of the factors of such a step: G Z, C P and C b - k, and s, or 0 where the factors are those of TreeStep.
template <int rows>
struct TurningFactors {
  static constexpr int motions = 0, transmissions = 6 * 7, multipliers = transmissions + 6 * rows;
  static constexpr int sign = multipliers + rows;
  static_assert(sign < step_storage(rows) && sign >= second_factors(rows) + 7 * rows);
};

/// Numbers of a vector one by one: from memory they reach all lanes without a permutation.
struct alignas(64) Numbers {
  double at[lanes];
  LINKWORK_INLINE Numbers() = default;
  LINKWORK_INLINE Numbers& operator=(const Vector& v) {
    store(at, v);
    keep();
    return *this;
  }
  LINKWORK_INLINE Vector operator[](int k) const { return splat(at[k]); }
  LINKWORK_INLINE void keep() { asm("" : "+m"(at)); }  // else compilers go back to permutations
};

constexpr double but_freedom[lanes] = {1, 1, 1, 1, 1, 0, 1, 1}, but_rotations[lanes] = {1, 1, 1, 0, 0, 0, 1, 0};

/// Where the rows of such a step stand: those of the joint one after the other, and that of the inerter.
template <int count, bool with_inerter>
struct RowsOfTurningStep {
  const TreeStep& step;
  const Data& data;

  LINKWORK_INLINE const double* D_body(int k) const {
    return data.D + (of_inerter(k) ? inerter().D_body : step.D_body + 6 * k);
  }
  LINKWORK_INLINE const double* D_parent(int k) const {
    return data.D + (of_inerter(k) ? inerter().D_parent : step.D_parent + 6 * k);
  }
  LINKWORK_INLINE int row(int k) const { return of_inerter(k) ? inerter().row : step.row + k; }
  /// Else those of the joint are fewer, and there are more inerters.
  LINKWORK_INLINE bool stand_so() const {
    return !with_inerter || data.step_rows[step.scattered + count - 2].D_body == step.D_body + 6 * (count - 2);
  }
  LINKWORK_INLINE const StepRow& inerter() const { return data.step_rows[step.scattered + count - 1]; }
  LINKWORK_INLINE static bool of_inerter(int k) { return with_inerter && k == count - 1; }
};

/// A joint of this kind, at this state.
template <int row_count, bool with_inerter>
struct TurningJoint {
  static constexpr int rows = row_count;
  using Rows = RowsOfTurningStep<rows, with_inerter>;
  static constexpr bool free = rows == 5 || with_inerter;
  double s, inertance = 0.0;
  Vector G[6];  ///< rows, in the lanes of the rotations
  Vector Z[rows];
  Numbers numbers_of_Z[rows];

  /// A number of G, of its last three columns.
  LINKWORK_INLINE Vector g(int r, int c) const { return r < 3 ? rows_of_G[r][c] : columns_of_inverse[c - 3][r - 3]; }

  /// False where the joint, or what yields in it, is of another kind.
  LINKWORK_INLINE bool read(const Rows& of, const double* b) {
    if (!of.stand_so() || !read_compliance(of) || !has_the_form(of) || !invert(of)) return false;
    read_parent(of, b);
    return true;
  }

 private:
  Numbers rows_of_G[3], columns_of_inverse[3];

  LINKWORK_INLINE bool read_compliance(const Rows& of) {
    const double* e = of.data.e;
    if (!e) return !with_inerter;
    constexpr int hard_rows = with_inerter ? 5 : rows;
    const Vector hard = load_first<hard_rows>(e + of.step.row);
    bool yields = false;
    LINKWORK_EACH_PART yields = yields || any(hard.part[p] != Native{});
    if constexpr (with_inerter) inertance = 1.0 / e[of.row(5)];
    return !yields && inertance >= 0.0 && inertance < __builtin_inf();
  }

  /// What stands in B and P before K and R, less what should: zeros.
  LINKWORK_INLINE bool has_the_form(const Rows& of) {
    s = of.D_body(0)[0];
    NativeIndex rest{};
    const auto expect_zeros = [&](const Vector& v) { rest |= (NativeIndex)v.part[0]; };
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
      const Vector row = load_first<3>(of.D_body(k));
      expect_zeros(k < 3 ? row - unit(k) * splat(s) : row);
    }
    if (of.step.parent >= 0) LINKWORK_UNROLL
      for (int k = 0; k < rows; ++k) {
        const Vector row = load_first<3>(of.D_parent(k));
        expect_zeros(k < 3 ? row + unit(k) * splat(s) : row);
      }
    return s * s == 1.0 && !any((Native)rest != Native{});
  }

  /// G. The columns of R^-1 are the products of two rows of R, over the determinant.
  LINKWORK_INLINE bool invert(const Rows& of) {
    const auto row_of_R = [&](int k) { return load_first<3>(of.D_body(k) + 3); };
    const Vector x = row_of_R(3), y = row_of_R(4), xy = cross(x, y), z = rows == 5 ? xy : row_of_R(rows - 1);
    const Vector terms = z * xy;
    const double determinant = terms[0] + terms[1] + terms[2];
    if (!(determinant * determinant > least_determinant * least_determinant)) return false;
    const Vector inverse = splat(1.0 / determinant), columns[3] = {cross(y, z), cross(z, x), xy};
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
      columns_of_inverse[c] = inverse * columns[c];
    LINKWORK_UNROLL for (int m = 3; m < 6; ++m)
      G[m] = unit(3) * g(m, 3) + unit(4) * g(m, 4) + unit(5) * g(m, 5);
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      const double* K = of.D_body(r) + 3;
      G[r] = splat(-s) * (splat(K[0]) * G[3] + splat(K[1]) * G[4] + splat(K[2]) * G[5]);
      rows_of_G[r] = G[r];
    }
    return true;
  }

  /// x x y = next(x * next(y) - next(x) * y) in the first three lanes.
  static LINKWORK_INLINE Vector cross(const Vector& x, const Vector& y) { return next(x * next(y) - next(x) * y); }
  static LINKWORK_INLINE Vector next(Vector v) {
    Native& first = v.part[0];
#if defined(__AVX512F__)
    first = __builtin_shufflevector(first, first, 1, 2, 0, 3, 4, 5, 6, 7);
#elif defined(__AVX__)
    first = __builtin_shufflevector(first, first, 1, 2, 0, 3);
#endif
    return v;
  }

  LINKWORK_INLINE void read_parent(const Rows& of, const double* b) {
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      Z[k] = unit(right_hand_side) * splat(b[of.row(k)]);
    if (of.step.parent >= 0) LINKWORK_UNROLL
      for (int k = 0; k < rows; ++k) Z[k] += load_first<6>(of.D_parent(k));
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
      if (k < 3) Z[k] = Z[k] * splat(s);
      numbers_of_Z[k] = Z[k];
    }
  }
};

/// N = G^T M G from the columns of M, a' behind those of N.
template <class Joint>
LINKWORK_INLINE void transform(const Joint& joint, Vector* M) {
  const Vector* G = joint.G;
  Numbers column, row[3];
  LINKWORK_UNROLL for (int c = 3; c < 6; ++c) {
    Vector sum = M[0] * joint.g(0, c), odd = M[1] * joint.g(1, c);
    LINKWORK_UNROLL for (int r = 2; r < 6; ++r)
      (r % 2 ? odd : sum) += M[r] * joint.g(r, c);
    sum += odd;
    column = sum;
    sum = sum * load(but_rotations) + G[0] * column[0];
    odd = G[1] * column[1];
    LINKWORK_UNROLL for (int r = 2; r < 6; ++r)
      (r % 2 ? odd : sum) += G[r] * column[r];
    row[c - 3] = sum + odd;
  }
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    if (c >= 3) M[c] = load(row[c - 3].at);
    else M[c] = M[c] * load(but_rotations) + unit(3) * row[0][c] + unit(4) * row[1][c] + unit(5) * row[2][c];
  }
}

/// M of a body with a behind its columns: its own mass, or what came together in the articulated inertia.
LINKWORK_INLINE void load_inertia(bool own, int body, const double* articulated, const Data& data, const double* a,
                                  Vector* M) {
  if (own) LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) M[c] = mass_column(data.mass[body], c, a[6 * body + c]);
  else LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) M[c] = load(articulated + c * lanes);
}

/// M_p += P^T C P with a_p, from W = C P.
template <int rows>
LINKWORK_INLINE void add_to_parent_of(const TreeStep& step, const Data& data, const double* a, const Vector* Z,
                                      const Vector* W) {
  double* articulated = data.articulated_inertias + step.parent_slot * articulated_inertia_size;
  Vector M[6];
  load_inertia(step.parent_begins, step.parent, articulated, data, a, M);
  Numbers column;
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    column = W[c];
    Vector sum = M[c], odd = Z[1] * column[1] - W[c] * unit(right_hand_side);
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      if (r != 1) (r % 2 ? odd : sum) += Z[r] * column[r];
    store(articulated + c * lanes, sum + odd);
  }
}

/// C from N, and z_f; returns d.
template <class Joint>
LINKWORK_INLINE double release(const Joint& joint, Vector* C, Vector& z_f) {
  constexpr int rows = Joint::rows;
  const Vector N_f = C[5];
  const double d = N_f[5] + joint.inertance, inverse = 1.0 / d;
  const Vector h = N_f * load(but_freedom) - unit(5) * splat(joint.inertance), h_over_d = h * splat(inverse);
  Numbers numbers_of_N_f, numbers_of_h;
  numbers_of_N_f = N_f;
  numbers_of_h = h;
  LINKWORK_UNROLL for (int c = 0; c < 5; ++c) {
    const Vector N_c = rows == 5 ? C[c] : C[c] * load(but_freedom);  // of five rows nothing reads the sixth
    C[c] = N_c - h_over_d * numbers_of_N_f[c];
  }
  C[5] = N_f * splat(joint.inertance * inverse);
  z_f = unit(right_hand_side) * numbers_of_N_f[right_hand_side];
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
    z_f -= joint.Z[r] * numbers_of_h[r];
  z_f = z_f * splat(inverse);
  return d;
}

/// W = C P.
template <class Joint>
LINKWORK_INLINE void multiply_by_parent(const Joint& joint, const Vector* C, Vector* W) {
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    if (c < 3) {
      W[c] = splat(0.0) - C[c];
      continue;
    }
    Vector sum = C[0] * joint.numbers_of_Z[0][c], odd = C[1] * joint.numbers_of_Z[1][c];
    LINKWORK_UNROLL for (int r = 2; r < Joint::rows; ++r)
      (r % 2 ? odd : sum) += C[r] * joint.numbers_of_Z[r][c];
    W[c] = sum + odd;
  }
}

/// G Z, and C b - k.
template <class Joint>
LINKWORK_INLINE void store_way_back(const Joint& joint, const Vector* C, const Vector& z_f, double* factors) {
  using At = TurningFactors<Joint::rows>;
  LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
    const Vector rotations = joint.Z[3] * joint.g(r, 3) + joint.Z[4] * joint.g(r, 4) + z_f * joint.g(r, 5);
    store_first<7>(factors + At::motions + 7 * r, r < 3 ? rotations + joint.Z[r] : rotations);
  }
  Vector lambda = splat(0.0);
  LINKWORK_UNROLL for (int r = 0; r < Joint::rows; ++r)
    lambda += C[r] * joint.numbers_of_Z[r][right_hand_side] - unit(r) * lane(C[r], right_hand_side);
  store_first<Joint::rows>(factors + At::multipliers, lambda);
  factors[At::sign] = joint.s;
}

/// False where the joint is of another kind; then nothing is done.
template <int rows, bool with_inerter>
LINKWORK_INLINE bool factor_turning_step(const TreeStep& step, const Data& data, const double* a, const double* b,
                                         SmallestPivot& smallest) {
  using At = TurningFactors<rows>;
  double* factors = data.factors + step.storage;
  TurningJoint<rows, with_inerter> joint;
  if (!joint.read({step, data}, b)) return factors[At::sign] = 0.0, false;
  Vector C[6], W[6];
  load_inertia(step.slot < 0, step.body, data.articulated_inertias + step.slot * articulated_inertia_size, data, a, C);
  transform(joint, C);
  double d = C[5][5];
  Vector z_f = joint.Z[rows - 1];
  if constexpr (joint.free) d = release(joint, C, z_f);
  if (!(d > 0.0)) smallest = {d == d ? 0.0 : not_a_number, step.row};
  if (step.parent >= 0) {
    multiply_by_parent(joint, C, W);
    add_to_parent_of<rows>(step, data, a, joint.Z, W);
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      store_first<rows>(factors + At::transmissions + rows * c, W[c]);
  }
  store_way_back(joint, C, z_f, factors);
  return true;
}

/// False where the factors are those of another kind.
template <int rows, bool with_inerter>
LINKWORK_INLINE bool turn_back(const TreeStep& step, const Data& data, double* x, double* lambda) {
  using At = TurningFactors<rows>;
  const double* factors = data.factors + step.storage;
  if (factors[At::sign] == 0.0) return false;
  const double* y =
      step.parent >= 0 ? data.articulated_inertias + step.parent_slot * articulated_inertia_size : right_hand_side_lane;
  Vector products[6];
  LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
    products[r] = load_first<7>(factors + At::motions + 7 * r) * load(y);
  const Vector x_body = sums<6>(products);
  store_first<6>(x + 6 * step.body, x_body);
  if (step.slot >= 0) leave_for_children(x_body, step.slot, data);
  Vector l = load_first<rows>(factors + At::multipliers);
  if (step.parent >= 0) LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) l += load_first<rows>(factors + At::transmissions + rows * c) * splat(y[c]);
  l = l * (lanes_before(3) * splat(factors[At::sign]) + lanes_after(2));
  store_first<with_inerter ? 5 : rows>(lambda + step.row, l);
  if constexpr (with_inerter) lambda[RowsOfTurningStep<rows, true>{step, data}.row(5)] = l[5];
  return true;
}

}  // namespace
}  // namespace linkwork::block
