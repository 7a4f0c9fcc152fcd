#pragma once

#include "linkwork/linear/block/body_kernels.hpp"
#include "linkwork/linear/block/hub_kernels.hpp"

/// The core: closed loops. Joints are eliminated in supernodes, 8 columns at a time.
namespace linkwork::block {
namespace {

/// Numbers of constraint rows; zero for those of hubs.
template <int depth>
LINKWORK_INLINE Vector given(const int* unknown, const double* numbers) {
  static constexpr double nothing = 0.0;
  Vector out = splat(0.0);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k)
    out.set(k, *(unknown[k] >= 0 ? numbers + unknown[k] : &nothing));
  return out;
}

/// Pivots of a front from k0 on against their diagonal entries; those of hubs are negative.
LINKWORK_INLINE void note_pivots(const Front& front, const Data& data, int k0, int depth, Vector pivots,
                                 Vector diagonal, SmallestPivot& smallest) {
  if (front.mixed < 0 && !any_below(pivots, diagonal * splat(clearly_above(smallest)))) return;
  double entries[lanes];
  store(entries, diagonal);
  const int* unknown = data.unknowns + front.unknown + k0;
  for (int k = 0; k < depth; ++k) {
    const double pivot = data.pivots[k0 + k];
    if (unknown[k] >= 0) note(smallest, pivot, entries[k], unknown[k], data);
    else note(smallest, -pivot, 0.0, -1, data);
  }
}

/// LDL^T of `depth` columns from k0 on and of the right-hand side, in the rows that are eliminated. The panel is left
/// with unit L, below 1/d on its diagonal, and D^-1 L^-1 of the right-hand side.
// Long: what it works on are registers from its first line to its last.
template <int depth>
void eliminate(const Front& front, const Data& data, int k0, const double* b, SmallestPivot& smallest) {
  const std::ptrdiff_t stride = front.stride();
  double *panel = data.panels + front.panel + k0 * stride, *right = right_hand_side_of(front, data);
  const int* unknown = data.unknowns + front.unknown + k0;
  Vector T[depth], y = load(right + k0) + given<depth>(unknown, b), solved = splat(0.0), pivots = splat(0.0);
  LINKWORK_UNROLL for (int c = 0; c < depth; ++c)
    T[c] = load(panel + c * stride + k0);
  Vector diagonal = load(diagonal_of(front, data) + k0);
  if (data.compliant) {
    const Vector e = given<depth>(unknown, data.e);
    LINKWORK_UNROLL for (int c = 0; c < depth; ++c)
      T[c] += unit(c) * e;
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
}

/// The rows of these columns from position `first` to before `last`, below what is eliminated: L, and the right-hand
/// side of the rows. With `keeps` the scratch memory is left with L D.
template <int depth, bool keeps>
void eliminate_below(const Front& front, const Data& data, int k0, int first, int last) {
  const std::ptrdiff_t stride = front.stride();
  double *panel = data.panels + front.panel + k0 * stride, *right = right_hand_side_of(front, data);
  for (int p = first; p < last; p += lanes) {
    Vector B[depth], r = load(right + p);
    LINKWORK_UNROLL for (int c = 0; c < depth; ++c)
      B[c] = load(panel + c * stride + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
      const double* L = panel + k * stride + k0;  // factors from memory: the registers are full
      LINKWORK_UNROLL for (int c = k + 1; c < depth; ++c)
        B[c] -= B[k] * splat(L[c]);
      r -= B[k] * splat(right[k0 + k]);
      if constexpr (keeps) store(data.scratch + k * stride + p, B[k]);
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
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) c[w][r] = load(C + w * C_stride + r * lanes);
  for (int k = 0; k < depth; ++k) {
    Vector a[rows];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      a[r] = load(A + k * A_stride + r * lanes);
    LINKWORK_UNROLL for (int w = 0; w < columns; ++w) {
      const Vector factor = splat(B[k * lanes + w]);
      LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
        c[w][r] -= a[r] * factor;
    }
  }
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) store(C + w * C_stride + r * lanes, c[w][r]);
}

/// D L^T of the first `depth` columns at up to 8 columns from position c on.
LINKWORK_INLINE void scale_rows(const Front& front, const Data& data, int depth, int c, double* B) {
  const std::ptrdiff_t stride = front.stride();
  const double* panel = data.panels + front.panel;
  for (int k = 0; k < depth; ++k) store(B + k * lanes, load(panel + k * stride + c) * splat(data.pivots[k]));
}

/// The same for a wide front, whose first `depth` columns are eliminated: up to 8 columns from position c on in the
/// rows from `first` to before `last`, many products before a number is stored again.
void update_rows(const Front& front, const Data& data, int depth, int c, int columns, const double* B, int first,
                 int last) {
  const std::ptrdiff_t stride = front.stride(), C_stride = column_stride(front, c);
  const double* panel = data.panels + front.panel;
  double* C = column_of(front, data, c);
  for (int w = 0; w < columns; w += columns_at_once)
    with_count<columns_at_once>(columns - w < columns_at_once ? columns - w : columns_at_once, [&](auto count) {
      int p = first;
      for (; p + vectors_at_once * lanes <= last; p += vectors_at_once * lanes)
        subtract_product<count, vectors_at_once>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
      for (; p < last; p += lanes)
        subtract_product<count, 1>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
    });
}

LINKWORK_INLINE bool is_shared(const Front& front, const Data& data) {
  return data.helpers.pool && front.stride() >= divisible_front;
}

/// Calls part(k, scratch) for k = 0 .. count - 1, at the same time where there are helpers.
template <class Part>
void share(const Front& front, const Data& data, int count, const Part& part) {
  if (!is_shared(front, data)) {
    for (int k = 0; k < count; ++k) part(k, data.scratch);
    return;
  }
  struct Context {
    const Part* part;
    double* const* scratch;
  } const context{&part, data.helpers.scratch};
  data.helpers.run(
      data.helpers.pool, count,
      [](const void* from, int k, int worker) {
        const Context& it = *static_cast<const Context*>(from);
        (*it.part)(k, it.scratch[worker]);
      },
      &context);
}

/// Eight columns after the other; with helpers some rows at a time, each with what has been eliminated.
void factor_wide(const Front& front, const Data& data, const double* b, SmallestPivot& smallest) {
  constexpr int rows_at_a_time = 16 * lanes;
  const bool shared = is_shared(front, data);
  double* B = data.scratch;
  for (int k0 = 0; k0 < front.width; k0 += lanes) {
    const int columns = depth_at(front, k0), below = k0 + lanes, end = front.stride();
    if (k0 > 0) {
      scale_rows(front, data, k0, k0, B);
      update_rows(front, data, k0, k0, columns, B, k0, shared ? below : end);
    }
    with_count<lanes>(columns, [&](auto depth) {
      eliminate<depth>(front, data, k0, b, smallest);
      if (!shared) return eliminate_below<depth, false>(front, data, k0, below, end);
      share(front, data, (end - below + rows_at_a_time - 1) / rows_at_a_time, [&](int k, double*) {
        const int first = below + k * rows_at_a_time, last = first + rows_at_a_time;
        if (k0 > 0) update_rows(front, data, k0, k0, columns, B, first, last < end ? last : end);
        eliminate_below<depth, false>(front, data, k0, first, last < end ? last : end);
      });
    });
  }
  const int last = front.top + front.size - front.width;
  share(front, data, (last - front.top + lanes - 1) / lanes, [&](int k, double* scratch) {
    const int c = front.top + k * lanes;
    scale_rows(front, data, front.width, c, scratch);
    update_rows(front, data, front.width, c, last - c < lanes ? last - c : lanes, scratch, c, front.stride());
  });
}

void factor_joints(const Front& front, const Data& data, const double* b, SmallestPivot& smallest) {
  if (front.width > lanes) return factor_wide(front, data, b, smallest);
  with_count<lanes>(front.width, [&](auto depth) {
    eliminate<depth>(front, data, 0, b, smallest);
    eliminate_below<depth, true>(front, data, 0, lanes, front.stride());
    update_columns<depth>(front, data);
  });
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

void factor_front(const Front& front, const Data& data, const double* a, const double* b, SmallestPivot& smallest) {
  if (front.childless) clear(front, data);
  for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
    eliminate_body<false>(data.bodies[body], front, data, a, b, smallest);
  if (front.mixed >= 0) {
    add_hubs(front, data.mixed[front.mixed], data);
    add_hub_right_hand_sides(front, data.mixed[front.mixed], data, a);
  }
  factor_joints(front, data, b, smallest);
}

SmallestPivot factor_core(const Data& data, const NodeRange* ranges, int count, const double* a, const double* b) {
  SmallestPivot smallest;
  for (const NodeRange* range = ranges; range < ranges + count; ++range)
    for (int f = range->first; f < range->last; ++f) {
      const Front& front = data.fronts[f];
      if (data.large && f + fronts_ahead < range->last) prefetch_front(data.fronts[f + fronts_ahead], data);
      if (range->handing != Handing::only) factor_front(front, data, a, b, smallest);
      if (front.parent < 0 || range->handing == Handing::later) continue;
      if (front.begins_parent) clear(data.fronts[front.parent], data);
      extend_add(front, data);
    }
  return smallest;
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
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k)
      r -= load(panel + k * stride + p) * y_of[k];
    store(right + p, r);
  }
}

void clear_right(const Front& front, const Data& data) {
  for (int p = 0; p < front.stride(); p += lanes) store(right_hand_side_of(front, data) + p, splat(0.0));
}

void forward_front(const Front& front, const Data& data, const double* a, const double* b) {
  SmallestPivot unchanged;
  if (front.childless) clear_right(front, data);
  for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
    eliminate_body<true>(data.bodies[body], front, data, a, b, unchanged);
  if (front.mixed >= 0) add_hub_right_hand_sides(front, data.mixed[front.mixed], data, a);
  for (int k0 = 0; k0 < front.width; k0 += lanes)
    with_count<lanes>(depth_at(front, k0), [&](auto depth) { forward_block<depth>(front, data, k0, b); });
}

/// The right-hand side part of factor_core.
void forward_core(const Data& data, const NodeRange* ranges, int count, const double* a, const double* b) {
  for (const NodeRange* range = ranges; range < ranges + count; ++range)
    for (int f = range->first; f < range->last; ++f) {
      const Front& front = data.fronts[f];
      if (data.large && f + fronts_ahead < range->last) prefetch_front(data.fronts[f + fronts_ahead], data);
      if (range->handing != Handing::only) forward_front(front, data, a, b);
      if (front.parent < 0 || range->handing == Handing::later) continue;
      const Front& parent = data.fronts[front.parent];
      if (front.begins_parent) clear_right(parent, data);
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
  LINKWORK_UNROLL for (int k = 0; k < 8; ++k)
    products[k] = splat(0.0);
  for (int p = k0 + lanes; p < front.stride(); p += lanes) {
    const Vector known = load(right + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k)
      products[k] += load(panel + k * stride + p) * known;
  }
  Vector x = load(right + k0) - sums<depth>(products);
  Vector L[8];
  LINKWORK_UNROLL for (int k = 0; k < 8; ++k)
    L[k] = k < depth ? load(panel + k * stride + k0) : splat(0.0);
  transpose(L);
  LINKWORK_UNROLL for (int k = depth - 1; k > 0; --k)
    x -= (L[k] * lanes_before(k)) * lane(x, k);
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

void backward_core(const Data& data, const NodeRange* ranges, int count, const double* a, double* x, double* lambda) {
  for (const NodeRange* range = ranges + count; range-- > ranges;) {
    if (range->handing == Handing::only) continue;
    for (int f = range->last; f-- > range->first;) {
      const Front& front = data.fronts[f];
      if (data.large && f >= range->first + fronts_ahead) prefetch_front(data.fronts[f - fronts_ahead], data);
      backward_joints(front, data, x, lambda);
      for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
        backward_body(data.bodies[body], data, a, x, lambda);
    }
  }
}

}  // namespace
}  // namespace linkwork::block
