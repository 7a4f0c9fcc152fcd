#pragma once

#include "linkwork/linear/block/common_kernels.hpp"
#include "linkwork/linear/block/hinge_elimination.hpp"

/// Bodies of open branches on a hinge or on a slider, with or without an inerter along it, or on a weld: as TreeStep,
/// with one division in the way to the root where the elimination row by row has as many as there are rows, six and
/// those.
//
// With a row f for the freedom beside those of the joint, which is the inerter's where there is one, the rows of the
// body and of the parent are square. Those of translation are taken times the sign s that makes them
//   B = [I K; 0 R],   P = [-I K_p; 0 R_p],   G = B^-1 = [I -K R^-1; 0 R^-1].
// u = B x_b is what the joint prescribes, and u_f. With y = (-x_p, 1), Z = (P, b) and the rows H of the joint without f,
//   x_b = X y + g_f u_f,   X = G_H Z_H,   lambda_H = G_H^T (M_b x_b - a_b),   lambda_f = beta (z_f y - u_f),
// g_f: column f of G, beta: the inertance along f, or 0. The work of both is stationary in u_f: with
//   r = g_f^T (M_b X - (0, a_b)),   n = g_f^T M_b g_f,   d = n + beta
// u_f = t y, t = (beta z_f - r) / d, and the parent, whose force stands behind its columns, gets
//   [M_p | a_p] += X^T (M_b X - (0, a_b)) + r^T t + z_f^T (beta / d) (r + n z_f)
// in its six rows. Nothing but the last two terms waits for the division, and X^T M_b X but for the mass. Along f nothing
// is a difference: what a free hinge does not carry is zero in X, and does not reach the parent.
//
// A slider has two rows of translation, (T, C), before those of rotation, and f, of the inerter or across the two, is
// one of translation: G = [S -S C R^-1; 0 R^-1] with S the inverse of the three rows T. Else it is the same.
namespace linkwork::block {
namespace {

template <int rows, bool scattered>
constexpr bool turns = width > 2 &&
                       (rows == 6 || (rows == 5 && !scattered));  // width 2: the path of deterministic runs

/// Places of the factors of such a step: x_b and lambda as rows that are multiplied by y, and s, or 0 where the factors
/// are those of TreeStep.
template <int rows>
struct TurningFactors {
  static constexpr int motions = 0, multipliers = 6 * 7, sign = static_cast<int>(sign_place(rows));
  static_assert(sign < step_storage(rows) && sign >= second_factors(rows) + 7 * rows);
};

/// Whether the factors of a step go past the caches, as of large models those of this form do: all others come before
/// they are read.
LINKWORK_INLINE bool streams_factors(const TreeStep& step, const Data& data) {
  return width > 2 && data.streamed && (step.turning || step.slides);
}

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

constexpr int freedom = 7;  // lane of what belongs to u_f

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

/// What a joint of this kind says at this state. It waits for nothing: that of the next step is read while the way to the
/// root waits for this one.
struct TurningJoint {
  bool turns = false;  ///< else there is nothing
  bool slides = false;
  double s, inertance;
  Numbers X[6];                     ///< rows, with g_f in the last lane
  Numbers R_inverse[3], shifts[3];  ///< columns, of R^-1, and of a slider of S
  Numbers z_f;

  LINKWORK_INLINE Vector g_f(int r) const { return X[r][freedom]; }
};

template <int rows, bool with_inerter>
class TurningJointReader {
 public:
  LINKWORK_INLINE TurningJointReader(const TreeStep& step, const Data& data, TurningJoint& joint)
      : of_{step, data}, joint_(joint) {}

  LINKWORK_INLINE void read(const double* b) {
    joint_.slides = may_slide && of_.step.slides && (with_inerter || of_.step.parent >= 0);
    joint_.turns = (of_.step.turning || joint_.slides) && of_.stand_so() && read_compliance();
    if constexpr (may_slide)
      if (joint_.slides) {
        joint_.turns = joint_.turns && invert_slider();
        if (joint_.turns) read_parent_of_slider(b);
        return;
      }
    joint_.turns = joint_.turns && has_the_form() && invert();
    if (joint_.turns) read_parent(b);
  }

 private:
  static constexpr int hard_rows = with_inerter ? 5 : rows;
  static constexpr bool may_slide = hard_rows == 5;

  /// False where what yields in the joint is something else.
  LINKWORK_INLINE bool read_compliance() {
    joint_.inertance = 0.0;
    const double* e = of_.data.e;
    if (!e) return !with_inerter;
    const Vector hard = load_first<hard_rows>(e + of_.step.row);
    bool yields = false;
    LINKWORK_EACH_PART yields = yields || any(hard.part[p] != Native{});
    if constexpr (with_inerter) joint_.inertance = 1.0 / e[of_.row(5)];
    return !yields && joint_.inertance >= 0.0 && joint_.inertance < __builtin_inf();
  }

  /// What the kind of joint does not say: that the inerter is one of rotation.
  LINKWORK_INLINE bool has_the_form() const {
    if constexpr (!with_inerter) return true;
    NativeIndex rest = (NativeIndex)load_first<3>(of_.D_body(5)).part[0];
    if (of_.step.parent >= 0) rest |= (NativeIndex)load_first<3>(of_.D_parent(5)).part[0];
    return !any((Native)rest != Native{});
  }

  /// The columns of R^-1 are the products of two rows of R, over the determinant.
  LINKWORK_INLINE bool invert() {
    const Vector x = row_of_R(3), y = row_of_R(4), xy = cross(x, y), z = rows == 5 ? xy : row_of_R(rows - 1);
    return invert(x, y, z, xy, joint_.R_inverse);
  }
  LINKWORK_INLINE bool invert_slider() {
    const Vector x = load_first<3>(of_.D_body(0)), y = load_first<3>(of_.D_body(1)), xy = cross(x, y);
    const Vector z = with_inerter ? load_first<3>(of_.D_body(rows - 1)) : xy;
    const Vector r = row_of_R(2), s = row_of_R(3);
    return invert(x, y, z, xy, joint_.shifts) && invert(r, s, row_of_R(4), cross(r, s), joint_.R_inverse);
  }
  LINKWORK_INLINE Vector row_of_R(int k) const { return load_first<3>(of_.D_body(k) + 3); }

  static LINKWORK_INLINE bool invert(const Vector& x, const Vector& y, const Vector& z, const Vector& xy,
                                     Numbers* inverse_columns) {
    const Vector terms = z * xy;
    const double determinant = terms[0] + terms[1] + terms[2];
    if (!(determinant * determinant > least_size)) return false;
    const Vector inverse = splat(1.0 / determinant), columns[3] = {cross(y, z), cross(z, x), xy};
    LINKWORK_UNROLL for (int c = 0; c < 3; ++c)
      inverse_columns[c] = inverse * columns[c];
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

  LINKWORK_INLINE void read_rows_of_parent(const double* b, Vector* Z) const {
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
      Z[k] = unit(right_hand_side) * splat(b[of_.row(k)]);
      if (of_.step.parent >= 0) Z[k] += load_first<6>(of_.D_parent(k));
    }
  }

  /// X = s (Z - K X_rotations) in the rows of translation.
  LINKWORK_INLINE void read_parent(const double* b) {
    Vector Z[rows], X[6];
    read_rows_of_parent(b, Z);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m) {
      X[3 + m] = unit(freedom) * joint_.R_inverse[2][m];
      LINKWORK_UNROLL for (int k = 3; k < hard_rows; ++k)
        X[3 + m] += Z[k] * joint_.R_inverse[k - 3][m];
    }
    joint_.s = of_.D_body(0)[0];
    LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
      const double* K = of_.D_body(r) + 3;
      X[r] = splat(joint_.s) * (Z[r] - splat(K[0]) * X[3] - splat(K[1]) * X[4] - splat(K[2]) * X[5]);
    }
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      joint_.X[r] = X[r];
    if constexpr (with_inerter) joint_.z_f = Z[5];
  }

  /// X = S (Z - C X_rotations) there, with u_f behind.
  LINKWORK_INLINE void read_parent_of_slider(const double* b) {
    Vector Z[rows], X[6], shifts[3] = {splat(0.0), splat(0.0), splat(0.0)};
    read_rows_of_parent(b, Z);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      X[3 + m] = Z[2] * joint_.R_inverse[0][m] + Z[3] * joint_.R_inverse[1][m] + Z[4] * joint_.R_inverse[2][m];
    LINKWORK_UNROLL for (int k = 0; k < (with_inerter ? 3 : 2); ++k) {
      const double* C = of_.D_body(k < 2 ? k : rows - 1) + 3;
      if (k < 2) shifts[k] = Z[k];
      shifts[k] -= splat(C[0]) * X[3] + splat(C[1]) * X[4] + splat(C[2]) * X[5];
    }
    shifts[2] += unit(freedom);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      X[m] = shifts[0] * joint_.shifts[0][m] + shifts[1] * joint_.shifts[1][m] + shifts[2] * joint_.shifts[2][m];
    joint_.s = 1.0;
    LINKWORK_UNROLL for (int r = 0; r < 6; ++r)
      joint_.X[r] = X[r];
    if constexpr (with_inerter) joint_.z_f = Z[rows - 1];
  }

  const RowsOfTurningStep<rows, with_inerter> of_;
  TurningJoint& joint_;
};

/// How many rows there are, and whether one is an inerter's.
template <int row_count, bool with_inerter>
struct TurningKind {
  static constexpr int rows = row_count, hard_rows = with_inerter ? 5 : rows;
  static constexpr bool free = rows == 5 || with_inerter, has_inerter = with_inerter;
};

/// M_b X - (0, a_b), in the lane behind M_b g_f, from the columns of [M_b; a_b].
LINKWORK_INLINE void multiply_by_mass(const TurningJoint& joint, const double* M, Vector* W) {
  Vector X[6];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    X[k] = load(joint.X[k].at);
  LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
    const double* column = M + r * lanes;
    Vector sum = X[0] * splat(column[0]);
    Vector odd = X[1] * splat(column[1]) - load_lanes<right_hand_side, 1>(column + right_hand_side);
    LINKWORK_UNROLL for (int k = 2; k < 6; ++k)
      (k % 2 ? odd : sum) += X[k] * splat(column[k]);
    W[r] = sum + odd;
  }
}

/// Row c of X^T W, or of g_f^T W.
template <class Number>
LINKWORK_INLINE Vector combination(const Vector* W, const Number& factor) {
  Vector sum = W[0] * factor(0), odd = W[1] * factor(1);
  LINKWORK_UNROLL for (int r = 2; r < 6; ++r)
    (r % 2 ? odd : sum) += W[r] * factor(r);
  return sum + odd;
}

/// What follows for u_f.
struct Release {
  double d;
  Vector r, t, toward_f;  ///< (beta / d) (r + n z_f)
};

template <class Kind>
LINKWORK_INLINE Release release(const TurningJoint& joint, const Vector* W) {
  Release out;
  out.r = combination(W, [&](int r) { return joint.g_f(r); });
  const double n = out.r[freedom];
  out.d = n + joint.inertance;
  if constexpr (!Kind::free) return out;
  const Vector inverse = splat(1.0 / out.d), beta = splat(joint.inertance);
  if constexpr (Kind::has_inerter) {
    const Vector z_f = load(joint.z_f.at);
    out.t = (beta * z_f - out.r) * inverse;
    out.toward_f = (out.r + splat(n) * z_f) * (beta * inverse);
  } else {
    out.t = (splat(0.0) - out.r) * inverse;
  }
  return out;
}

/// [M; a] of a body, its own or what came together. To branch in each column makes a sweep a twelfth slower.
LINKWORK_INLINE void load_inertia(bool own, int body, const double* articulated, const Data& data, const double* a,
                                  Vector* M) {
  if (own) LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) M[c] = mass_column(data.mass[body], c, a[6 * body + c]);
  else LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) M[c] = load(articulated + c * lanes);
}

template <class Kind>
LINKWORK_INLINE void add_to_parent_of(const TreeStep& step, const Data& data, const double* a,
                                      const TurningJoint& joint, const Vector* W, const Release& free) {
  double* articulated = data.articulated_inertias + step.parent_slot * articulated_inertia_size;
  Vector M[6];
  load_inertia(step.parent_begins, step.parent, articulated, data, a, M);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    if (c < 3 && !joint.slides) M[c] -= W[c];  // there X is -I
    else M[c] += combination(W, [&](int r) { return joint.X[r][c]; });
    if constexpr (Kind::has_inerter) M[c] += joint.z_f[c] * free.toward_f;
    if constexpr (Kind::free) M[c] += lane(free.r, c) * free.t;
    store(articulated + c * lanes, M[c]);
  }
}

/// G_H^T of the forces M_b x_b - a_b, which it uses up.
template <class Kind>
LINKWORK_INLINE void store_multipliers_of_turning(const TurningJoint& joint, const double* D, Vector* forces,
                                                  double* factors) {
  using At = TurningFactors<Kind::rows>;
  LINKWORK_UNROLL for (int r = 0; r < 3; ++r) {
    forces[r] = forces[r] * splat(joint.s);
    store_first<7>(factors + At::multipliers + 7 * r, forces[r]);
  }
  LINKWORK_UNROLL for (int m = 0; m < 3; ++m) LINKWORK_UNROLL
    for (int r = 0; r < 3; ++r) forces[3 + m] -= splat(D[6 * r + 3 + m]) * forces[r];
  LINKWORK_UNROLL for (int k = 3; k < Kind::hard_rows; ++k) {
    Vector multiplier = joint.R_inverse[k - 3][0] * forces[3];
    multiplier += joint.R_inverse[k - 3][1] * forces[4];
    store_first<7>(factors + At::multipliers + 7 * k, multiplier + joint.R_inverse[k - 3][2] * forces[5]);
  }
}

/// The same of a slider.
template <class Kind>
LINKWORK_INLINE void store_multipliers_of_slider(const TurningJoint& joint, const double* D, const double* D_inerter,
                                                 Vector* forces, double* factors) {
  using At = TurningFactors<Kind::rows>;
  const auto product = [&](const Numbers& column, const Vector* v) {
    return column[0] * v[0] + column[1] * v[1] + column[2] * v[2];
  };
  LINKWORK_UNROLL for (int k = 0; k < (Kind::has_inerter ? 3 : 2); ++k) {
    const Vector along = product(joint.shifts[k], forces);
    const double* C = k < 2 ? D + 6 * k + 3 : D_inerter + 3;
    if (k < 2) store_first<7>(factors + At::multipliers + 7 * k, along);
    LINKWORK_UNROLL for (int m = 0; m < 3; ++m)
      forces[3 + m] -= splat(C[m]) * along;
  }
  LINKWORK_UNROLL for (int k = 0; k < 3; ++k)
    store_first<7>(factors + At::multipliers + 7 * (2 + k), product(joint.R_inverse[k], forces + 3));
}

template <class Kind>
LINKWORK_INLINE void store_way_back(const TurningJoint& joint, const double* D, const double* D_inerter,
                                    const Vector* W, const Release& free, double* factors) {
  using At = TurningFactors<Kind::rows>;
  Vector forces[6];  // M_b x_b - a_b
  LINKWORK_UNROLL for (int r = 0; r < 6; ++r) {
    Vector motion = load(joint.X[r].at);
    forces[r] = W[r];
    if constexpr (Kind::free) {
      motion += free.t * joint.g_f(r);
      forces[r] += free.t * lane(W[r], freedom);
    }
    store_first<7>(factors + At::motions + 7 * r, motion);
  }
  if (joint.slides) store_multipliers_of_slider<Kind>(joint, D, D_inerter, forces, factors);
  else store_multipliers_of_turning<Kind>(joint, D, forces, factors);
  if constexpr (Kind::has_inerter)
    store_first<7>(factors + At::multipliers + 7 * 5, (load(joint.z_f.at) - free.t) * splat(joint.inertance));
  factors[At::sign] = joint.s;
}

/// Whole lines go past the caches at once: they are put together beside their place first.
template <int rows, class StoreFactors>
LINKWORK_INLINE void stream_factors(double* place, const StoreFactors& store_factors) {
  constexpr auto size = static_cast<int>(step_storage(rows));
  alignas(64) double together[size];
  store(together + size - lanes, splat(0.0));  // the last line is not filled
  store_factors(together);
  LINKWORK_UNROLL for (int k = 0; k < size; k += width)
    stream_native(place + k, load_native(together + k));
}

template <int rows, bool with_inerter>
LINKWORK_INLINE void factor_turning_step(const TreeStep& step, const Data& data, const double* a,
                                         const TurningJoint& joint, SmallestPivot& smallest) {
  using Kind = TurningKind<rows, with_inerter>;
  alignas(64) double own[articulated_inertia_size];
  const double* M = own;
  if (step.slot >= 0) {
    M = data.articulated_inertias + step.slot * articulated_inertia_size;
  } else {
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      store(own + c * lanes, mass_column(data.mass[step.body], c, a[6 * step.body + c]));
  }
  Vector W[6];
  multiply_by_mass(joint, M, W);
  const Release free = release<Kind>(joint, W);
  note_inertia(smallest, free.d, Kind::free ? least_pivot(joint.slides, step, data) : not_a_number, step.row);
  if (step.parent >= 0) add_to_parent_of<Kind>(step, data, a, joint, W, free);
  const double* D_inerter = with_inerter ? RowsOfTurningStep<rows, with_inerter>{step, data}.D_body(rows - 1) : nullptr;
  const auto store_factors = [&](double* factors) {
    store_way_back<Kind>(joint, data.D + step.D_body, D_inerter, W, free, factors);
  };
  if (data.streamed) stream_factors<rows>(data.factors + step.storage, store_factors);
  else store_factors(data.factors + step.storage);
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
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    products[k] = load_first<7>(factors + At::multipliers + 7 * k) * load(y);
  const Vector l = sums<rows>(products);
  store_first<with_inerter ? 5 : rows>(lambda + step.row, l);
  if constexpr (with_inerter) lambda[RowsOfTurningStep<rows, true>{step, data}.row(5)] = l[5];
  return true;
}

}  // namespace
}  // namespace linkwork::block
