#pragma once

#include "linkwork/ensemble/lane_bodies.hpp"
#include "linkwork/ensemble/lane_hubs.hpp"

/// Closed loops of all lanes: the equations of block/core_kernels.hpp, and their order of operations, element by
/// element.
namespace linkwork {
namespace {

using block::RelativeIndices;

constexpr int at_once = 8;         // columns that are eliminated together, which decides on the order of operations
constexpr int most_products = 32;  // of an entry, at a time

/// Of a constraint row; zero for those of hubs.
LINKWORK_INLINE Native given(int unknown, const double* numbers) {
  return unknown >= 0 ? get(numbers, unknown) : Native{};
}

/// Calls f with the first and the count, 1 to 4, of some of the positions from `begin` to `end`.
template <class Function>
LINKWORK_INLINE void by_fours(int begin, int end, const Function& f) {
  for (; begin + 4 <= end; begin += 4) f(begin, std::integral_constant<int, 4>());
  if (begin < end) with_count<3>(end - begin, [&](auto count) { f(begin, count); });
}

/// Some columns, one `stride` after the other, of which position p of the first is number p.
struct Columns {
  double* first;
  std::ptrdiff_t stride;

  LINKWORK_INLINE double* operator[](int c) const { return first + c * stride * width; }
};

/// Subtracts the products of `depth` columns of a list, from `A` on, and of as many factors, from rows p, p + 1, ... of
/// columns; where `diagonal`, p is the position of the first, and what is above the diagonal stays.
template <int rows, int columns, bool diagonal>
LINKWORK_INLINE void subtract_products(const Columns& to, int p, const Columns& A, int depth,
                                       const Native (*factors)[columns]) {
  Native sum[columns][rows];
  LINKWORK_UNROLL for (int c = 0; c < columns; ++c) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) sum[c][r] = diagonal && r < c ? Native{} : get(to[c], p + r);
  const double* from = A.first + static_cast<std::ptrdiff_t>(p) * width;
  for (int k = 0; k < depth; ++k, from += A.stride * width) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) {
      const Native x = get(from, r);
      LINKWORK_UNROLL for (int c = 0; c < (diagonal ? r + 1 : columns); ++c)
        sum[c][r] -= x * factors[k][c];
    }
  LINKWORK_UNROLL for (int c = 0; c < columns; ++c) LINKWORK_UNROLL
    for (int r = diagonal ? c : 0; r < rows; ++r) put(to[c], p + r, sum[c][r]);
}

template <int columns>
LINKWORK_INLINE void subtract_below(const Columns& to, int begin, int end, const Columns& A, int depth,
                                    const Native (*factors)[columns]) {
  by_fours(begin, end, [&](int p, auto rows) { subtract_products<rows, columns, false>(to, p, A, depth, factors); });
}

/// Columns c, c + 1, ... of a front, from the diagonal of each on, less the products of the first `before` columns: U L^T
/// of a narrow front, L (D L^T) of a wide one.
template <int columns>
LINKWORK_INLINE void subtract_columns(const FrontPlace& at, int before, const double* U, const double* pivots, int c) {
  const Front& front = at.front;
  const std::ptrdiff_t stride = front.stride();
  const bool own = c < front.width;
  const Columns to{at.column(c), own ? stride : front.contribution_rows};
  Native factors[most_products][columns];
  for (int first = 0; first < before; first += most_products) {
    const int depth = before - first < most_products ? before - first : most_products;
    for (int k = 0; k < depth; ++k) LINKWORK_UNROLL
      for (int i = 0; i < columns; ++i) {
        const Native L = get(at.panel, (first + k) * stride + c + i);
        factors[k][i] = U ? L : L * get(pivots, first + k);
      }
    const Columns A{const_cast<double*>(U ? U : at.panel) + first * stride * width, stride};
    subtract_products<columns, columns, true>(to, c, A, depth, factors);
    if (own) subtract_below<columns>(to, c + columns, front.width, A, depth, factors);
    subtract_below<columns>(to, own ? front.top : c + columns, at.last(), A, depth, factors);
  }
}

/// LDL^T of a block of columns, from which all columns before it are subtracted, and of their right-hand side: the panel
/// is left with unit L, below 1/d on its diagonal, and D^-1 L^-1 of the right-hand side.
template <int count>
struct Block {
  Columns own;    ///< its columns, such that position p is number p
  double* right;  ///< of the front
  Native L[count][count], inverse[count], z[count];

  /// The rows k0, k0 + 1, ... `diagonal` and `pivots` from there on.
  LINKWORK_INLINE void factor_diagonal(int k0, const int* unknowns, const double* diagonal, double* pivots,
                                       SmallestPivots& smallest) {
    LINKWORK_UNROLL for (int k = 0; k < count; ++k) {
      const Native pivot = L[k][k];
      if (unknowns[k] >= 0) smallest.note(pivot, get(diagonal, k));
      else smallest.note(-pivot, Native{});
      put(pivots, k, pivot);
      inverse[k] = 1.0 / pivot;
      z[k] *= inverse[k];
      put(own[k], k0 + k, inverse[k]);
      put(right, k0 + k, z[k]);
      Native scaled[count];
      LINKWORK_UNROLL for (int r = k + 1; r < count; ++r) {
        scaled[r] = L[k][r] * inverse[k];
        put(own[k], k0 + r, scaled[r]);
        z[r] -= L[k][r] * z[k];
      }
      LINKWORK_UNROLL for (int c = k + 1; c < count; ++c) LINKWORK_UNROLL
        for (int r = c; r < count; ++r) {
          if (c == k + 1) L[c][r] -= (L[k][r] * L[k][c]) * inverse[k];
          else L[c][r] -= L[k][r] * scaled[c];
        }
      LINKWORK_UNROLL for (int r = k + 1; r < count; ++r)
        L[k][r] = scaled[r];
    }
  }

  /// Rows p, p + 1, ... below the diagonal; U = L D of them, where it is wanted.
  template <int rows, bool keeps_U>
  LINKWORK_INLINE void solve_rows(int p, const Columns& U) const {
    Native x[rows][count], sum[rows];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r) {
      sum[r] = get(right, p + r);
      LINKWORK_UNROLL for (int c = 0; c < count; ++c)
        x[r][c] = get(own[c], p + r);
    }
    LINKWORK_UNROLL for (int k = 0; k < count; ++k) LINKWORK_UNROLL
      for (int c = k + 1; c < count; ++c) LINKWORK_UNROLL
        for (int r = 0; r < rows; ++r) x[r][c] -= x[r][k] * L[k][c];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r) {
      LINKWORK_UNROLL for (int c = 0; c < count; ++c) {
        sum[r] -= x[r][c] * z[c];
        put(own[c], p + r, x[r][c] * inverse[c]);
        if constexpr (keeps_U) put(U[c], p + r, x[r][c]);
      }
      put(right, p + r, sum[r]);
    }
  }
  template <bool keeps_U>
  LINKWORK_INLINE void solve_below(int begin, int end, const Columns& U) const {
    for (; begin + 2 <= end; begin += 2) solve_rows<2, keeps_U>(begin, U);
    if (begin < end) solve_rows<1, keeps_U>(begin, U);
  }
};

/// Of the rows k0, k0 + 1, ..., from which all columns before them are subtracted.
LINKWORK_INLINE void add_compliance(const FrontPlace& at, const LaneData& data, int k0, int count) {
  const int* unknowns = data.unknowns + at.front.unknown;
  for (int k = k0; k < k0 + count; ++k) {
    const Native e = given(unknowns[k], data.compliance);
    put(at.column(k), k, get(at.column(k), k) + e);
    put(at.diagonal(), k, get(at.diagonal(), k) + e);
  }
}

template <int count, bool narrow>
void eliminate_block(const FrontPlace& at, const LaneData& data, const double* b, int k0, double* U, double* pivots,
                     SmallestPivots& smallest) {
  const std::ptrdiff_t stride = at.front.stride();
  if constexpr (!narrow) {
    for (int c = k0; c < k0 + count; c += 4) {
      if (c + 4 <= k0 + count) subtract_columns<4>(at, k0, nullptr, pivots, c);
      else subtract_columns<count % 4 == 0 ? 1 : count % 4>(at, k0, nullptr, pivots, c);
    }
  }
  if (data.compliant) add_compliance(at, data, k0, count);
  Block<count> block{{at.column(k0), stride}, at.right(), {}, {}, {}};
  const int* unknowns = data.unknowns + at.front.unknown + k0;
  LINKWORK_UNROLL for (int c = 0; c < count; ++c) {
    LINKWORK_UNROLL for (int r = c; r < count; ++r)
      block.L[c][r] = get(block.own[c], k0 + r);
    block.z[c] = get(block.right, k0 + c) + given(unknowns[c], b);
  }
  const std::ptrdiff_t first = std::ptrdiff_t{k0} * width;
  block.factor_diagonal(k0, unknowns, at.diagonal() + first, pivots + first, smallest);
  block.template solve_below<false>(k0 + count, at.front.width, {});
  block.template solve_below<narrow>(at.front.top, at.last(), {U, stride});
}

LINKWORK_INLINE bool narrow(const Front& front) { return front.width <= at_once; }

/// `U` with L D of the kept rows of a narrow front; `pivots` with D.
void eliminate(const FrontPlace& at, const LaneData& data, const double* b, double* U, double* pivots,
               SmallestPivots& smallest) {
  const int columns = at.front.width;
  if (narrow(at.front)) {
    with_count<at_once>(columns,
                        [&](auto count) { eliminate_block<count, true>(at, data, b, 0, U, pivots, smallest); });
    return;
  }
  for (int k0 = 0; k0 < columns; k0 += at_once)
    with_count<at_once>(columns - k0 < at_once ? columns - k0 : at_once,
                        [&](auto count) { eliminate_block<count, false>(at, data, b, k0, U, pivots, smallest); });
}

void update_kept(const FrontPlace& at, const double* U, const double* pivots) {
  const Front& front = at.front;
  by_fours(front.top, at.last(), [&](int c, auto columns) {
    subtract_columns<columns>(at, front.width, narrow(front) ? U : nullptr, pivots, c);
  });
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
      eliminate_body<false>(data.bodies[body], at, data, a, b, smallest);
    if (front.mixed >= 0) {
      add_hubs(data.mixed[front.mixed], at, data);
      add_hub_right_hand_sides(data.mixed[front.mixed], at, data, a);
    }
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
      eliminate_body<true>(data.bodies[body], at, data, a, b, unchanged);
    if (front.mixed >= 0) add_hub_right_hand_sides(data.mixed[front.mixed], at, data, a);
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
void backward_joints(const FrontPlace& at, const LaneData& data, double* x, double* lambda) {
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
      Native products[at_once];
      clear_numbers(products);
      add_products(L, right, k0 + at_once, front.width, products);
      add_products(L, right, front.top, at.last(), products);
      put(right, k, get(right, k) - sum_of_eight(products));
    }
    with_count<at_once>(count, [&](auto own) { backward_block<own>(at, k0); });
  }
  for (int k = 0; k < front.width; ++k) {
    const int unknown = data.unknowns[front.unknown + k];
    if (unknown >= 0) put(lambda, unknown, get(right, k));
    else put(x, ~unknown, get(right, k));
  }
}

void backward_loops(const LaneData& data, const double* a, double* x, double* lambda) {
  for (std::ptrdiff_t f = data.front_count; f-- > 0;) {
    const Front& front = data.fronts[f];
    backward_joints(FrontPlace(front, data), data, x, lambda);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      backward_body(data.bodies[body], data, a, x, lambda);
  }
}

}  // namespace
}  // namespace linkwork
