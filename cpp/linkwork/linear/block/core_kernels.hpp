#pragma once

#include "linkwork/linear/block/common_kernels.hpp"

/// The core: closed loops. Bodies add their part of D M^-1 D^T and of -D M^-1 a to the front of their first joint;
/// joints are eliminated in supernodes, 8 columns at a time.
///
/// A hub, a body with many joints, is eliminated among the joints, for it would couple all of them: then the matrix is
/// [S D; D^T -M] with S of the other bodies, quasi-definite, and pivots of hubs are negative.
namespace linkwork::block {
namespace {

constexpr int fronts_ahead = 3;                         // that are prefetched
constexpr std::ptrdiff_t most_prefetched = 64 * lanes;  // of a front; more would drive out what is needed now
// What the registers hold beside a factor: sums.
constexpr int columns_at_once = width == 8 ? 8 : width == 4 ? 4 : 2, vectors_at_once = width == 8 ? 2 : 1;

LINKWORK_INLINE void prefetch_front(const Front& front, const Data& data) {
  for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
    for (int r = 0; r < data.bodies[body].rows; ++r)
      __builtin_prefetch(data.D + data.rows[data.bodies[body].first_row + r].D);
  const std::ptrdiff_t size = (front.width + 2) * static_cast<std::ptrdiff_t>(front.stride());
  prefetch<true>(data.panels + front.panel, size < most_prefetched ? size : most_prefetched);
}

LINKWORK_INLINE double* right_hand_side_of(const Front& front, const Data& data) {
  return data.panels + front.panel + front.width * static_cast<std::ptrdiff_t>(front.stride());
}
LINKWORK_INLINE double* diagonal_of(const Front& front, const Data& data) {
  return right_hand_side_of(front, data) + front.stride();
}

/// The column at a position, such that its entry at position p is [p]: of the panel, or of the contribution block.
LINKWORK_INLINE double* column_of(const Front& front, const Data& data, int position) {
  if (position < front.top) return data.panels + front.panel + position * static_cast<std::ptrdiff_t>(front.stride());
  return data.contributions + front.contribution +
         (position - front.top) * static_cast<std::ptrdiff_t>(front.contribution_rows) - front.top;
}

/// From a column at a position to the next.
LINKWORK_INLINE std::ptrdiff_t column_stride(const Front& front, int position) {
  return position < front.top ? front.stride() : front.contribution_rows;
}

LINKWORK_INLINE int depth_at(const Front& front, int k0) { return front.width - k0 < lanes ? front.width - k0 : lanes; }

/// Zeros where children and bodies add: the lower triangle, from the vector on that holds the diagonal.
void clear(const Front& front, const Data& data) {
  for (int c = 0; c < front.size; ++c) {
    const int position = c < front.width ? c : c - front.width + front.top;
    double* column = column_of(front, data, position);
    for (int p = position / lanes * lanes; p < front.stride(); p += lanes) store(column + p, splat(0.0));
  }
  double* right = right_hand_side_of(front, data);
  for (int p = 0; p < 2 * front.stride(); p += lanes) store(right + p, splat(0.0));
}

/// C(:, w) = C(:, w) +- sum_k A(:, k) B(k, w) for `columns` columns, `vectors` vectors of rows at the places `at`.
template <int sign, int depth, int columns, int vectors>
LINKWORK_INLINE void add_product(double* C, std::ptrdiff_t C_stride, const int* at, const double* A, const double* B,
                                 std::ptrdiff_t stride) {
  Vector c[columns][vectors];
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int v = 0; v < vectors; ++v) c[w][v] =
      load(C + w * C_stride + at[v]);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    Vector a[vectors];
    LINKWORK_UNROLL for (int v = 0; v < vectors; ++v) a[v] = load(A + k * stride + v * lanes);
    LINKWORK_UNROLL for (int w = 0; w < columns; ++w) {
      const Vector factor = splat(B[k * stride + w]);
      LINKWORK_UNROLL for (int v = 0; v < vectors; ++v) {
        if constexpr (sign > 0) c[w][v] += a[v] * factor;
        else c[w][v] -= a[v] * factor;
      }
    }
  }
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int v = 0; v < vectors; ++v)
      store(C + w * C_stride + at[v], c[w][v]);
}

// --- bodies ----------------------------------------------------------------------------------------------------------

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
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) M[c] = load(articulated + c * lanes);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Vector pivot = lane(M[k], k), inverse = inverse_of_lane(M[k], k);
    if (!(pivot[0] > 0.0)) smallest = {pivot[0] == pivot[0] ? 0.0 : not_a_number, -1};
    const Vector L = M[k] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) M[c] -= M[k] * lane(L, c);
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

/// What [M; D | a] of a body leaves, D M^-1 D^T and -D M^-1 a, is added to the front. With `right_hand_side_only`
/// nothing but the last column.
template <bool branches, bool right_hand_side_only>
void add_body(const CoreBody& body, const Front& front, const Data& data, const double* a) {
  const RowVector* vectors = data.vectors + body.first_vector;
  const std::ptrdiff_t stride = lanes * static_cast<std::ptrdiff_t>(body.vectors);
  double *U = data.scratch, *scaled = U + 6 * stride;  // L^-1 D^T, with and without D^-1
  double *right = right_hand_side_of(front, data), *diagonal = diagonal_of(front, data);
  const double* own = data.factors + body.own_factors;
  const MassFactor* factor = branches ? nullptr : data.mass_factors + body.mass_factor;
  const Vector y = branches ? load(own + 6 * lanes) : solve_lower(*factor, load_first<6>(a + 6 * body.body));
  for (int v = 0; v < body.vectors; ++v) LINKWORK_UNROLL for (int first = 0; first < lanes; first += width) {
      Native B[6], r{}, d{};
      gather_D(vectors[v].D + first, data, B);
      if constexpr (branches) {
        LINKWORK_UNROLL for (int k = 0; k < 6; ++k) LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) B[c] -=
            B[k] * splat_native(own[k * lanes + c]);
      } else {
        B[4] -= B[3] * splat_native(factor->L43);
        B[5] -= B[3] * splat_native(factor->L53) + B[4] * splat_native(factor->L54);
      }
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
        r -= B[k] * lane(y, k).part[0];
        if constexpr (right_hand_side_only) continue;
        const Native L = B[k] * splat_native(branches ? own[k * (lanes + 1)] : factor->inverse[k]);
        d += B[k] * L;
        store_native(U + k * stride + v * lanes + first, B[k]);
        store_native(scaled + k * stride + v * lanes + first, L);
      }
      const int position = vectors[v].position + first;
      store_native(right + position, load_native(right + position) + r);
      if constexpr (!right_hand_side_only) store_native(diagonal + position, load_native(diagonal + position) + d);
    }
}

/// The columns of D M^-1 D^T, from their diagonal on.
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
          add_product<1, 6, columns, vectors_at_once>(C, C_stride, at, U + v * lanes, scaled + begin, stride);
        }
        if (v < body.vectors)
          add_product<1, 6, columns, 1>(C, C_stride, &vectors[v].position, U + v * lanes, scaled + begin, stride);
      });
    }
  }
}

void factor_body(const CoreBody& body, const Front& front, const Data& data, const double* a, SmallestPivot& smallest) {
  if (body.slot >= 0) {
    factor_mass(body, data, smallest);
    add_body<true, false>(body, front, data, a);
  } else {
    add_body<false, false>(body, front, data, a);
  }
  add_body_columns(body, front, data);
}

void forward_body(const CoreBody& body, const Front& front, const Data& data, const double* a) {
  if (body.slot >= 0) {
    SmallestPivot unchanged;
    factor_mass(body, data, unchanged);
    add_body<true, true>(body, front, data, a);
  } else {
    add_body<false, true>(body, front, data, a);
  }
}

/// x = M^-1 (a + D^T lambda).
void backward_body(const CoreBody& body, const Data& data, const double* a, double* x, const double* lambda) {
  const BodyRow* rows = data.rows + body.first_row;
  Vector sum = splat(0.0), odd = splat(0.0);
  int r = 0;
  for (; r + 1 < body.rows; r += 2) {
    sum += load_first<6>(data.D + rows[r].D) * splat(lambda[rows[r].row]);
    odd += load_first<6>(data.D + rows[r + 1].D) * splat(lambda[rows[r + 1].row]);
  }
  if (r < body.rows) sum += load_first<6>(data.D + rows[r].D) * splat(lambda[rows[r].row]);
  sum += odd;
  if (body.slot >= 0) {
    const double* own = data.factors + body.own_factors;
    Vector L[8], solution = load(own + 6 * lanes);
    LINKWORK_UNROLL for (int k = 0; k < 8; ++k) L[k] = k < 6 ? load(own + k * lanes) : splat(0.0);
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
      const Vector known = lane(sum, k);
      solution += unit(k) * L[k] * known;
      sum -= L[k] * lanes_after(k) * known;
    }
    transpose(L);
    LINKWORK_UNROLL for (int k = 5; k > 0; --k) solution -= (L[k] * lanes_before(k)) * lane(solution, k);
    store_first<6>(x + 6 * body.body, solution);
    return leave_for_children(solution, body.slot, data);
  }
  sum += load_first<6>(a + 6 * body.body);
  const MassFactor& factor = data.mass_factors[body.mass_factor];
  if (factor.diagonal) return store_first<6>(x + 6 * body.body, sum * load_first<6>(factor.inverse));
  Vector solution = solve_lower(factor, sum);
  solution -= unit(4) * splat(factor.L54) * lane(solution, 5);
  solution -= unit(3) * (splat(factor.L43) * lane(solution, 4) + splat(factor.L53) * lane(solution, 5));
  store_first<6>(x + 6 * body.body, solution);
}

// --- hubs ------------------------------------------------------------------------------------------------------------

LINKWORK_INLINE Vector column_of_mass(int body, int slot, int c, const Data& data) {
  if (slot >= 0) return load(data.articulated_inertias + slot * articulated_inertia_size + c * lanes);
  return mass_column(data.mass[body], c, 0.0);
}

/// -M of hubs and their D, into the lower triangle.
void add_hubs(const Front& front, const MixedFront& mixed, const Data& data) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const Hub& hub = data.hubs[h];
    for (int c = 0; c < 6; ++c) {
      const Vector column = column_of_mass(hub.body, hub.slot, c, data);
      double* to = column_of(front, data, hub.position + c) + hub.position;
      for (int r = c; r < 6; ++r) to[r] -= column[r];
    }
  }
  for (int k = mixed.first_coupling; k < mixed.first_coupling + mixed.couplings; ++k) {
    const Coupling& coupling = data.couplings[k];
    const double* D = data.D + coupling.D;
    const bool hub_first = coupling.hub < coupling.joint;
    for (int r = 0; r < coupling.rows; ++r)
      for (int c = 0; c < 6; ++c) {
        const int joint = coupling.joint + r, hub = coupling.hub + c;
        column_of(front, data, hub_first ? hub : joint)[hub_first ? joint : hub] += D[6 * r + c];
      }
  }
}

/// -a of hubs.
void add_hub_right_hand_sides(const Front& front, const MixedFront& mixed, const Data& data, const double* a) {
  double* right = right_hand_side_of(front, data);
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const Hub& hub = data.hubs[h];
    for (int k = 0; k < 6; ++k)
      right[hub.position + k] -=
          hub.slot < 0 ? a[6 * hub.body + k]
                       : data.articulated_inertias[hub.slot * articulated_inertia_size + k * lanes + right_hand_side];
  }
}

// --- joints ----------------------------------------------------------------------------------------------------------

/// Numbers of constraint rows; zero for those of hubs.
template <int depth>
LINKWORK_INLINE Vector given(const int* unknown, const double* numbers) {
  static constexpr double nothing = 0.0;
  Vector out = splat(0.0);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) out.set(k, *(unknown[k] >= 0 ? numbers + unknown[k] : &nothing));
  return out;
}

/// Pivots of a front from k0 on against their diagonal entries; those of hubs are negative.
LINKWORK_INLINE void note_pivots(const Front& front, const Data& data, int k0, int depth, Vector pivots,
                                 Vector diagonal, SmallestPivot& smallest) {
  if (front.mixed < 0 && !any_below(pivots, diagonal * splat(smallest.ratio))) return;
  double entries[lanes];
  store(entries, diagonal);
  const int* unknown = data.unknowns + front.unknown + k0;
  for (int k = 0; k < depth; ++k) {
    const double pivot = data.pivots[k0 + k];
    if (unknown[k] >= 0) note(smallest, pivot, entries[k], unknown[k], data);
    else note(smallest, -pivot, 0.0, -1, data);
  }
}

/// LDL^T of `depth` columns from k0 on and of the right-hand side. The panel is left with unit L, below 1/d on its
/// diagonal, and D^-1 L^-1 of the right-hand side; the scratch memory with L D.
template <int depth>
void eliminate(const Front& front, const Data& data, int k0, const double* b, SmallestPivot& smallest) {
  const std::ptrdiff_t stride = front.stride();
  double *panel = data.panels + front.panel + k0 * stride, *right = right_hand_side_of(front, data);
  const int* unknown = data.unknowns + front.unknown + k0;
  Vector T[depth], y = load(right + k0) + given<depth>(unknown, b), solved = splat(0.0), pivots = splat(0.0);
  LINKWORK_UNROLL for (int c = 0; c < depth; ++c) T[c] = load(panel + c * stride + k0);
  Vector diagonal = load(diagonal_of(front, data) + k0);
  if (data.compliant) {
    const Vector e = given<depth>(unknown, data.e);
    LINKWORK_UNROLL for (int c = 0; c < depth; ++c) T[c] += unit(c) * e;
    diagonal += e;
  }
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    const Vector pivot = lane(T[k], k), inverse = inverse_of_lane(T[k], k), L = T[k] * inverse;
    const Vector z = lane(y, k) * inverse;
    pivots = with_lane(pivots, pivot, k);
    solved = with_lane(solved, z, k);
    LINKWORK_UNROLL for (int c = k + 1; c < depth; ++c) {
      if (c == k + 1) T[c] -= (T[k] * lane(T[k], c)) * inverse;
      else T[c] -= T[k] * lane(L, c);
    }
    y -= T[k] * z;
    store(panel + k * stride + k0, with_lane(L, inverse, k));
  }
  store(data.pivots + k0, pivots);
  store(right + k0, solved);
  note_pivots(front, data, k0, depth, pivots, diagonal, smallest);
  for (int p = k0 + lanes; p < front.stride(); p += lanes) {
    Vector B[depth], r = load(right + p);
    LINKWORK_UNROLL for (int c = 0; c < depth; ++c) B[c] = load(panel + c * stride + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
      const double* L = panel + k * stride + k0;  // factors from memory: the registers are full
      LINKWORK_UNROLL for (int c = k + 1; c < depth; ++c) B[c] -= B[k] * splat(L[c]);
      r -= B[k] * splat(right[k0 + k]);
      store(data.scratch + k * stride + p, B[k]);
      store(panel + k * stride + p, B[k] * splat(L[k]));
    }
    store(right + p, r);
  }
}

/// The kept columns of a front of up to 8 columns, from their diagonal on: C -= U L^T, with U unscaled in the scratch
/// memory and L in the panel.
template <int depth>
void update_columns(const Front& front, const Data& data) {
  const std::ptrdiff_t stride = front.stride();
  const double* L = data.panels + front.panel;
  const int last = front.top + front.size - front.width;
  for (int c = front.top; c < last; c += columns_at_once) {
    double* C = column_of(front, data, c);
    with_count<columns_at_once>(last - c < columns_at_once ? last - c : columns_at_once, [&](auto columns) {
      int p = c / lanes * lanes;
      for (; p + vectors_at_once * lanes <= stride; p += vectors_at_once * lanes) {
        const int at[2] = {p, p + lanes};
        add_product<-1, depth, columns, vectors_at_once>(C, front.contribution_rows, at, data.scratch + p, L + c,
                                                         stride);
      }
      if (p < stride)
        add_product<-1, depth, columns, 1>(C, front.contribution_rows, &p, data.scratch + p, L + c, stride);
    });
  }
}

/// C(:, w) -= sum_k A(:, k) B(k, w) over `depth` columns; B row after row.
template <int columns, int rows>
LINKWORK_INLINE void subtract_product(double* C, std::ptrdiff_t C_stride, const double* A, std::ptrdiff_t A_stride,
                                      const double* B, int depth) {
  Vector c[columns][rows];
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int r = 0; r < rows; ++r) c[w][r] =
      load(C + w * C_stride + r * lanes);
  for (int k = 0; k < depth; ++k) {
    Vector a[rows];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r) a[r] = load(A + k * A_stride + r * lanes);
    LINKWORK_UNROLL for (int w = 0; w < columns; ++w) {
      const Vector factor = splat(B[k * lanes + w]);
      LINKWORK_UNROLL for (int r = 0; r < rows; ++r) c[w][r] -= a[r] * factor;
    }
  }
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      store(C + w * C_stride + r * lanes, c[w][r]);
}

/// The same for a wide front, whose first `depth` columns are eliminated, for up to 8 columns from position c on: many
/// products before a number is stored again.
void update_eight_columns(const Front& front, const Data& data, int depth, int c, int columns) {
  const std::ptrdiff_t stride = front.stride(), C_stride = column_stride(front, c);
  const double* panel = data.panels + front.panel;
  double *B = data.scratch, *C = column_of(front, data, c);  // B: D L^T, `lanes` columns of it
  for (int k = 0; k < depth; ++k) store(B + k * lanes, load(panel + k * stride + c) * splat(data.pivots[k]));
  for (int w = 0; w < columns; w += columns_at_once)
    with_count<columns_at_once>(columns - w < columns_at_once ? columns - w : columns_at_once, [&](auto count) {
      int p = c;
      for (; p + vectors_at_once * lanes <= stride; p += vectors_at_once * lanes)
        subtract_product<count, vectors_at_once>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
      if (p < stride) subtract_product<count, 1>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
    });
}

void factor_joints(const Front& front, const Data& data, const double* b, SmallestPivot& smallest) {
  if (front.width <= lanes)
    return with_count<lanes>(front.width, [&](auto depth) {
      eliminate<depth>(front, data, 0, b, smallest);
      update_columns<depth>(front, data);
    });
  for (int k0 = 0; k0 < front.width; k0 += lanes) {
    if (k0 > 0) update_eight_columns(front, data, k0, k0, depth_at(front, k0));
    with_count<lanes>(depth_at(front, k0), [&](auto depth) { eliminate<depth>(front, data, k0, b, smallest); });
  }
  const int last = front.top + front.size - front.width;
  for (int c = front.top; c < last; c += lanes)
    update_eight_columns(front, data, front.width, c, last - c < lanes ? last - c : lanes);
}

/// Adds the kept part of a column to the same rows of the parent's.
LINKWORK_INLINE void add_column(const Front& front, const Data& data, const double* from, double* to) {
  const RelativeIndices* relative = data.relative_indices + front.first_relative_indices;
  for (int s = 0; s < front.relative_indices; ++s)
    add(to + relative[s].parent_begin, from + front.top + relative[s].begin, relative[s].length);
}

/// Extend-add: a front's contribution block to its parent, run by run.
void extend_add(const Front& front, const Data& data) {
  const Front& parent = data.fronts[front.parent];
  const RelativeIndices* relative = data.relative_indices + front.first_relative_indices;
  for (int s = 0; s < front.relative_indices; ++s)
    for (int c = 0; c < relative[s].length; ++c) {
      const double* from = data.contributions + front.contribution +
                           (relative[s].begin + c) * static_cast<std::ptrdiff_t>(front.contribution_rows);
      double* to = column_of(parent, data, relative[s].parent_begin + c);
      add(to + relative[s].parent_begin + c, from + relative[s].begin + c, relative[s].length - c);
      for (int t = s + 1; t < front.relative_indices; ++t)
        add(to + relative[t].parent_begin, from + relative[t].begin, relative[t].length);
    }
  add_column(front, data, right_hand_side_of(front, data), right_hand_side_of(parent, data));
  add_column(front, data, diagonal_of(front, data), diagonal_of(parent, data));
}

void factor_core(const Data& data, const double* a, const double* b, SmallestPivot& smallest) {
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    if (data.large && f + fronts_ahead < data.front_count) prefetch_front(data.fronts[f + fronts_ahead], data);
    if (front.childless) clear(front, data);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      factor_body(data.bodies[body], front, data, a, smallest);
    if (front.mixed >= 0) {
      add_hubs(front, data.mixed[front.mixed], data);
      add_hub_right_hand_sides(front, data.mixed[front.mixed], data, a);
    }
    factor_joints(front, data, b, smallest);
    if (front.parent < 0) continue;
    if (front.begins_parent) clear(data.fronts[front.parent], data);
    extend_add(front, data);
  }
}

template <int depth>
void forward_block(const Front& front, const Data& data, int k0, const double* b) {
  const std::ptrdiff_t stride = front.stride();
  double* right = right_hand_side_of(front, data);
  const double* panel = data.panels + front.panel + k0 * stride;
  Vector y = load(right + k0) + given<depth>(data.unknowns + front.unknown + k0, b), solved = splat(0.0), y_of[depth];
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    const Vector L = load(panel + k * stride + k0);
    y_of[k] = lane(y, k);
    solved += unit(k) * L * y_of[k];
    y -= L * lanes_after(k) * y_of[k];
  }
  store(right + k0, solved);
  for (int p = k0 + lanes; p < front.stride(); p += lanes) {
    Vector r = load(right + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k) r -= load(panel + k * stride + p) * y_of[k];
    store(right + p, r);
  }
}

/// The right-hand side part of factor_core.
void forward_core(const Data& data, const double* a, const double* b) {
  const auto clear_right = [&](const Front& front) {
    for (int p = 0; p < front.stride(); p += lanes) store(right_hand_side_of(front, data) + p, splat(0.0));
  };
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    if (data.large && f + fronts_ahead < data.front_count) prefetch_front(data.fronts[f + fronts_ahead], data);
    if (front.childless) clear_right(front);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      forward_body(data.bodies[body], front, data, a);
    if (front.mixed >= 0) add_hub_right_hand_sides(front, data.mixed[front.mixed], data, a);
    for (int k0 = 0; k0 < front.width; k0 += lanes)
      with_count<lanes>(depth_at(front, k0), [&](auto depth) { forward_block<depth>(front, data, k0, b); });
    if (front.parent < 0) continue;
    const Front& parent = data.fronts[front.parent];
    if (front.begins_parent) clear_right(parent);
    add_column(front, data, right_hand_side_of(front, data), right_hand_side_of(parent, data));
  }
}

/// Leaves the solution where the right-hand side was: own unknowns and those that the front kept.
template <int depth>
void backward_block(const Front& front, const Data& data, int k0) {
  const std::ptrdiff_t stride = front.stride();
  double* right = right_hand_side_of(front, data);
  const double* panel = data.panels + front.panel + k0 * stride;
  Vector products[8];
  LINKWORK_UNROLL for (int k = 0; k < 8; ++k) products[k] = splat(0.0);
  for (int p = k0 + lanes; p < front.stride(); p += lanes) {
    const Vector known = load(right + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k) products[k] += load(panel + k * stride + p) * known;
  }
  Vector x = load(right + k0) - sums<depth>(products);
  Vector L[8];
  LINKWORK_UNROLL for (int k = 0; k < 8; ++k) L[k] = k < depth ? load(panel + k * stride + k0) : splat(0.0);
  transpose(L);
  LINKWORK_UNROLL for (int k = depth - 1; k > 0; --k) x -= (L[k] * lanes_before(k)) * lane(x, k);
  store(right + k0, x);
}

/// to[k] = from[k] for k < count, and some behind: whole vectors can be read again at once.
LINKWORK_INLINE void copy_vectors(double* to, const double* from, int count) {
  for (int k = 0; k < count; k += lanes) store(to + k, load(from + k));
}

/// Numbers in the lanes behind the kept ones meet zeros in the panel. The diagonal, behind them, is no longer needed.
void backward_joints(const Front& front, const Data& data, double* x, double* lambda) {
  double* right = right_hand_side_of(front, data);
  if (front.parent >= 0) {
    const double* known = right_hand_side_of(data.fronts[front.parent], data);
    const RelativeIndices* relative = data.relative_indices + front.first_relative_indices;
    for (int s = 0; s < front.relative_indices; ++s)
      copy_vectors(right + front.top + relative[s].begin, known + relative[s].parent_begin, relative[s].length);
  }
  for (int k0 = (front.width - 1) / lanes * lanes; k0 >= 0; k0 -= lanes)
    with_count<lanes>(depth_at(front, k0), [&](auto depth) { backward_block<depth>(front, data, k0); });
  for (int k = 0; k < front.width; ++k) {
    const int unknown = data.unknowns[front.unknown + k];
    (unknown >= 0 ? lambda[unknown] : x[~unknown]) = right[k];
  }
  if (front.mixed < 0) return;
  const MixedFront& mixed = data.mixed[front.mixed];
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h)
    if (data.hubs[h].slot >= 0) leave_for_children(load_first<6>(x + 6 * data.hubs[h].body), data.hubs[h].slot, data);
}

void backward_core(const Data& data, const double* a, double* x, double* lambda) {
  for (std::ptrdiff_t f = data.front_count; f-- > 0;) {
    const Front& front = data.fronts[f];
    if (data.large && f >= fronts_ahead) prefetch_front(data.fronts[f - fronts_ahead], data);
    backward_joints(front, data, x, lambda);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      backward_body(data.bodies[body], data, a, x, lambda);
  }
}

}  // namespace
}  // namespace linkwork::block
