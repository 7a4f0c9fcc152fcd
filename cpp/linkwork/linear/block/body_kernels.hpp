#pragma once

#include "linkwork/linear/block/front_kernels.hpp"
#include "linkwork/linear/block/hinge_kernels.hpp"

/// Bodies of closed loops: their part of D M^-1 D^T and of -D M^-1 a is added to the front of their first joint.
//
// Of a body on a hinge or a slider on the ground these are D g (1/n) (D g)^T and -D x, with its direction of motion g and
// its acceleration x without the loops. What pivots are compared with stays diag(D M^-1 D^T) of the body without that
// joint: a row that the joint nearly fulfils by itself must not look like any other.
namespace linkwork::block {
namespace {

/// The columns of D^T of as many rows as a register holds.
LINKWORK_INLINE void gather_D(const std::ptrdiff_t* D, const Data& data, Native* columns) {
  const double* rows[width];
  for (int l = 0; l < width; ++l) rows[l] = data.D + D[l];
  gather<6>(rows, columns);
}

/// M = L D L^T of a body with branches, with D^-1 L^-1 a: unit L with 1/d on its diagonal, then the other.
void factor_mass(const CoreBody& body, const Data& data, SmallestPivot& smallest) {
  const double* articulated = data.articulated_inertias + body.slot * articulated_inertia_size;
  double* own = data.factors + body.own_factors;
  Vector M[6], y = splat(0.0);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
    M[c] = load(articulated + c * lanes);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Vector pivot = lane(M[k], k), inverse = inverse_of_lane(M[k], k);
    if (!(pivot[0] > 0.0)) smallest = {pivot[0] == pivot[0] ? 0.0 : not_a_number, -1};
    const Vector L = M[k] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c)
      M[c] -= M[k] * lane(L, c);
    y += unit(k) * lane(L, right_hand_side);
    store(own + k * lanes, L * lanes_after(k) * lanes_before(6) + unit(k) * inverse);
  }
  store(own + 6 * lanes, y);
}

/// D^-1 L^-1 a of a body without branches.
LINKWORK_INLINE Vector solve_lower(const MassFactor& factor, Vector a) {
  a -= lane(a, 3) * load_lanes<4, 2>(&factor.L43);
  a -= lane(a, 4) * load_lanes<5, 1>(&factor.L54);
  return a * load_first<6>(factor.inverse);
}

LINKWORK_INLINE GroundPlaces ground_places(const CoreBody& body, const Data& data, const double* a) {
  return ground_places(body, body.ground_D, body.ground_factors, data, a);
}

Grounded<double> eliminate_ground_joint(const CoreBody& body, const Data& data, const double* a, const double* b,
                                        SmallestPivot& smallest) {
  return with_ground_joint(body.slides, ground_places(body, data, a), [&](auto joint) {
    const double size = joint.read(b + body.ground_row), pivot = joint.release();
    if (!(size > least_size && pivot > 0.0) && !(smallest.ratio < data.breakdown))
      smallest = {size == size && pivot == pivot ? 0.0 : not_a_number, body.ground_row};
    joint.store_way_back();
    return joint.grounded();
  });
}

/// The product of rows of D, by columns of them, with a motion.
LINKWORK_INLINE Native along(const Native* B, const double* motion) {
  Native sum = B[0] * splat_native(motion[0]);
  LINKWORK_UNROLL for (int k = 1; k < 6; ++k)
    sum += B[k] * splat_native(motion[k]);
  return sum;
}

/// L^-1 of rows of D, by columns of them.
template <bool branches>
LINKWORK_INLINE void reduce_rows(const double* own, const MassFactor* factor, Native* B) {
  if constexpr (branches) {
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) LINKWORK_UNROLL
      for (int c = k + 1; c < 6; ++c) B[c] -= B[k] * splat_native(own[k * lanes + c]);
  } else {
    B[4] -= B[3] * splat_native(factor->L43);
    B[5] -= B[3] * splat_native(factor->L53) + B[4] * splat_native(factor->L54);
  }
}

/// What [M; D | a] of a body leaves, D M^-1 D^T and -D M^-1 a, is added to the front. With `right_hand_side_only`
/// nothing but the last column. `grounded` is that of a grounded body.
template <bool branches, bool on_ground, bool right_hand_side_only>
void add_body(const CoreBody& body, const Front& front, const Data& data, const double* a,
              const Grounded<double>& grounded) {
  const RowVector* vectors = data.vectors + body.first_vector;
  const std::ptrdiff_t stride = lanes * static_cast<std::ptrdiff_t>(body.vectors);
  double *U = data.scratch, *scaled = U + 6 * stride;  // L^-1 D^T, with and without D^-1; D g, with and without 1/n
  double *right = right_hand_side_of(front, data), *diagonal = diagonal_of(front, data);
  const double* own = data.factors + body.own_factors;
  const MassFactor* factor = branches ? nullptr : data.mass_factors + body.mass_factor;
  const Vector y = branches ? load(own + 6 * lanes) : solve_lower(*factor, load_first<6>(a + 6 * body.body));
  for (int v = 0; v < body.vectors; ++v) LINKWORK_UNROLL
    for (int first = 0; first < lanes; first += width) {
      Native B[6], r{}, d{};
      gather_D(vectors[v].D + first, data, B);
      if constexpr (on_ground) {
        r -= along(B, grounded.alone);
        const Native moved = along(B, grounded.direction);
        store_native(U + v * lanes + first, moved);
        store_native(scaled + v * lanes + first, moved * splat_native(grounded.mobility));
      }
      reduce_rows<branches>(own, factor, B);
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
        if constexpr (!on_ground) r -= B[k] * lane(y, k).part[0];
        if constexpr (right_hand_side_only) continue;
        const Native L = B[k] * splat_native(branches ? own[k * (lanes + 1)] : factor->inverse[k]);
        d += B[k] * L;
        if constexpr (on_ground) continue;
        store_native(U + k * stride + v * lanes + first, B[k]);
        store_native(scaled + k * stride + v * lanes + first, L);
      }
      const int position = vectors[v].position + first;
      store_native(right + position, load_native(right + position) + r);
      if constexpr (!right_hand_side_only) store_native(diagonal + position, load_native(diagonal + position) + d);
    }
}

/// The columns of D M^-1 D^T, from their diagonal on: products of `depth` rows.
template <int depth>
void add_body_columns(const CoreBody& body, const Front& front, const Data& data) {
  const RowVector* vectors = data.vectors + body.first_vector;
  const std::ptrdiff_t stride = lanes * static_cast<std::ptrdiff_t>(body.vectors);
  const double *U = data.scratch, *scaled = U + 6 * stride;
  for (const RelativeIndices* run = data.runs + body.first_run; run < data.runs + body.first_run + body.runs; ++run) {
    const std::ptrdiff_t C_stride = column_stride(front, run->parent_begin);
    double* C = column_of(front, data, run->parent_begin);
    for (int c = 0; c < run->length; c += columns_at_once, C += columns_at_once * C_stride) {
      const int begin = run->begin + c, left = run->length - c;
      with_count<columns_at_once>(left < columns_at_once ? left : columns_at_once, [&](auto columns) {
        int v = begin / lanes;
        for (; v + vectors_at_once <= body.vectors; v += vectors_at_once) {
          int at[vectors_at_once];
          for (int k = 0; k < vectors_at_once; ++k) at[k] = vectors[v + k].position;
          add_product<1, depth, columns, vectors_at_once>(C, C_stride, at, U + v * lanes, scaled + begin, stride);
        }
        if (v < body.vectors)
          add_product<1, depth, columns, 1>(C, C_stride, &vectors[v].position, U + v * lanes, scaled + begin, stride);
      });
    }
  }
}

template <bool right_hand_side_only>
void eliminate_body(const CoreBody& body, const Front& front, const Data& data, const double* a, const double* b,
                    SmallestPivot& smallest) {
  const bool branches = body.slot >= 0;
  if (branches) factor_mass(body, data, smallest);
  if (body.grounded()) {
    const Grounded<double> grounded = eliminate_ground_joint(body, data, a, b, smallest);
    if (branches) add_body<true, true, right_hand_side_only>(body, front, data, a, grounded);
    else add_body<false, true, right_hand_side_only>(body, front, data, a, grounded);
    if constexpr (!right_hand_side_only) add_body_columns<1>(body, front, data);
    return;
  }
  if (branches) add_body<true, false, right_hand_side_only>(body, front, data, a, {});
  else add_body<false, false, right_hand_side_only>(body, front, data, a, {});
  if constexpr (!right_hand_side_only) add_body_columns<6>(body, front, data);
}

/// D^T lambda: those in odd places apart.
LINKWORK_INLINE Vector sum_reactions(const CoreBody& body, const Data& data, const double* lambda) {
  const BodyRow* rows = data.rows + body.first_row;
  Vector sum = splat(0.0), odd = splat(0.0);
  int r = 0;
  for (; r + 1 < body.rows; r += 2) {
    sum += load_first<6>(data.D + rows[r].D) * splat(lambda[rows[r].row]);
    odd += load_first<6>(data.D + rows[r + 1].D) * splat(lambda[rows[r + 1].row]);
  }
  if (r < body.rows) sum += load_first<6>(data.D + rows[r].D) * splat(lambda[rows[r].row]);
  return sum + odd;
}

/// M^-1 (a + forces) of a body with branches.
LINKWORK_INLINE Vector accelerate(const CoreBody& body, const Data& data, Vector forces) {
  const double* own = data.factors + body.own_factors;
  Vector L[8], solution = load(own + 6 * lanes);
  LINKWORK_UNROLL for (int k = 0; k < 8; ++k)
    L[k] = k < 6 ? load(own + k * lanes) : splat(0.0);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Vector known = lane(forces, k);
    solution += unit(k) * L[k] * known;
    forces -= L[k] * lanes_after(k) * known;
  }
  transpose(L);
  LINKWORK_UNROLL for (int k = 5; k > 0; --k)
    solution -= (L[k] * lanes_before(k)) * lane(solution, k);
  return solution;
}

/// x = M^-1 (a + D^T lambda), and the multipliers of a grounded body's joint.
void backward_body(const CoreBody& body, const Data& data, const double* a, double* x, double* lambda) {
  Vector sum = sum_reactions(body, data, lambda);
  double* x_body = x + 6 * body.body;
  if (body.grounded()) {
    alignas(64) double forces[lanes];
    store(forces, sum);
    with_ground_joint(body.slides, ground_places(body, data, a),
                      [&](auto joint) { joint.go_back(forces, x_body, lambda + body.ground_row); });
  } else if (body.slot >= 0) {
    store_first<6>(x_body, accelerate(body, data, sum));
  }
  if (body.slot >= 0) return leave_for_children(load_first<6>(x_body), body.slot, data);
  if (body.grounded()) return;
  sum += load_first<6>(a + 6 * body.body);
  const MassFactor& factor = data.mass_factors[body.mass_factor];
  if (factor.diagonal) return store_first<6>(x_body, sum * load_first<6>(factor.inverse));
  Vector solution = solve_lower(factor, sum);
  solution -= unit(4) * splat(factor.L54) * lane(solution, 5);
  solution -= unit(3) * (splat(factor.L43) * lane(solution, 4) + splat(factor.L53) * lane(solution, 5));
  store_first<6>(x_body, solution);
}

}  // namespace
}  // namespace linkwork::block
