#pragma once

#include "linkwork/ensemble/lane_elimination.hpp"

/// Closed loops of all lanes: the equations of block/body_kernels.hpp and block/core_kernels.hpp, and their order of
/// operations, element by element.
namespace linkwork {
namespace {

using block::CoreBody;
using block::Front;
using block::RelativeIndices;

constexpr int at_once = 8;         // columns that are eliminated together, which decides on the order of operations
constexpr int most_products = 32;  // of an entry, at a time

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

LINKWORK_INLINE void clear_range(double* list, int begin, int end) {
  for (int p = begin; p < end; ++p) {
    put(list, p, Native{});
    asm volatile("" ::: "memory");  // ranges are too short for a call of memset, which this would become
  }
}

void clear_list(double* list, const FrontPlace& at) {
  clear_range(list, 0, at.front.width);
  clear_range(list, at.front.top, at.last());
}

void clear(const Front& front, const LaneData& data) {
  const FrontPlace at(front, data);
  const int own = front.width, top = front.top, last = at.last();
  for (int c = 0; c < own; ++c) {
    double* column = at.column(c);
    clear_range(column, c, own);
    clear_range(column, top, last);
  }
  for (int c = top; c < last; ++c) clear_range(at.column(c), c, last);
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

constexpr int axis_of(RowForm form) { return static_cast<int>(form) - static_cast<int>(RowForm::x); }
/// Of a row of L^-1 D^T.
template <bool branches>
LINKWORK_INLINE RowForm form_in(RowForm of_D) {
  return branches && of_D != RowForm::rotation ? RowForm::general : of_D;
}

/// What is not zero in L^-1 D^T of a row. Branches fill in what comes after its first number.
template <bool branches, RowForm form>
constexpr bool holds(int k) {
  if (k >= 3 || form == RowForm::general) return true;
  if (form == RowForm::rotation) return false;
  return branches || k == axis_of(form);
}

/// L^-1 of a row of D.
template <bool branches, RowForm form>
LINKWORK_INLINE void reduce_row(const double* D, const double* own, const double* factor, Native* B) {
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    B[k] = holds<false, form>(k) ? get(D, k) : Native{};
  if constexpr (branches) {
    LINKWORK_UNROLL for (int k = form == RowForm::rotation ? 3 : 0; k < 6; ++k) LINKWORK_UNROLL
      for (int c = k + 1; c < 6; ++c) B[c] -= B[k] * get(own, 8 * k + c);
  } else {
    B[4] -= B[3] * get(factor, 0);
    B[5] -= B[3] * get(factor, 1) + B[4] * get(factor, 2);
  }
}

/// What a row of a body leaves of its right-hand side, and L^-1 D^T and D^-1 L^-1 D^T, where others read them.
template <bool branches, bool right_hand_side_only, RowForm form>
LINKWORK_INLINE void add_row(int row, const FrontPlace& at, const LaneData& data, const double* own,
                             const double* factor, const Native* y, double* U) {
  Native B[6], r{}, d{};
  reduce_row<branches, form>(data.D + data.rows[row].D * width, own, factor, B);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    if (!holds<branches, form>(k)) {
      if (!right_hand_side_only && form != RowForm::rotation) put(U, 6 + k, Native{});
      continue;
    }
    r -= B[k] * y[k];
    if constexpr (right_hand_side_only) continue;
    const Native L = B[k] * (branches ? get(own, 9 * k) : get(factor, 3 + k));
    d += B[k] * L;
    put(U, k, B[k]);
    put(U, 6 + k, L);
  }
  const int position = data.row_positions[row];
  put(at.right(), position, get(at.right(), position) + r);
  if constexpr (!right_hand_side_only) put(at.diagonal(), position, get(at.diagonal(), position) + d);
}

/// Calls f with the form as a constant.
template <class Function>
LINKWORK_INLINE void with_form(RowForm form, const Function& f) {
  if (form == RowForm::rotation) f(std::integral_constant<RowForm, RowForm::rotation>());
  else if (form == RowForm::x) f(std::integral_constant<RowForm, RowForm::x>());
  else if (form == RowForm::y) f(std::integral_constant<RowForm, RowForm::y>());
  else if (form == RowForm::z) f(std::integral_constant<RowForm, RowForm::z>());
  else f(std::integral_constant<RowForm, RowForm::general>());
}

/// What a body leaves of its right-hand side, and its rows in the scratch memory.
template <bool branches, bool right_hand_side_only>
void add_body(const CoreBody& body, const FrontPlace& at, const LaneData& data, const double* a) {
  double* U = data.scratch;
  const double* own = data.factors + body.own_factors * width;
  const double* factor = branches ? nullptr : mass_factor_of(body, data);
  Native y[6];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    y[k] = branches ? get(own, 48 + k) : get(a, 6l * body.body + k);
  if constexpr (!branches) solve_lower(factor, y);
  for (int row = body.first_row; row < body.first_row + body.rows; ++row, U += 12l * width)
    with_form(data.row_forms[row], [&](auto form) {
      add_row<branches, right_hand_side_only, form.value>(row, at, data, own, factor, y, U);
    });
}

/// Some columns of a body's part of D M^-1 D^T; `moving`: of rows that have to do with translations.
template <int count, bool moving>
struct BodyColumns {
  const double* U;  ///< of the first
  double* C[count];
  Native scaled[count][6];

  LINKWORK_INLINE BodyColumns(const FrontPlace& at, const int* positions, const double* rows) : U(rows) {
    LINKWORK_UNROLL for (int c = 0; c < count; ++c) {
      C[c] = at.column(positions[c]);
      LINKWORK_UNROLL for (int k = moving ? 0 : 3; k < 6; ++k)
        scaled[c][k] = get(U, 12l * c + 6 + k);
    }
  }

  /// Row i of the first `columns`.
  template <int columns>
  LINKWORK_INLINE void add(std::ptrdiff_t position, const double* row, RowForm form) const {
    Native sum[columns];
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c)
      sum[c] = get(C[c], position);
    if (moving && form != RowForm::rotation) {
      if (form == RowForm::general) LINKWORK_UNROLL
        for (int k = 0; k < 3; ++k) add_products<columns>(k, row, sum);
      else add_along<columns>(axis_of(form), row, sum);
    }
    LINKWORK_UNROLL for (int k = 3; k < 6; ++k)
      add_products<columns>(k, row, sum);
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c)
      put(C[c], position, sum[c]);
  }

 private:
  template <int columns>
  LINKWORK_INLINE void add_products(int k, const double* row, Native* sum) const {
    const Native x = get(row, k);
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c)
      sum[c] += x * scaled[c][k];
  }
  template <int columns>
  LINKWORK_INLINE void add_along(int axis, const double* row, Native* sum) const {
    const Native x = get(row, axis);
    LINKWORK_UNROLL for (int c = 0; c < columns; ++c)
      sum[c] += x * get(U, 12l * c + 6 + axis);
  }
};

/// Columns j, j + 1, ... of those of a body, from their diagonal on.
template <bool branches, int count, bool moving>
LINKWORK_INLINE void add_some_columns(const FrontPlace& at, const int* positions, const RowForm* forms, const double* U,
                                      int j, int rows) {
  const double* row = U + 12l * j * width;
  const BodyColumns<count, moving> columns(at, positions + j, row);
  const auto form = [&](int i) { return form_in<branches>(forms[i]); };
  columns.template add<1>(positions[j], row, form(j));
  if constexpr (count > 1) columns.template add<2>(positions[j + 1], row + 12l * width, form(j + 1));
  if constexpr (count > 2) columns.template add<3>(positions[j + 2], row + 24l * width, form(j + 2));
  row += 12l * count * width;
  for (int i = j + count; i < rows; ++i, row += 12l * width) columns.template add<count>(positions[i], row, form(i));
}

/// Up to three neighboring columns at a time, all with or all without translations.
template <bool branches>
void add_body_columns(const CoreBody& body, const FrontPlace& at, const LaneData& data) {
  const int* positions = data.row_positions + body.first_row;
  const RowForm* forms = data.row_forms + body.first_row;
  const int rows = body.rows;
  const auto moves = [&](int row) { return forms[row] != RowForm::rotation; };
  for (int j = 0, end; j < rows; j = end) {
    for (end = j + 1; end < rows && end < j + 3 && moves(end) == moves(j);) ++end;
    with_count<3>(end - j, [&](auto count) {
      if (moves(j)) add_some_columns<branches, count, true>(at, positions, forms, data.scratch, j, rows);
      else add_some_columns<branches, count, false>(at, positions, forms, data.scratch, j, rows);
    });
  }
}

template <bool right_hand_side_only>
void eliminate_body(const CoreBody& body, const FrontPlace& at, const LaneData& data, const double* a,
                    SmallestPivots& smallest) {
  if (body.slot >= 0) {
    factor_mass(body, data, smallest);
    add_body<true, right_hand_side_only>(body, at, data, a);
    if constexpr (!right_hand_side_only) add_body_columns<true>(body, at, data);
  } else {
    add_body<false, right_hand_side_only>(body, at, data, a);
    if constexpr (!right_hand_side_only) add_body_columns<false>(body, at, data);
  }
}

/// Of a constraint row; zero for those of hubs.
LINKWORK_INLINE Native given(int unknown, const double* numbers) {
  return unknown >= 0 ? get(numbers, unknown) : Native{};
}

// --- hubs: the equations of block/hub_kernels.hpp ---

/// Adds x to the number at a position.
LINKWORK_INLINE void add_to(double* list, std::ptrdiff_t position, Native x) {
  put(list, position, get(list, position) + x);
}

/// -M of a hub, the lower triangle.
void add_hub(const block::Hub& hub, const FrontPlace& at, const LaneData& data) {
  const double* articulated_inertia = data.articulated_inertias + hub.slot * articulated * std::ptrdiff_t{width};
  const double* mass = data.mass + 10l * width * hub.body;
  for (int c = 0; c < 6; ++c) {
    double* column = at.column(hub.position + c);
    for (int r = c; r < 6; ++r) {
      if (hub.slot >= 0) add_to(column, hub.position + r, -get(articulated_inertia, 8 * c + r));
      else if (c >= 3) add_to(column, hub.position + r, -get(mass, 1 + 3 * (c - 3) + r - 3));
      else if (r == c) add_to(column, hub.position + r, -get(mass, 0));
    }
  }
}

/// -M of hubs and their D, into the lower triangle.
void add_hubs(const block::MixedFront& mixed, const FrontPlace& at, const LaneData& data) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) add_hub(data.hubs[h], at, data);
  for (int k = mixed.first_coupling; k < mixed.first_coupling + mixed.couplings; ++k) {
    const block::Coupling& it = data.couplings[k];
    for (int r = 0; r < it.rows; ++r)
      for (int c = 0; c < 6; ++c) {
        const int joint = it.joint + r, hub = it.hub + c;
        add_to(at.column(hub < joint ? hub : joint), hub < joint ? joint : hub, get(data.D, it.D + 6 * r + c));
      }
  }
}

/// -a of hubs.
void add_hub_right_hand_sides(const block::MixedFront& mixed, const FrontPlace& at, const LaneData& data,
                              const double* a) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const block::Hub& hub = data.hubs[h];
    const double* articulated_inertia = data.articulated_inertias + hub.slot * articulated * std::ptrdiff_t{width};
    for (int k = 0; k < 6; ++k)
      add_to(at.right(), hub.position + k,
             -(hub.slot < 0 ? get(a, 6l * hub.body + k) : get(articulated_inertia, 8 * k + right_hand_side)));
  }
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
      eliminate_body<false>(data.bodies[body], at, data, a, smallest);
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
      eliminate_body<true>(data.bodies[body], at, data, a, unchanged);
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
      Native products[at_once]{};
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

/// D^T lambda of the rows of a body: those in odd places apart.
LINKWORK_INLINE void sum_reactions(const CoreBody& body, const LaneData& data, const double* lambda, Native* sum) {
  Native odd[6]{};
  const auto add = [&](int row, Native* to) {
    const block::BodyRow& it = data.rows[body.first_row + row];
    const Native l = get(lambda, it.row);
    with_form(data.row_forms[body.first_row + row], [&](auto form) {
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
        if (holds<false, form.value>(k)) to[k] += get(data.D, it.D + k) * l;
    });
  };
  int row = 0;
  for (; row + 1 < body.rows; row += 2) {
    add(row, sum);
    add(row + 1, odd);
  }
  if (row < body.rows) add(row, sum);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    sum[k] += odd[k];
}

/// x = M^-1 (a + D^T lambda).
void backward_body(const CoreBody& body, const LaneData& data, const double* a, double* x, const double* lambda) {
  Native sum[6]{};
  sum_reactions(body, data, lambda, sum);
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
    backward_joints(FrontPlace(front, data), data, x, lambda);
    for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
      backward_body(data.bodies[body], data, a, x, lambda);
  }
}

}  // namespace
}  // namespace linkwork
