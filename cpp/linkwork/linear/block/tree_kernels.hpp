#pragma once

#include "linkwork/linear/block/ballast_kernels.hpp"
#include "linkwork/linear/block/hinge_kernels.hpp"
#include "linkwork/linear/block/turning_kernels.hpp"

/// Open branches, leaf to root and back.
//
// A body b held by one joint with rows D_b, D_p (p: the parent). With M_b = L D L^T, W = D_b L^-T and
// S = E + W D^-1 W^T = K D' K^T, V = K^-1 D_p, z = K^-1 (b - D_b M_b^-1 a_b):
//   M_p += V^T D'^-1 V,  a_p += V^T D'^-1 z
// and on the way back, with G = M_b^-1 D_b^T, T = S^-1 D_p (the only numbers that are kept):
//   lambda = S^-1 K z - T x_p,   x_b = M_b^-1 a_b + G lambda
// Right-hand sides ride along: a in the lane behind the rows of D, z in the lane behind the columns of D_p.
namespace linkwork::block {
namespace {

constexpr int steps_ahead = 8, steps_ahead_back = 16;  // that are prefetched

/// Where the rows of a step stand.
template <bool scattered>
struct RowsOfStep {
  const TreeStep& step;
  const Data& data;

  LINKWORK_INLINE const double* D_body(int k) const {
    if constexpr (scattered) return data.D + of(k).D_body;
    else return data.D + step.D_body + 6 * k;
  }
  LINKWORK_INLINE const double* D_parent(int k) const {
    if constexpr (scattered) return data.D + of(k).D_parent;
    else return data.D + step.D_parent + 6 * k;
  }
  LINKWORK_INLINE int row(int k) const {
    if constexpr (scattered) return of(k).row;
    else return step.row + k;
  }
  template <int rows>
  LINKWORK_INLINE void store_multipliers(double* lambda, const Vector& found) const {
    if constexpr (!scattered) return store_first<rows>(lambda + step.row, found);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      lambda[row(k)] = found[k];
  }

 private:
  LINKWORK_INLINE const StepRow& of(int k) const { return data.step_rows[step.scattered + k]; }
};

/// The first `rows` lanes and that of the right-hand side, one behind the other in memory.
template <int rows>
LINKWORK_INLINE void store_packed(double* to, const Vector& v) {
  store_first<rows>(to, v);
#if defined(__AVX512F__)
  _mm512_mask_storeu_pd(to + rows - right_hand_side, 1 << right_hand_side, (__m512d)v.part[0]);
#else
  to[rows] = v[right_hand_side];
#endif
}
/// The way back, with zero in the other lanes.
template <int rows>
LINKWORK_INLINE Vector load_packed(const double* from) {
  Vector v = load_first<rows>(from);
#if defined(__AVX512F__)
  v.part[0] = (Native)_mm512_mask_loadu_pd((__m512d)v.part[0], 1 << right_hand_side, from + rows - right_hand_side);
#else
  v.set(right_hand_side, from[rows]);
#endif
  return v;
}

LINKWORK_INLINE void prefetch_step(const TreeStep& step, const Data& data) {
  if (step.scattered >= 0) {
    for (const StepRow* row = data.step_rows + step.scattered; row < data.step_rows + step.scattered + step.rows;
         ++row) {
      prefetch<false>(data.D + row->D_body, 6);
      prefetch<false>(data.D + row->D_parent, 6);
    }
  } else {
    prefetch<false>(data.D + step.D_body, 6 * step.rows);
    prefetch<false>(data.D + step.D_parent, 6 * step.rows);
  }
  if (!streams_factors(step, data)) prefetch<true>(data.factors + step.storage, step_storage(step.rows));
  __builtin_prefetch(&data.mass[step.body]);
}

/// M_b = L D L^T with W = D_b L^-T on its way, and G = W D^-1; the right-hand sides ride along. L and G are left with
/// unit L and scaled columns.
template <int rows>
LINKWORK_INLINE void factor_body_of(const TreeStep& step, const Data& data, Vector* M, Vector* W, Vector* L, Vector* G,
                                    SmallestPivot& smallest) {
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Vector pivot = lane(M[k], k), inverse = inverse_of_lane(M[k], k);
    L[k] = M[k] * inverse;
    G[k] = W[k] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) {
      // the next pivot waits for this column: one operation less behind the division
      if (c == k + 1) M[c] -= (M[k] * lane(M[k], c)) * inverse;
      else M[c] -= M[k] * lane(L[k], c);
      W[c] -= W[k] * lane(L[k], c);
    }
    note_inertia(smallest, pivot[0], least_pivot(k < 3, step, data), rows > 0 ? step.row : -1);
  }
}

/// S = K D' K^T with V = K^-1 D_p and T = D'^-1 V; S is left with K.
template <int rows, class Rows>
LINKWORK_INLINE void factor_joint_of(const Rows& of, const Data& data, Vector* S, Vector* V, Vector* T,
                                     SmallestPivot& smallest) {
  double diagonal[rows];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    diagonal[k] = S[k][k];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    const Vector pivot = lane(S[k], k), inverse = inverse_of_lane(S[k], k);
    note(smallest, pivot[0], diagonal[k], of.row(k), data);
    const Vector K = S[k] * inverse;
    T[k] = V[k] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c) {
      if (c == k + 1) S[c] -= (S[k] * lane(S[k], c)) * inverse;
      else S[c] -= S[k] * lane(K, c);
      V[c] -= V[k] * lane(K, c);
    }
    S[k] = K;
  }
}

/// M_p += V^T T, which begins with the parent's own mass.
template <int rows>
LINKWORK_INLINE void add_to_parent(const TreeStep& step, const Data& data, const double* a, const Vector* V,
                                   const Vector* T) {
  double* articulated = data.articulated_inertias + step.parent_slot * articulated_inertia_size;
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    Vector sum;
    if (step.parent_begins) sum = mass_column(data.mass[step.parent], c, a[6 * step.parent + c]);
    else sum = load(articulated + c * lanes);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      sum += V[k] * lane(T[k], c);
    store(articulated + c * lanes, sum);
  }
}

LINKWORK_INLINE const double* ballast_at(int body, const Data& data) { return &data.ballast[body].inverse_mass; }

/// M_b += D_b^T S D_b; leaves S.
template <int rows, class Rows>
LINKWORK_INLINE void add_ballast(const Rows& of, const Data& data, Vector* M, double* S) {
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    const double* d = of.D_body(k);
    S[k] = ballast_of_row<Doubles>(d, ballast_at(of.step.body, data), data.e ? data.e[of.row(k)] : 0.0);
    const Vector scaled = load_first<6>(d) * splat(S[k]);
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      M[c] += scaled * splat(d[c]);
  }
}

/// [M_p; a_p] -= [D_p, b]^T S D_p.
template <int rows, class Rows>
LINKWORK_INLINE void take_ballast_again(const Rows& of, const Data& data, const double* b, const double* S) {
  double* articulated = data.articulated_inertias + of.step.parent_slot * articulated_inertia_size;
  Vector scaled[rows];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    scaled[k] = (load_first<6>(of.D_parent(k)) + unit(right_hand_side) * splat(b[of.row(k)])) * splat(S[k]);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    Vector sum = load(articulated + c * lanes);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      sum -= scaled[k] * splat(of.D_parent(k)[c]);
    store(articulated + c * lanes, sum);
  }
}

template <int rows, bool scattered>
LINKWORK_INLINE void factor_row_by_row(const TreeStep& step, const Data& data, const double* a, const double* b,
                                       SmallestPivot& smallest) {
  const RowsOfStep<scattered> of{step, data};
  Vector M[6], W[6], L[6], G[6];
  [[maybe_unused]] double ballast[rows + 1];
  load_columns<rows>([&](int k) { return of.D_body(k); }, W);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    if (step.slot >= 0) M[c] = load(data.articulated_inertias + step.slot * articulated_inertia_size + c * lanes);
    else M[c] = mass_column(data.mass[step.body], c, a[6 * step.body + c]);
    W[c] += M[c] * unit(right_hand_side);
  }
  if (data.ballast) add_ballast<rows>(of, data, M, ballast);
  factor_body_of<rows>(step, data, M, W, L, G, smallest);
  double* factors = data.factors + step.storage;
  if constexpr (rows > 0) {
    Vector S[rows], V[rows], T[rows];
    LINKWORK_UNROLL for (int c = 0; c < rows; ++c) {
      S[c] = unit(c) * splat(data.e ? data.e[of.row(c)] : 0.0);
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
        S[c] += W[k] * lane(G[k], c);
      V[c] = unit(right_hand_side) * (splat(b[of.row(c)]) - S[c]);
      if (step.parent >= 0) V[c] += load_first<6>(of.D_parent(c));
    }
    factor_joint_of<rows>(of, data, S, V, T, smallest);
    if (step.parent >= 0) add_to_parent<rows>(step, data, a, V, T);
    if (step.parent >= 0 && data.ballast) take_ballast_again<rows>(of, data, b, ballast);
    LINKWORK_UNROLL for (int k = rows - 1; k >= 0; --k) {
      LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c)
        T[k] -= T[c] * lane(S[k], c);
      store_first<7>(factors + second_factors(rows) + 7 * k, T[k]);
    }
  }
  LINKWORK_UNROLL for (int k = 5; k >= 0; --k) {
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c)
      G[k] -= G[c] * lane(L[k], c);
    store_packed<rows>(factors + (rows + 1) * k, G[k]);
  }
}

template <int rows, bool scattered>
LINKWORK_INLINE void factor_step(const TreeStep& step, const Data& data, const double* a, const double* b,
                                 const TurningJoint& joint, SmallestPivot& smallest) {
  if constexpr (turns<rows, scattered>) {
    if (joint.turns) return factor_turning_step<rows, scattered>(step, data, a, joint, smallest);
    data.factors[step.storage + TurningFactors<rows>::sign] = 0.0;
  }
  if constexpr (by_numbers<rows, scattered>)
    if (factor_by_numbers(step, data, a, b, smallest)) return;
  factor_row_by_row<rows, scattered>(step, data, a, b, smallest);
}

/// lambda -= S D_b x_b.
template <int rows, class Rows>
LINKWORK_INLINE void take_its_forces(const Rows& of, const Data& data, const double* x, double* lambda) {
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    lambda[of.row(k)] -= force_of_ballast<Doubles>(of.D_body(k), ballast_at(of.step.body, data),
                                                   data.e ? data.e[of.row(k)] : 0.0, x + 6 * of.step.body);
}

template <int rows, bool scattered>
LINKWORK_INLINE void backward_step(const TreeStep& step, const Data& data, double* x, double* lambda) {
  if constexpr (turns<rows, scattered>)
    if (turn_back<rows, scattered>(step, data, x, lambda)) return;
  if constexpr (by_numbers<rows, scattered>)
    if (back_by_numbers(step, data, x, lambda)) return;
  const Vector one = unit(right_hand_side);
  const double* factors = data.factors + step.storage;
  Vector products[6], l = splat(0.0);
  if constexpr (rows > 0) {
    const Vector x_parent =
        load(step.parent >= 0 ? data.articulated_inertias + step.parent_slot * articulated_inertia_size
                              : right_hand_side_lane);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      products[k] = load_first<7>(factors + second_factors(rows) + 7 * k) * x_parent;
    l = sums<rows>(products);
    RowsOfStep<scattered>{step, data}.template store_multipliers<rows>(lambda, l);
  }
  l += one;
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    products[k] = load_packed<rows>(factors + (rows + 1) * k) * l;
  const Vector x_body = sums<6>(products);
  store_first<6>(x + 6 * step.body, x_body);
  if (step.slot >= 0) leave_for_children(x_body, step.slot, data);
  if (data.ballast) take_its_forces<rows>(RowsOfStep<scattered>{step, data}, data, x, lambda);
}

/// Calls f with the number of rows of a joint, 0 to 6, and whether they are scattered, as constants.
template <class Function>
LINKWORK_INLINE void with_rows(const TreeStep& step, const Function& f) {
  const auto together = [&](auto rows) { f(rows, std::false_type()); };
  if (step.scattered >= 0) with_count<6>(step.rows, [&](auto rows) { f(rows, std::true_type()); });
  else if (step.rows == 0) together(std::integral_constant<int, 0>());
  else with_count<6>(step.rows, together);
}

LINKWORK_INLINE void read_turning_joint(const TreeStep& step, const Data& data, const double* b, TurningJoint& joint) {
  with_rows(step, [&](auto rows, auto scattered) {
    if constexpr (turns<rows, scattered>) TurningJointReader<rows, scattered>(step, data, joint).read(b);
  });
}

SmallestPivot factor_branches(const Data& data, const NodeRange* ranges, int count, const double* a, const double* b) {
  SmallestPivot smallest;
  TurningJoint joints[2];
  for (const NodeRange* range = ranges; range < ranges + count; ++range) {
    if (range->first < range->last) read_turning_joint(data.steps[range->first], data, b, joints[range->first % 2]);
    for (std::ptrdiff_t s = range->first; s < range->last; ++s) {
      const TreeStep& step = data.steps[s];
      if (data.large && s + steps_ahead < range->last) prefetch_step(data.steps[s + steps_ahead], data);
      if (s + 1 < range->last) read_turning_joint(data.steps[s + 1], data, b, joints[(s + 1) % 2]);
      with_rows(step, [&](auto rows, auto scattered) {
        factor_step<rows, scattered>(step, data, a, b, joints[s % 2], smallest);
      });
    }
  }
  if (data.streamed) end_stream();
  return smallest;
}

void backward_branches(const Data& data, const NodeRange* ranges, int count, double* x, double* lambda) {
  for (const NodeRange* range = ranges + count; range-- > ranges;)
    for (std::ptrdiff_t s = range->last; s-- > range->first;) {
      const TreeStep& step = data.steps[s];
      if (data.large && s >= range->first + steps_ahead_back) {
        const TreeStep& ahead = data.steps[s - steps_ahead_back];
        prefetch<false, 2>(data.factors + ahead.storage, step_storage(ahead.rows));
      }
      with_rows(step, [&](auto rows, auto scattered) { backward_step<rows, scattered>(step, data, x, lambda); });
    }
}

}  // namespace
}  // namespace linkwork::block
