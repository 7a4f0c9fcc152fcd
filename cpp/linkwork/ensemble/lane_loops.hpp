#pragma once

#include "linkwork/ensemble/lane_elimination.hpp"

/// Closed loops of all lanes: the equations of block/body_kernels.hpp and block/core_kernels.hpp, and their order of
/// operations, element by element.
namespace linkwork {
namespace {

using block::CoreBody;
using block::Front;
using block::RelativeIndices;

constexpr int at_once = 8;  // columns that are eliminated together, which decides on the order of operations

/// Where the numbers of a front stand.
struct FrontPlace {
  const Front& front;
  double* panel;
  double* contribution;

  LINKWORK_INLINE FrontPlace(const Front& f, const LaneData& data)
      : front(f), panel(data.panels + f.panel * width), contribution(data.contributions + f.contribution * width) {}
  /// The column at a position, such that its entry at position p is number p.
  LINKWORK_INLINE double* column(int position) const {
    if (position < front.top) return panel + static_cast<std::ptrdiff_t>(position) * front.stride() * width;
    return contribution +
           (static_cast<std::ptrdiff_t>(position - front.top) * front.contribution_rows - front.top) * width;
  }
  LINKWORK_INLINE double* right() const {
    return panel + static_cast<std::ptrdiff_t>(front.width) * front.stride() * width;
  }
  LINKWORK_INLINE double* diagonal() const { return right() + static_cast<std::ptrdiff_t>(front.stride()) * width; }
  LINKWORK_INLINE int last() const { return front.top + front.size - front.width; }  ///< behind the kept ones
  /// The next position that is in use.
  LINKWORK_INLINE int next(int position) const { return position + 1 == front.width ? front.top : position + 1; }
};

void clear_list(double* list, const FrontPlace& at) {
  for (int p = 0; p < at.last(); p = at.next(p)) put(list, p, Native{});
}

void clear(const Front& front, const LaneData& data) {
  const FrontPlace at(front, data);
  for (int c = 0; c < at.last(); c = at.next(c)) {
    double* column = at.column(c);
    for (int p = c; p < at.last(); p = at.next(p)) put(column, p, Native{});
  }
  clear_list(at.right(), at);
  clear_list(at.diagonal(), at);
}

/// M = L D L^T of a body with branches, with D^-1 L^-1 a: unit L with 1/d on its diagonal, then the other.
void factor_mass(const CoreBody& body, const LaneData& data, SmallestPivots& smallest) {
  const double* from = data.articulated_inertias + body.slot * articulated * std::ptrdiff_t{width};
  double* own = data.factors + body.own_factors * width;
  Native M[6][7];
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = c; r < 7; ++r) M[c][r] = get(from, 8 * c + r);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Native pivot = M[k][k], inverse = 1.0 / pivot;
    smallest.note_mass(pivot);
    Native L[7];
    LINKWORK_UNROLL for (int r = k + 1; r < 7; ++r)
      L[r] = M[k][r] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) LINKWORK_UNROLL
      for (int r = c; r < 7; ++r) M[c][r] -= M[k][r] * L[c];
    put(own, 8 * k + k, inverse);
    LINKWORK_UNROLL for (int r = k + 1; r < 6; ++r)
      put(own, 8 * k + r, L[r]);
    put(own, 48 + k, L[right_hand_side]);
  }
}

/// D^-1 L^-1 a of a body without branches.
LINKWORK_INLINE void solve_lower(const double* factor, Native* a) {
  a[4] -= a[3] * get(factor, 0);
  a[5] -= a[3] * get(factor, 1);
  a[5] -= a[4] * get(factor, 2);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    a[k] *= get(factor, 3 + k);
}

LINKWORK_INLINE const double* mass_factor_of(const CoreBody& body, const LaneData& data) {
  return data.mass_factors + 9l * width * body.mass_factor;
}

/// L^-1 of a row of D, and the diagonal D of the factors.
template <bool branches>
LINKWORK_INLINE void reduce_row(const double* D, const double* own, const double* factor, Native* B) {
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    B[k] = get(D, k);
  if constexpr (branches) {
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) LINKWORK_UNROLL
      for (int c = k + 1; c < 6; ++c) B[c] -= B[k] * get(own, 8 * k + c);
  } else {
    B[4] -= B[3] * get(factor, 0);
    B[5] -= B[3] * get(factor, 1) + B[4] * get(factor, 2);
  }
}

/// What a body leaves of its right-hand side, and with it L^-1 D^T and D^-1 L^-1 D^T of its rows, in the scratch memory.
template <bool branches, bool right_hand_side_only>
void add_body(const CoreBody& body, const FrontPlace& at, const LaneData& data, const double* a) {
  double *right = at.right(), *diagonal = at.diagonal(), *U = data.scratch;
  const double* own = data.factors + body.own_factors * width;
  const double* factor = branches ? nullptr : mass_factor_of(body, data);
  Native y[6];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    y[k] = branches ? get(own, 48 + k) : get(a, 6l * body.body + k);
  if constexpr (!branches) solve_lower(factor, y);
  for (int row = body.first_row; row < body.first_row + body.rows; ++row, U += 12l * width) {
    Native B[6], r{}, d{};
    reduce_row<branches>(data.D + data.rows[row].D * width, own, factor, B);
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
      r -= B[k] * y[k];
      if constexpr (right_hand_side_only) continue;
      const Native L = B[k] * (branches ? get(own, 9 * k) : get(factor, 3 + k));
      d += B[k] * L;
      put(U, k, B[k]);
      put(U, 6 + k, L);
    }
    const int position = data.row_positions[row];
    put(right, position, get(right, position) + r);
    if constexpr (!right_hand_side_only) put(diagonal, position, get(diagonal, position) + d);
  }
}

/// The columns of D M^-1 D^T, from their diagonal on.
void add_body_columns(const CoreBody& body, const FrontPlace& at, const LaneData& data) {
  const int* positions = data.row_positions + body.first_row;
  for (int j = 0; j < body.rows; ++j) {
    Native scaled[6];
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
      scaled[k] = get(data.scratch, 12l * j + 6 + k);
    double* C = at.column(positions[j]);
    for (int i = j; i < body.rows; ++i) {
      Native sum = get(C, positions[i]);
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
        sum += get(data.scratch, 12l * i + k) * scaled[k];
      put(C, positions[i], sum);
    }
  }
}

template <bool right_hand_side_only>
void eliminate_body(const CoreBody& body, const FrontPlace& at, const LaneData& data, const double* a,
                    SmallestPivots& smallest) {
  if (body.slot >= 0) {
    factor_mass(body, data, smallest);
    add_body<true, right_hand_side_only>(body, at, data, a);
  } else {
    add_body<false, right_hand_side_only>(body, at, data, a);
  }
  if constexpr (!right_hand_side_only) add_body_columns(body, at, data);
}

LINKWORK_INLINE Native given(int unknown, const double* b) { return get(b, unknown); }

/// Entries p, p + 1, ... of column c of a front less what the columns before it take: those of earlier blocks by L and
/// D L^T, those of its own by U and L, the last in another order where `of_block`, the rows of the block itself.
struct ColumnUpdate {
  const double* panel;  ///< L
  const double* U;      ///< of this block, scratch
  std::ptrdiff_t stride;
  const Native* DL;  ///< of the columns before the block: d_k L(c, k)
  const Native* L;   ///< of the columns of the block: L(c, k)
  Native last, last_inverse;
  int k0, c;

  template <int rows, bool of_block>
  LINKWORK_INLINE void apply(double* column, int p) const {
    Native sum[rows];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      sum[r] = get(column, p + r);
    const double* from = panel + static_cast<std::ptrdiff_t>(p) * width;
    for (int k = 0; k < k0; ++k, from += stride * width) LINKWORK_UNROLL
      for (int r = 0; r < rows; ++r) sum[r] -= get(from, r) * DL[k];
    const double* unscaled = U + static_cast<std::ptrdiff_t>(p) * width;
    const int general = of_block && c > k0 ? c - 1 : c;
    for (int k = k0; k < general; ++k, unscaled += stride * width) LINKWORK_UNROLL
      for (int r = 0; r < rows; ++r) sum[r] -= get(unscaled, r) * L[k - k0];
    if (of_block && c > k0) LINKWORK_UNROLL
      for (int r = 0; r < rows; ++r) sum[r] -= (get(unscaled, r) * last) * last_inverse;
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      put(column, p + r, sum[r]);
  }
  template <bool of_block>
  LINKWORK_INLINE void apply_from(double* column, int p, int end) const {
    by_eights(p, end, [&](auto rows, int q) { apply<rows, of_block>(column, q); });
  }
};

/// LDL^T of the eliminated columns and of the right-hand side: the panel is left with unit L, below 1/d on its
/// diagonal, and D^-1 L^-1 of the right-hand side; `U` with L D of the last block; `pivots` with D.
// Long: one column from its sums to its factor.
void eliminate(const FrontPlace& at, const LaneData& data, const double* b, double* U_all, double* pivots,
               SmallestPivots& smallest) {
  const Front& front = at.front;
  const std::ptrdiff_t stride = front.stride();
  double* right = at.right();
  Native DL[512], L[at_once];  // fronts are not wider: see Pack
  for (int c = 0; c < front.width; ++c) {
    const int k0 = c / at_once * at_once;
    const int block_end = k0 + at_once < front.width ? k0 + at_once : front.width;
    double* column = at.column(c);
    double* U = U_all - static_cast<std::ptrdiff_t>(k0) * stride * width;  // column k of the block at k stride
    for (int k = 0; k < k0; ++k) DL[k] = get(at.panel, k * stride + c) * get(pivots, k);
    for (int k = k0; k < c; ++k) L[k - k0] = get(at.panel, k * stride + c);
    ColumnUpdate update{at.panel, U + k0 * stride * width, stride, DL, L, Native{}, Native{}, k0, c};
    if (c > k0) {
      update.last = get(U, (c - 1) * stride + c);
      update.last_inverse = get(at.panel, (c - 1) * stride + c - 1);
    }
    update.apply_from<true>(column, c, block_end);
    update.apply_from<false>(column, block_end, front.width);
    update.apply_from<false>(column, front.top, at.last());
    if (c == k0)
      for (int k = k0; k < block_end; ++k) put(right, k, get(right, k) + given(data.unknowns[front.unknown + k], b));
    const Native pivot = get(column, c), inverse = 1.0 / pivot;
    const Native z = get(right, c) * inverse;
    put(pivots, c, pivot);
    for (int p = at.next(c); p < at.last(); p = at.next(p)) {
      const Native u = get(column, p);
      put(U, c * stride + p, u);
      put(column, p, u * inverse);
      put(right, p, get(right, p) - u * z);
    }
    put(column, c, inverse);
    put(right, c, z);
    smallest.note(pivot, get(at.diagonal(), c));
  }
}

/// Entries of a kept column less the products of all columns: U L^T of a narrow front, L (D L^T) of a wide one.
template <int rows>
LINKWORK_INLINE void subtract_products(double* column, int p, const double* A, std::ptrdiff_t stride, int depth,
                                       const Native* factors) {
  Native sum[rows];
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
    sum[r] = get(column, p + r);
  A += static_cast<std::ptrdiff_t>(p) * width;
  for (int k = 0; k < depth; ++k, A += stride * width) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) sum[r] -= get(A, r) * factors[k];
  LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
    put(column, p + r, sum[r]);
}

void update_kept(const FrontPlace& at, const double* U, const double* pivots) {
  const Front& front = at.front;
  const std::ptrdiff_t stride = front.stride();
  const bool narrow = front.width <= at_once;
  Native factors[512];
  for (int c = front.top; c < at.last(); ++c) {
    for (int k = 0; k < front.width; ++k) {
      const Native L = get(at.panel, k * stride + c);
      factors[k] = narrow ? L : L * get(pivots, k);
    }
    const double* A = narrow ? U : at.panel;
    double* column = at.column(c);
    by_eights(c, at.last(),
              [&](auto rows, int p) { subtract_products<rows>(column, p, A, stride, front.width, factors); });
  }
}

/// Adds the kept part of a list to the same rows of the parent's.
void add_list(const Front& front, const LaneData& data, const double* from, double* to) {
  const RelativeIndices* relative = data.relative_indices + front.first_relative_indices;
  for (int s = 0; s < front.relative_indices; ++s)
    for (int k = 0; k < relative[s].length; ++k)
      put(to, relative[s].parent_begin + k,
          get(to, relative[s].parent_begin + k) + get(from, front.top + relative[s].begin + k));
}

/// A front's contribution block to its parent, run by run.
void extend_add(const FrontPlace& at, const FrontPlace& parent, const LaneData& data) {
  const RelativeIndices* relative = data.relative_indices + at.front.first_relative_indices;
  for (int s = 0; s < at.front.relative_indices; ++s)
    for (int c = 0; c < relative[s].length; ++c) {
      const double* from = at.column(at.front.top + relative[s].begin + c);
      double* to = parent.column(relative[s].parent_begin + c);
      for (int t = s; t < at.front.relative_indices; ++t)
        for (int k = t == s ? c : 0; k < relative[t].length; ++k)
          put(to, relative[t].parent_begin + k,
              get(to, relative[t].parent_begin + k) + get(from, at.front.top + relative[t].begin + k));
    }
  add_list(at.front, data, at.right(), parent.right());
  add_list(at.front, data, at.diagonal(), parent.diagonal());
}

/// Scratch memory beyond that of bodies: see LaneData.
struct EliminationScratch {
  double *U, *pivots;
};

void factor_loops(const LaneData& data, const double* a, const double* b, const EliminationScratch& scratch,
                  SmallestPivots& smallest) {
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    const FrontPlace at(front, data);
    if (front.childless) clear(front, data);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      eliminate_body<false>(data.bodies[body], at, data, a, smallest);
    eliminate(at, data, b, scratch.U, scratch.pivots, smallest);
    update_kept(at, scratch.U, scratch.pivots);
    if (front.parent < 0) continue;
    const FrontPlace parent(data.fronts[front.parent], data);
    if (front.begins_parent) clear(parent.front, data);
    extend_add(at, parent, data);
  }
}

void forward_joints(const FrontPlace& at, const LaneData& data, const double* b) {
  const Front& front = at.front;
  const std::ptrdiff_t stride = front.stride();
  double* right = at.right();
  for (int k = 0; k < front.width; ++k) {
    if (k % at_once == 0)
      for (int j = k; j < k + at_once && j < front.width; ++j)
        put(right, j, get(right, j) + given(data.unknowns[front.unknown + j], b));
    const Native y = get(right, k);
    const double* L = at.panel + k * stride * width;
    for (int p = at.next(k); p < at.last(); p = at.next(p)) put(right, p, get(right, p) - get(L, p) * y);
    put(right, k, get(L, k) * y);
  }
}

void forward_loops(const LaneData& data, const double* a, const double* b) {
  SmallestPivots unchanged;
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    const FrontPlace at(front, data);
    if (front.childless) clear_list(at.right(), at);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      eliminate_body<true>(data.bodies[body], at, data, a, unchanged);
    forward_joints(at, data, b);
    if (front.parent < 0) continue;
    const FrontPlace parent(data.fronts[front.parent], data);
    if (front.begins_parent) clear_list(parent.right(), parent);
    add_list(front, data, at.right(), parent.right());
  }
}

template <int count>
LINKWORK_INLINE void add_some_products(const double* L, const double* right, int p, Native* products) {
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    products[k] += get(L, p + k) * get(right, p + k);
}

/// Products of the entries from position p on, a multiple of `at_once`, with those of the solution.
LINKWORK_INLINE void add_products(const double* L, const double* right, int p, int end, Native* products) {
  by_eights(p, end, [&](auto count, int q) { add_some_products<count>(L, right, q, products); });
}

/// L^-T of the rows of a block among themselves.
template <int count>
LINKWORK_INLINE void backward_block(const FrontPlace& at, int k0) {
  const std::ptrdiff_t stride = at.front.stride();
  Native x[count];
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    x[k] = get(at.right(), k0 + k);
  LINKWORK_UNROLL for (int k = count - 1; k > 0; --k) LINKWORK_UNROLL
    for (int j = 0; j < k; ++j) x[j] -= get(at.panel, (k0 + j) * stride + k0 + k) * x[k];
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    put(at.right(), k0 + k, x[k]);
}

/// Leaves the solution where the right-hand side was: own unknowns and those that the front kept.
void backward_joints(const FrontPlace& at, const LaneData& data, double* lambda) {
  const Front& front = at.front;
  const std::ptrdiff_t stride = front.stride();
  double* right = at.right();
  if (front.parent >= 0) {
    const double* known = FrontPlace(data.fronts[front.parent], data).right();
    const RelativeIndices* relative = data.relative_indices + front.first_relative_indices;
    for (int s = 0; s < front.relative_indices; ++s)
      for (int k = 0; k < relative[s].length; ++k)
        put(right, front.top + relative[s].begin + k, get(known, relative[s].parent_begin + k));
  }
  for (int k0 = (front.width - 1) / at_once * at_once; k0 >= 0; k0 -= at_once) {
    const int count = front.width - k0 < at_once ? front.width - k0 : at_once;
    for (int k = k0; k < k0 + count; ++k) {
      const double* L = at.panel + k * stride * width;
      Native products[at_once]{};
      add_products(L, right, k0 + at_once, front.width, products);
      add_products(L, right, front.top, at.last(), products);
      put(right, k, get(right, k) - sum_of_eight(products));
    }
    with_count<at_once>(count, [&](auto own) { backward_block<own>(at, k0); });
  }
  for (int k = 0; k < front.width; ++k) put(lambda, data.unknowns[front.unknown + k], get(right, k));
}

/// x = M^-1 (a + D^T lambda).
void backward_body(const CoreBody& body, const LaneData& data, const double* a, double* x, const double* lambda) {
  Native sums[2][6]{};
  const auto add = [&](int row) {
    const block::BodyRow& it = data.rows[body.first_row + row];
    const Native l = get(lambda, it.row);
    Native* sum = sums[row % 2];
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
      sum[k] += get(data.D, it.D + k) * l;
  };
  for (int row = 0; row < body.rows; ++row) add(row);
  Native* sum = sums[0];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    sum[k] += sums[1][k];
  if (body.slot >= 0) {
    const double* own = data.factors + body.own_factors * width;
    Native solution[6];
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
      solution[k] = get(own, 48 + k) + get(own, 9 * k) * sum[k];
      LINKWORK_UNROLL for (int r = k + 1; r < 6; ++r)
        sum[r] -= get(own, 8 * k + r) * sum[k];
    }
    LINKWORK_UNROLL for (int k = 5; k > 0; --k) LINKWORK_UNROLL
      for (int j = 0; j < k; ++j) solution[j] -= get(own, 8 * j + k) * solution[k];
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
      put(x, 6l * body.body + k, solution[k]);
    return;
  }
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    sum[k] += get(a, 6l * body.body + k);
  const double* factor = mass_factor_of(body, data);
  solve_lower(factor, sum);
  sum[4] -= get(factor, 2) * sum[5];
  sum[3] -= get(factor, 0) * sum[4] + get(factor, 1) * sum[5];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    put(x, 6l * body.body + k, sum[k]);
}

void backward_loops(const LaneData& data, const double* a, double* x, double* lambda) {
  for (std::ptrdiff_t f = data.front_count; f-- > 0;) {
    const Front& front = data.fronts[f];
    backward_joints(FrontPlace(front, data), data, lambda);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      backward_body(data.bodies[body], data, a, x, lambda);
  }
}

}  // namespace
}  // namespace linkwork
