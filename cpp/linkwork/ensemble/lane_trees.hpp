#pragma once

#include "linkwork/ensemble/lane_elimination.hpp"

/// Open branches of all lanes, leaf to root and back: the equations of block/tree_kernels.hpp, and their order of
/// operations, element by element.
namespace linkwork {
namespace {

/// M_b (its lower triangle) of a body, its own or articulated, and the right-hand side behind the rows of W.
template <int rows>
LINKWORK_INLINE void load_body(const block::TreeStep& step, const LaneData& data, const double* a, Native (*M)[6],
                               Native (*W)[rows + 1]) {
  if (step.slot >= 0) {
    const double* from = data.articulated_inertias + step.slot * articulated * std::ptrdiff_t{width};
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
      LINKWORK_UNROLL for (int r = c; r < 6; ++r)
        M[c][r] = get(from, 8 * c + r);
      W[c][rows] = get(from, 8 * c + right_hand_side);
    }
    return;
  }
  const double* mass = data.mass + 10l * width * step.body;
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    LINKWORK_UNROLL for (int r = c; r < 6; ++r) {
      if (c < 3) M[c][r] = r == c ? get(mass, 0) : Native{};
      else M[c][r] = get(mass, 1 + 3 * (c - 3) + r - 3);
    }
    W[c][rows] = get(a, 6l * step.body + c);
  }
}

/// M_b = L D L^T with W = D_b L^-T on its way, and G = W D^-1; right-hand sides behind. M is left with unit L.
template <int rows>
LINKWORK_INLINE void factor_body_of(Native (*M)[6], Native (*W)[rows + 1], Native (*G)[rows + 1],
                                    SmallestPivots& smallest) {
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Native pivot = M[k][k], inverse = 1.0 / pivot;
    Native L[6];
    LINKWORK_UNROLL for (int r = k + 1; r < 6; ++r)
      L[r] = M[k][r] * inverse;
    LINKWORK_UNROLL for (int r = 0; r <= rows; ++r)
      G[k][r] = W[k][r] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) {
      LINKWORK_UNROLL for (int r = c; r < 6; ++r) {
        if (c == k + 1) M[c][r] -= (M[k][r] * M[k][c]) * inverse;
        else M[c][r] -= M[k][r] * L[c];
      }
      LINKWORK_UNROLL for (int r = 0; r <= rows; ++r)
        W[c][r] -= W[k][r] * L[c];
    }
    LINKWORK_UNROLL for (int r = k + 1; r < 6; ++r)
      M[k][r] = L[r];
    smallest.note_mass(pivot);
  }
}

/// S = K D' K^T with V = K^-1 D_p, T = D'^-1 V, from column `first` of V on; S is left with K.
template <int rows, int first>
LINKWORK_INLINE void factor_joint_of(Native (*S)[rows], Native (*V)[7], Native (*T)[7], SmallestPivots& smallest) {
  Native diagonal[rows];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
    diagonal[k] = S[k][k];
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    const Native pivot = S[k][k], inverse = 1.0 / pivot;
    smallest.note(pivot, diagonal[k]);
    Native K[rows];
    LINKWORK_UNROLL for (int r = k + 1; r < rows; ++r)
      K[r] = S[k][r] * inverse;
    LINKWORK_UNROLL for (int r = first; r < 7; ++r)
      T[k][r] = V[k][r] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c) {
      LINKWORK_UNROLL for (int r = c; r < rows; ++r) {
        if (c == k + 1) S[c][r] -= (S[k][r] * S[k][c]) * inverse;
        else S[c][r] -= S[k][r] * K[c];
      }
      LINKWORK_UNROLL for (int r = first; r < 7; ++r)
        V[c][r] -= V[k][r] * K[c];
    }
    LINKWORK_UNROLL for (int r = k + 1; r < rows; ++r)
      S[k][r] = K[r];
  }
}

/// M_p += V^T T, which begins with the parent's own mass.
template <int rows>
LINKWORK_INLINE void add_to_parent(const block::TreeStep& step, const LaneData& data, const double* a,
                                   const Native (*V)[7], const Native (*T)[7]) {
  double* to = data.articulated_inertias + step.parent_slot * articulated * std::ptrdiff_t{width};
  const double* mass = data.mass + 10l * width * step.parent;
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = c; r < 7; ++r) {
      Native sum{};
      if (!step.parent_begins) sum = get(to, 8 * c + r);
      else if (r == right_hand_side) sum = get(a, 6l * step.parent + c);
      else if (c >= 3) sum = get(mass, 1 + 3 * (c - 3) + r - 3);
      else if (r == c) sum = get(mass, 0);
      LINKWORK_UNROLL for (int k = 0; k < rows; ++k)
        sum += V[k][r] * T[k][c];
      put(to, 8 * c + r, sum);
    }
}

/// The joint of a step, whose rows are W = D_b L^-T and G = W D^-1; `first`: 0, or 6 where it is on the ground.
template <int rows, int first>
LINKWORK_INLINE void eliminate_joint(const block::TreeStep& step, const LaneData& data, const double* a,
                                     const double* b, const Native (*W)[rows + 1], const Native (*G)[rows + 1],
                                     SmallestPivots& smallest) {
  Native S[rows][rows], V[rows][7], T[rows][7];
  LINKWORK_UNROLL for (int c = 0; c < rows; ++c) {
    LINKWORK_UNROLL for (int r = c; r <= rows; ++r) {
      Native sum = splat_native(r == c ? data.compliance[step.row + c] : 0.0);
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k)
        sum += W[k][r] * G[k][c];
      if (r < rows) S[c][r] = sum;
      else V[c][right_hand_side] = get(b, step.row + c) - sum;
    }
    LINKWORK_UNROLL for (int k = first; k < 6; ++k)
      V[c][k] = get(data.D, step.D_parent + 6 * c + k);
  }
  factor_joint_of<rows, first>(S, V, T, smallest);
  if constexpr (first == 0) add_to_parent<rows>(step, data, a, V, T);
  double* factors = data.factors + (step.storage + 48) * width;
  LINKWORK_UNROLL for (int k = rows - 1; k >= 0; --k) LINKWORK_UNROLL
    for (int r = first; r < 7; ++r) {
      LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c)
        T[k][r] -= T[c][r] * S[k][c];
      put(factors, 8 * k + r, T[k][r]);
    }
}

template <int rows>
void factor_step(const block::TreeStep& step, const LaneData& data, const double* a, const double* b,
                 SmallestPivots& smallest) {
  Native M[6][6], W[6][rows + 1], G[6][rows + 1];
  load_body<rows>(step, data, a, M, W);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = 0; r < rows; ++r) W[c][r] = get(data.D, step.D_body + 6 * r + c);
  factor_body_of<rows>(M, W, G, smallest);
  if constexpr (rows > 0) {
    if (step.parent >= 0) eliminate_joint<rows, 0>(step, data, a, b, W, G, smallest);
    else eliminate_joint<rows, 6>(step, data, a, b, W, G, smallest);
  }
  double* factors = data.factors + step.storage * width;
  LINKWORK_UNROLL for (int k = 5; k >= 0; --k) LINKWORK_UNROLL
    for (int r = 0; r <= rows; ++r) {
      LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c)
        G[k][r] -= G[c][r] * M[k][c];
      put(factors, 8 * k + (r < rows ? r : right_hand_side), G[k][r]);
    }
}

template <int rows>
void backward_step(const block::TreeStep& step, const LaneData& data, double* x, double* lambda) {
  const double* factors = data.factors + step.storage * width;
  Native l[8]{};
  LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
    Native products[8]{};
    if (step.parent >= 0) LINKWORK_UNROLL
      for (int c = 0; c < 6; ++c) products[c] = -(get(factors, 48 + 8 * k + c) * get(x, 6l * step.parent + c));
    products[right_hand_side] = get(factors, 48 + 8 * k + right_hand_side);
    l[k] = sum_of_eight(products);
    put(lambda, step.row + k, l[k]);
  }
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    Native products[8]{};
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      products[r] = get(factors, 8 * k + r) * l[r];
    products[right_hand_side] = get(factors, 8 * k + right_hand_side);
    put(x, 6l * step.body + k, sum_of_eight(products));
  }
}

/// Calls f with the number of rows of a joint, 0 to 6, as a constant.
template <class Function>
LINKWORK_INLINE void with_rows(int rows, const Function& f) {
  if (rows == 0) f(std::integral_constant<int, 0>());
  else with_count<6>(rows, f);
}

void factor_branches(const LaneData& data, const double* a, const double* b, SmallestPivots& smallest) {
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s)
    with_rows(data.steps[s].rows, [&](auto rows) { factor_step<rows>(data.steps[s], data, a, b, smallest); });
}

void backward_branches(const LaneData& data, double* x, double* lambda) {
  for (std::ptrdiff_t s = data.step_count; s-- > 0;)
    with_rows(data.steps[s].rows, [&](auto rows) { backward_step<rows>(data.steps[s], data, x, lambda); });
}

}  // namespace
}  // namespace linkwork
