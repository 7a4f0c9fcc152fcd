#pragma once

#include "linkwork/ensemble/lane_elimination.hpp"
#include "linkwork/linear/block/ballast_kernels.hpp"
#include "linkwork/linear/block/hinge_elimination.hpp"

/// Open branches of all lanes, leaf to root and back: the equations of block/tree_kernels.hpp, and their order of
/// operations, element by element.
namespace linkwork {
namespace {

/// Where the rows of a step stand.
template <bool scattered>
struct RowsOfStep {
  const block::TreeStep& step;
  const LaneData& data;

  LINKWORK_INLINE std::ptrdiff_t D_body(int k) const {
    if constexpr (scattered) return of(k).D_body;
    else return step.D_body + 6 * k;
  }
  LINKWORK_INLINE std::ptrdiff_t D_parent(int k) const {
    if constexpr (scattered) return of(k).D_parent;
    else return step.D_parent + 6 * k;
  }
  LINKWORK_INLINE int row(int k) const {
    if constexpr (scattered) return of(k).row;
    else return step.row + k;
  }

 private:
  LINKWORK_INLINE const block::StepRow& of(int k) const { return data.step_rows[step.scattered + k]; }
};

/// M_b (its lower triangle) of a body, its own or articulated, and its right-hand side.
LINKWORK_INLINE void load_body(const block::TreeStep& step, const LaneData& data, const double* a, Native (*M)[6],
                               Native* right) {
  if (step.slot >= 0) {
    const double* from = data.articulated_inertias + step.slot * articulated * std::ptrdiff_t{width};
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
      LINKWORK_UNROLL for (int r = c; r < 6; ++r)
        M[c][r] = get(from, 8 * c + r);
      right[c] = get(from, 8 * c + right_hand_side);
    }
    return;
  }
  const double* mass = data.mass + 10l * width * step.body;
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    LINKWORK_UNROLL for (int r = c; r < 6; ++r) {
      if (c < 3) M[c][r] = r == c ? get(mass, 0) : Native{};
      else M[c][r] = get(mass, 1 + 3 * (c - 3) + r - 3);
    }
    right[c] = get(a, 6l * step.body + c);
  }
}

/// M = L D L^T of so many rows, in place: unit L, with D^-1 apart. `note` is told of each pivot.
template <int size, class Note>
LINKWORK_INLINE void factor_square(Native (*M)[size], Native* inverse, const Note& note) {
  LINKWORK_UNROLL for (int k = 0; k < size; ++k) {
    note(k, M[k][k]);
    inverse[k] = 1.0 / M[k][k];
    Native L[size];
    LINKWORK_UNROLL for (int r = k + 1; r < size; ++r)
      L[r] = M[k][r] * inverse[k];
    LINKWORK_UNROLL for (int c = k + 1; c < size; ++c) LINKWORK_UNROLL
      for (int r = c; r < size; ++r) {
        if (c == k + 1) M[c][r] -= (M[k][r] * M[k][c]) * inverse[k];
        else M[c][r] -= M[k][r] * L[c];
      }
    LINKWORK_UNROLL for (int r = k + 1; r < size; ++r)
      M[k][r] = L[r];
  }
}

/// x = L^-T x.
template <int size>
LINKWORK_INLINE void substitute_backward(const Native (*L)[size], Native* x) {
  LINKWORK_UNROLL for (int k = size - 1; k >= 0; --k) LINKWORK_UNROLL
    for (int c = k + 1; c < size; ++c) x[k] -= x[c] * L[k][c];
}

/// Number r of column c of the parent's [M; a] before its first child.
LINKWORK_INLINE Native own_number(const block::TreeStep& step, const LaneData& data, const double* a, int c, int r) {
  const double* mass = data.mass + 10l * width * step.parent;
  if (r == right_hand_side) return get(a, 6l * step.parent + c);
  if (c >= 3) return get(mass, 1 + 3 * (c - 3) + r - 3);
  return r == c ? get(mass, 0) : Native{};
}

/// Column c of M_p += V^T D'^-1 V, where T is column c of D'^-1 V; M_p begins with the parent's own mass.
template <int rows, bool begins>
LINKWORK_INLINE void add_to_parent(const block::TreeStep& step, const LaneData& data, const double* a, int c,
                                   const Native (*V)[rows], const Native* T) {
  double* to = data.articulated_inertias + step.parent_slot * articulated * std::ptrdiff_t{width};
  LINKWORK_UNROLL for (int r = c; r < 7; ++r) {
    Native sum = begins ? own_number(step, data, a, c, r) : get(to, 8 * c + r);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      sum += V[r][k] * T[k];
    put(to, 8 * c + r, sum);
  }
}

/// What a joint with S = K D' K^T = D_b M_b^-1 D_b^T takes from its parent by V = K^-1 D_p, with the right-hand side
/// behind; `first`: 0, or 6 where it is on the ground.
template <int rows, int first, bool begins, bool scattered>
LINKWORK_INLINE void eliminate_joint(const RowsOfStep<scattered>& of, const double* a, Native (*S)[rows],
                                     const Native* right, SmallestPivots& smallest) {
  const block::TreeStep& step = of.step;
  const LaneData& data = of.data;
  Native V[7][rows], diagonal[rows], inverse[rows];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    diagonal[k] = S[k][k];
  factor_square<rows>(S, inverse, [&](int k, Native pivot) { smallest.note(pivot, diagonal[k]); });
  LINKWORK_UNROLL for (int r = first; r < 7; ++r) {
    LINKWORK_UNROLL for (int c = 0; c < rows; ++c)
      V[r][c] = r < right_hand_side ? get(data.D, of.D_parent(c) + r) : right[c];
    substitute_forward<rows>(S, V[r]);
  }
  double* factors = data.factors + (step.storage + block::second_factors(rows)) * width;
  LINKWORK_UNROLL for (int c = first; c < 7; ++c) {
    Native T[rows];
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      T[k] = V[c][k] * inverse[k];
    if (c < right_hand_side) add_to_parent<rows, begins>(step, data, a, c, V, T);
    substitute_backward<rows>(S, T);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
      put(factors, 7 * k + c, T[k]);
  }
}

LINKWORK_INLINE block::HingeElimination<Lanes> hinge_of(const block::TreeStep& step, const LaneData& data,
                                                        const double* a) {
  constexpr std::ptrdiff_t stride = width;
  const double* inertia = step.slot < 0 ? nullptr : data.articulated_inertias + step.slot * articulated * stride;
  return block::HingeElimination<Lanes>({.D_body = data.D + step.D_body * stride,
                                         .D_parent = data.D + step.D_parent * stride,
                                         .articulated_inertia = inertia,
                                         .mass = data.mass + 10 * stride * step.body,
                                         .a = a + 6 * stride * step.body,
                                         .factors = data.factors + step.storage * stride});
}

LINKWORK_INLINE block::GroundPlaces ground_places(const block::TreeStep& step, const LaneData& data, const double* a) {
  return ground_places(step, step.D_body, step.storage, data, a);
}

LINKWORK_INLINE const double* ballast_at(int body, const LaneData& data) { return data.ballast + 4l * width * body; }

/// The smallest mass or moment that counts as a pivot.
LINKWORK_INLINE Native least_pivot(bool mass, const block::TreeStep& step, const LaneData& data) {
  return data.ballast ? get(ballast_at(step.body, data), mass ? 2 : 3) : Native{};
}

/// M_b += D_b^T S D_b; leaves S.
template <int rows, bool scattered>
LINKWORK_INLINE void add_ballast(const RowsOfStep<scattered>& of, const LaneData& data, Native (*M)[6], Native* S) {
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    const double* d = data.D + of.D_body(k) * width;
    S[k] = block::ballast_of_row<Lanes>(d, ballast_at(of.step.body, data), get(data.compliance, of.row(k)));
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
      for (int r = c; r < 6; ++r) M[c][r] += (get(d, r) * S[k]) * get(d, c);
  }
}

/// M_b = L D L^T of a body, with its ballast where there is one.
template <int rows, bool scattered>
LINKWORK_INLINE void factor_body(const RowsOfStep<scattered>& of, const LaneData& data, const double* a, Native (*M)[6],
                                 Native* inverse, Native* right, Native* S, SmallestPivots& smallest) {
  load_body(of.step, data, a, M, right);
  if (data.ballast) add_ballast<rows>(of, data, M, S);
  factor_square<6>(M, inverse,
                   [&](int k, Native pivot) { smallest.note_mass(pivot, least_pivot(k < 3, of.step, data)); });
}

/// [M_p; a_p] -= [D_p, b]^T S D_p.
template <int rows, bool scattered>
LINKWORK_INLINE void take_ballast_again(const RowsOfStep<scattered>& of, const LaneData& data, const double* b,
                                        const Native* S) {
  double* to = data.articulated_inertias + of.step.parent_slot * articulated * std::ptrdiff_t{width};
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = c; r < 7; ++r) {
      Native sum = get(to, 8 * c + r);
      LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
        const Native d = r == right_hand_side ? get(b, of.row(k)) : get(data.D, of.D_parent(k) + r);
        sum -= (d * S[k]) * get(data.D, of.D_parent(k) + c);
      }
      put(to, 8 * c + r, sum);
    }
}

/// lambda -= S D_b x_b.
template <int rows, bool scattered>
LINKWORK_INLINE void take_its_forces(const RowsOfStep<scattered>& of, const LaneData& data, const double* x,
                                     double* lambda) {
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    const Native force = block::force_of_ballast<Lanes>(data.D + of.D_body(k) * width, ballast_at(of.step.body, data),
                                                        get(data.compliance, of.row(k)), x + 6l * width * of.step.body);
    put(lambda, of.row(k), get(lambda, of.row(k)) - force);
  }
}

/// Whether a step is of a hinge, or of a slider on the ground, that does not yield.
template <int rows, bool scattered>
LINKWORK_INLINE bool goes_by_numbers(const block::TreeStep& step, const LaneData& data) {
  if (rows != 5 || scattered || !(step.turning || (step.slides && step.parent < 0))) return false;
  Native yields{};
  for (int k = 0; k < rows; ++k) yields += get(data.compliance, step.row + k);
  return !any(yields != Native{});
}

void factor_on_ground(const block::TreeStep& step, const LaneData& data, const double* a, const double* b,
                      SmallestPivots& smallest) {
  with_ground_joint(step.slides, ground_places(step, data, a), [&](auto joint) {
    eliminate_joint(joint, step.row, b, smallest, least_pivot(step.slides, step, data));
    joint.store_way_back();
  });
}

void factor_on_body(const block::TreeStep& step, const LaneData& data, const double* a, const double* b,
                    SmallestPivots& smallest) {
  auto hinge = hinge_of(step, data, a);
  eliminate_joint(hinge, step.row, b, smallest, least_pivot(false, step, data));
  double* to = data.articulated_inertias + step.parent_slot * articulated * std::ptrdiff_t{width};
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = c; r < 7; ++r) {
      const Native before = step.parent_begins ? own_number(step, data, a, c, r) : get(to, 8 * c + r);
      put(to, 8 * c + r, before + hinge.parent(c, r));
    }
  hinge.store_way_back();
}

/// One row of D, or the right-hand side, after the other, so that its numbers stay in registers: W = D_b L^-T, and
/// W D^-1 L^-1 for the way back.
template <int rows, bool scattered>
void factor_step(const block::TreeStep& step, const LaneData& data, const double* a, const double* b,
                 SmallestPivots& smallest) {
  if (goes_by_numbers<rows, scattered>(step, data)) {
    if (step.parent < 0) factor_on_ground(step, data, a, b, smallest);
    else factor_on_body(step, data, a, b, smallest);
    return;
  }
  const RowsOfStep<scattered> of{step, data};
  Native M[6][6], inverse[6], W[rows + 1][6], S[rows + 1][rows > 0 ? rows : 1], right[rows + 1], ballast[rows + 1]{};
  factor_body<rows>(of, data, a, M, inverse, W[rows], ballast, smallest);
  LINKWORK_UNROLL for (int r = 0; r <= rows; ++r) {
    if (r < rows) LINKWORK_UNROLL
      for (int c = 0; c < 6; ++c) W[r][c] = get(data.D, of.D_body(r) + c);
    substitute_forward<6>(M, W[r]);
  }
  double* factors = data.factors + step.storage * width;
  LINKWORK_UNROLL for (int c = 0; c <= rows; ++c) {
    Native G[6];
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
      G[k] = W[c][k] * inverse[k];
    if (c < rows) LINKWORK_UNROLL
      for (int r = c; r <= rows; ++r) {
        Native sum = r == c ? get(data.compliance, of.row(c)) : Native{};
        LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
          sum += W[r][k] * G[k];
        if (r < rows) S[c][r] = sum;
        else right[c] = get(b, of.row(c)) - sum;
      }
    substitute_backward<6>(M, G);
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
      put(factors, (rows + 1) * k + c, G[k]);
  }
  if constexpr (rows > 0) {
    if (step.parent < 0) eliminate_joint<rows, 6, false>(of, a, S, right, smallest);
    else if (step.parent_begins) eliminate_joint<rows, 0, true>(of, a, S, right, smallest);
    else eliminate_joint<rows, 0, false>(of, a, S, right, smallest);
    if (step.parent >= 0 && data.ballast) take_ballast_again<rows>(of, data, b, ballast);
  }
}

template <int rows, bool scattered>
void backward_step(const block::TreeStep& step, const LaneData& data, double* x, double* lambda) {
  if (goes_by_numbers<rows, scattered>(step, data)) {
    constexpr std::ptrdiff_t stride = width;
    double *x_body = x + 6 * stride * step.body, *l = lambda + stride * step.row;
    const Native none[6]{};
    if (step.parent >= 0) return hinge_of(step, data, x).go_back(x + 6 * stride * step.parent, x_body, l);
    return with_ground_joint(step.slides, ground_places(step, data, x),
                             [&](auto joint) { joint.go_back(none, x_body, l); });
  }
  const RowsOfStep<scattered> of{step, data};
  constexpr std::ptrdiff_t second = block::second_factors(rows);
  const double* factors = data.factors + step.storage * width;
  Native l[8]{};
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    Native products[8]{};
    if (step.parent >= 0) LINKWORK_UNROLL
      for (int c = 0; c < 6; ++c) products[c] = -(get(factors, second + 7 * k + c) * get(x, 6l * step.parent + c));
    products[right_hand_side] = get(factors, second + 7 * k + right_hand_side);
    l[k] = sum_of_eight(products);
    put(lambda, of.row(k), l[k]);
  }
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    Native products[8]{};
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      products[r] = get(factors, (rows + 1) * k + r) * l[r];
    products[right_hand_side] = get(factors, (rows + 1) * k + rows);
    put(x, 6l * step.body + k, sum_of_eight(products));
  }
  if (data.ballast) take_its_forces<rows>(of, data, x, lambda);
}

/// Calls f with the number of rows of a joint, 0 to 6, and whether they are scattered, as constants.
template <class Function>
LINKWORK_INLINE void with_rows(const block::TreeStep& step, const Function& f) {
  const auto together = [&](auto rows) { f(rows, std::false_type()); };
  if (step.scattered >= 0) with_count<6>(step.rows, [&](auto rows) { f(rows, std::true_type()); });
  else if (step.rows == 0) together(std::integral_constant<int, 0>());
  else with_count<6>(step.rows, together);
}

void factor_branches(const LaneData& data, const double* a, const double* b, SmallestPivots& smallest) {
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s)
    with_rows(data.steps[s],
              [&](auto rows, auto scattered) { factor_step<rows, scattered>(data.steps[s], data, a, b, smallest); });
}

void backward_branches(const LaneData& data, double* x, double* lambda) {
  for (std::ptrdiff_t s = data.step_count; s-- > 0;)
    with_rows(data.steps[s],
              [&](auto rows, auto scattered) { backward_step<rows, scattered>(data.steps[s], data, x, lambda); });
}

}  // namespace
}  // namespace linkwork
