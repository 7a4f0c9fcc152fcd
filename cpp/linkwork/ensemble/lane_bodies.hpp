#pragma once

#include "linkwork/ensemble/lane_fronts.hpp"

/// Bodies of closed loops of all lanes: the equations of block/body_kernels.hpp, and their order of operations, element
/// by element.
namespace linkwork {
namespace {

using block::CoreBody;

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

LINKWORK_INLINE block::GroundPlaces ground_places(const CoreBody& body, const LaneData& data, const double* a) {
  return ground_places(body, body.ground_D, body.ground_factors, data, a);
}

block::Grounded<Native> eliminate_ground_joint(const CoreBody& body, const LaneData& data, const double* a,
                                               const double* b, SmallestPivots& smallest) {
  return with_ground_joint(body.slides, ground_places(body, data, a), [&](auto joint) {
    eliminate_joint(joint, body.ground_row, b, smallest);
    joint.store_way_back();
    return joint.grounded();
  });
}

/// The product of a row of D with a motion.
template <RowForm form>
LINKWORK_INLINE Native along(const double* D, const Native* motion) {
  Native sum{};
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    if (holds<false, form>(k)) sum += get(D, k) * motion[k];
  return sum;
}

/// As add_row of a grounded body: D g, with and without 1/n.
template <bool branches, bool right_hand_side_only, RowForm form>
LINKWORK_INLINE void add_grounded_row(int row, const FrontPlace& at, const LaneData& data, const double* own,
                                      const double* factor, const block::Grounded<Native>& grounded, double* U) {
  const double* D = data.D + data.rows[row].D * width;
  const int position = data.row_positions[row];
  put(at.right(), position, get(at.right(), position) - along<form>(D, grounded.alone));
  if constexpr (right_hand_side_only) return;
  const Native moved = along<form>(D, grounded.direction);
  put(U, 0, moved);
  put(U, 1, moved * grounded.mobility);
  Native B[6], d{};
  reduce_row<branches, form>(D, own, factor, B);
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
    if (holds<branches, form>(k)) d += B[k] * (B[k] * (branches ? get(own, 9 * k) : get(factor, 3 + k)));
  put(at.diagonal(), position, get(at.diagonal(), position) + d);
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

/// The same of a grounded one.
template <bool branches, bool right_hand_side_only>
void add_grounded_body(const CoreBody& body, const FrontPlace& at, const LaneData& data,
                       const block::Grounded<Native>& grounded) {
  double* U = data.scratch;
  const double* own = data.factors + body.own_factors * width;
  const double* factor = branches ? nullptr : mass_factor_of(body, data);
  for (int row = body.first_row; row < body.first_row + body.rows; ++row, U += 2l * width)
    with_form(data.row_forms[row], [&](auto form) {
      add_grounded_row<branches, right_hand_side_only, form.value>(row, at, data, own, factor, grounded, U);
    });
}

/// Its part of the columns of D M^-1 D^T, from their diagonal on.
void add_grounded_columns(const CoreBody& body, const FrontPlace& at, const LaneData& data) {
  const int* positions = data.row_positions + body.first_row;
  for (int j = 0; j < body.rows; ++j) {
    double* C = at.column(positions[j]);
    const Native scaled = get(data.scratch, 2l * j + 1);
    for (int i = j; i < body.rows; ++i) put(C, positions[i], get(C, positions[i]) + get(data.scratch, 2l * i) * scaled);
  }
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
void eliminate_body(const CoreBody& body, const FrontPlace& at, const LaneData& data, const double* a, const double* b,
                    SmallestPivots& smallest) {
  if (body.slot >= 0) factor_mass(body, data, smallest);
  if (body.grounded()) {
    const block::Grounded<Native> grounded = eliminate_ground_joint(body, data, a, b, smallest);
    if (body.slot >= 0) add_grounded_body<true, right_hand_side_only>(body, at, data, grounded);
    else add_grounded_body<false, right_hand_side_only>(body, at, data, grounded);
    if constexpr (!right_hand_side_only) add_grounded_columns(body, at, data);
  } else if (body.slot >= 0) {
    add_body<true, right_hand_side_only>(body, at, data, a);
    if constexpr (!right_hand_side_only) add_body_columns<true>(body, at, data);
  } else {
    add_body<false, right_hand_side_only>(body, at, data, a);
    if constexpr (!right_hand_side_only) add_body_columns<false>(body, at, data);
  }
}

/// D^T lambda of the rows of a body: those in odd places apart.
LINKWORK_INLINE void sum_reactions(const CoreBody& body, const LaneData& data, const double* lambda, Native* sum) {
  Native odd[6];
  clear_numbers(odd);
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

/// x = M^-1 (a + D^T lambda), and the multipliers of a grounded body's joint.
void backward_body(const CoreBody& body, const LaneData& data, const double* a, double* x, double* lambda) {
  Native sum[6];
  clear_numbers(sum);
  sum_reactions(body, data, lambda, sum);
  if (body.grounded()) {
    constexpr std::ptrdiff_t stride = width;
    return with_ground_joint(body.slides, ground_places(body, data, a), [&](auto joint) {
      joint.go_back(sum, x + 6 * stride * body.body, lambda + stride * body.ground_row);
    });
  }
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

}  // namespace
}  // namespace linkwork
