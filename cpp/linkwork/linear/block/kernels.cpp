// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/math/simd.hpp"

namespace linkwork::block {
namespace {

using namespace simd::LINKWORK_ISA;

constexpr double right_hand_side_lane[lanes] = {0, 0, 0, 0, 0, 0, 1, 0};
constexpr double minus_x[lanes] = {-1, -1, -1, -1, -1, -1, 0, 0};

/// Columns of a block of D with `rows` rows.
template <int rows>
LINKWORK_INLINE void load_columns(const double* D, Vector* columns) {
  if constexpr (width == 8) {
    Native square[width];
    for (int r = 0; r < width; ++r) square[r] = r < rows ? load_first<6>(D + 6 * r).part[0] : Native{};
    transpose(square);
    for (int c = 0; c < 6; ++c) columns[c].part[0] = square[c];
  } else {
    for (int c = 0; c < 6; ++c) {
      columns[c] = splat(0.0);
      for (int r = 0; r < rows; ++r) columns[c].set(r, D[6 * r + c]);
    }
  }
}

/// Column c of M, and a_c in the lane of the right-hand side.
LINKWORK_INLINE Vector mass_column(const MassBlock& mass, int c, double a_c) {
  const Vector column = c < 3 ? unit(c) * splat(mass.m) : load_lanes<3, 3>(mass.J + 3 * (c - 3));
  return column + unit(right_hand_side) * splat(a_c);
}

constexpr double not_a_number = -__builtin_inf();  // as a ratio of pivots: the smallest of all

/// Keeps the smallest pivot relative to its diagonal entry.
LINKWORK_INLINE void note(SmallestPivot& smallest, double pivot, double diagonal, int row) {
  if (pivot >= smallest.ratio * diagonal) return;
  const double ratio = pivot / diagonal;
  smallest = {ratio == ratio ? ratio : not_a_number, row};
}

// --- open branches ---------------------------------------------------------------------------------------------------
//
// A body b held by one joint with rows D_b, D_p (p: the parent). With M_b = L D L^T, W = D_b L^-T and
// S = E + W D^-1 W^T = K D' K^T, V = K^-1 D_p, z = K^-1 (b - D_b M_b^-1 a_b):
//   M_p += V^T D'^-1 V,  a_p += V^T D'^-1 z
// and on the way back, with G = M_b^-1 D_b^T, T = S^-1 D_p (the only numbers that are kept):
//   lambda = S^-1 K z - T x_p,   x_b = M_b^-1 a_b + G lambda
// Right-hand sides ride along: a in the lane behind the rows of D, z in the lane behind the columns of D_p.

template <int rows>
LINKWORK_INLINE void factor_step(const TreeStep& step, const Data& data, const double* a, const double* b,
                                 SmallestPivot& smallest) {
  constexpr int n = rows > 0 ? rows : 1;  // arrays of length zero are not C++
  const Vector in_right_hand_side = unit(right_hand_side);
  Vector M[6], W[6];
  load_columns<rows>(data.D + step.D_body, W);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
    if (step.slot >= 0) M[c] = load(data.accumulators + step.slot * accumulator_size + c * lanes);
    else M[c] = mass_column(data.mass[step.body], c, a[6 * step.body + c]);
    W[c] += M[c] * in_right_hand_side;
  }
  Vector L[6], G[6];
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
    const Vector pivot = lane(M[k], k), inverse = splat(1.0 / pivot[0]);
    L[k] = M[k] * inverse;
    G[k] = W[k] * inverse;
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) {
      // the next pivot waits for this column: one operation less behind the division
      if (c == k + 1) M[c] -= (M[k] * lane(M[k], c)) * inverse;
      else M[c] -= M[k] * lane(L[k], c);
      W[c] -= W[k] * lane(L[k], c);
    }
    if (!(pivot[0] > 0.0)) smallest = {pivot[0] == pivot[0] ? 0.0 : not_a_number, rows > 0 ? step.row : -1};
  }
  double* factors = data.factors + step.storage;
  Vector S[n], V[n], T[n];
  if constexpr (rows > 0) {
    LINKWORK_UNROLL for (int c = 0; c < rows; ++c) {
      S[c] = unit(c) * splat(data.e[step.row + c]);
      LINKWORK_UNROLL for (int k = 0; k < 6; ++k) S[c] += W[k] * lane(G[k], c);
      V[c] = unit(right_hand_side) * (splat(b[step.row + c]) - S[c]);
      if (step.parent >= 0) V[c] += load_first<6>(data.D + step.D_parent + 6 * c);
    }
    double diagonal[n];
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) diagonal[k] = S[k][k];
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) {
      const Vector pivot = lane(S[k], k), inverse = splat(1.0 / pivot[0]);
      note(smallest, pivot[0], diagonal[k], step.row + k);
      const Vector K = S[k] * inverse;
      T[k] = V[k] * inverse;
      LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c) {
        if (c == k + 1) S[c] -= (S[k] * lane(S[k], c)) * inverse;
        else S[c] -= S[k] * lane(K, c);
        V[c] -= V[k] * lane(K, c);
      }
      S[k] = K;
    }
    if (step.parent >= 0) {
      double* accumulator = data.accumulators + step.parent_slot * accumulator_size;
      LINKWORK_UNROLL for (int c = 0; c < 6; ++c) {
        Vector sum;
        if (step.parent_begins) sum = mass_column(data.mass[step.parent], c, a[6 * step.parent + c]);
        else sum = load(accumulator + c * lanes);
        LINKWORK_UNROLL for (int k = 0; k < rows; ++k) sum += V[k] * lane(T[k], c);
        store(accumulator + c * lanes, sum);
      }
    }
    LINKWORK_UNROLL for (int k = rows - 1; k >= 0; --k) {
      LINKWORK_UNROLL for (int c = k + 1; c < rows; ++c) T[k] -= T[c] * lane(S[k], c);
      store(factors + (6 + k) * lanes, T[k]);
    }
  }
  LINKWORK_UNROLL for (int k = 5; k >= 0; --k) {
    LINKWORK_UNROLL for (int c = k + 1; c < 6; ++c) G[k] -= G[c] * lane(L[k], c);
    store(factors + k * lanes, G[k]);
  }
}

/// x of a body as (-x, 1), in the accumulator that the way back no longer needs.
LINKWORK_INLINE void leave_for_children(Vector x, int slot, const Data& data) {
  store(data.accumulators + slot * accumulator_size, x * load(minus_x) + unit(right_hand_side));
}

template <int rows>
LINKWORK_INLINE void backward_step(const TreeStep& step, const Data& data, double* x, double* lambda) {
  const Vector one = unit(right_hand_side);
  const double* factors = data.factors + step.storage;
  Vector products[6], l = splat(0.0);
  if constexpr (rows > 0) {
    const Vector x_parent =
        load(step.parent >= 0 ? data.accumulators + step.parent_slot * accumulator_size : right_hand_side_lane);
    LINKWORK_UNROLL for (int k = 0; k < rows; ++k) products[k] = load(factors + (6 + k) * lanes) * x_parent;
    l = sums<rows>(products);
    store_first<rows>(lambda + step.row, l);
  }
  l += one;
  LINKWORK_UNROLL for (int k = 0; k < 6; ++k) products[k] = load(factors + k * lanes) * l;
  const Vector x_body = sums<6>(products);
  store_first<6>(x + 6 * step.body, x_body);
  if (step.slot >= 0) leave_for_children(x_body, step.slot, data);
}

#define LINKWORK_BY_ROWS(FUNCTION, ...) \
  switch (step.rows) {                  \
    case 0:                             \
      FUNCTION<0>(__VA_ARGS__);         \
      break;                            \
    case 1:                             \
      FUNCTION<1>(__VA_ARGS__);         \
      break;                            \
    case 2:                             \
      FUNCTION<2>(__VA_ARGS__);         \
      break;                            \
    case 3:                             \
      FUNCTION<3>(__VA_ARGS__);         \
      break;                            \
    case 4:                             \
      FUNCTION<4>(__VA_ARGS__);         \
      break;                            \
    case 5:                             \
      FUNCTION<5>(__VA_ARGS__);         \
      break;                            \
    default:                            \
      FUNCTION<6>(__VA_ARGS__);         \
  }

// --- the core: closed loops
// ----------------------------------------------------------------------------------------------

void clear(const Front& front, const Data& data) {
  double* panel = data.panels + front.panel;
  for (std::ptrdiff_t k = 0; k < front.width * front.panel_stride; k += lanes) store(panel + k, splat(0.0));
  double* update = data.updates + front.update;
  for (std::ptrdiff_t k = 0; k < (front.size - front.width) * front.update_stride; k += lanes)
    store(update + k, splat(0.0));
}

/// Fills a body's front with [M; a] from its accumulator or its mass, and its rows of D.
void begin_body(const Front& front, const Data& data, const double* a) {
  clear(front, data);
  double* panel = data.panels + front.panel;
  for (int c = 0; c < 6; ++c) {
    const Vector column = front.slot >= 0 ? load(data.accumulators + front.slot * accumulator_size + c * lanes)
                                          : mass_column(data.mass[front.body], c, a[6 * front.body + c]);
    double* out = panel + c * front.panel_stride;
    for (int r = 0; r < 6; ++r) out[r] = column[r];
    out[front.size] = column[right_hand_side];
  }
  for (int k = front.first_block; k < front.first_block + front.blocks; ++k) {
    const BodyBlock& block = data.blocks[k];
    for (int r = 0; r < block.rows; ++r)
      for (int c = 0; c < 6; ++c) panel[c * front.panel_stride + block.front_row + r] = data.D[block.D + 6 * r + c];
  }
}

void begin_joints(const Front& front, const Data& data, const double* b) {
  for (int c = 0; c < front.width; ++c) {
    const int row = data.unknowns[front.unknown + c];
    double* out = data.panels + front.panel + c * front.panel_stride;
    out[c] += data.e[row];
    out[front.size] += b[row];
  }
}

/// y -= x f over whole vectors.
LINKWORK_INLINE void subtract(double* y, const double* x, double f, std::ptrdiff_t count) {
  const Vector factor = splat(f);
  for (std::ptrdiff_t k = 0; k < count; k += lanes) store(y + k, load(y + k) - load(x + k) * factor);
}

/// C(:, c) -= sum_k A(:, k) B[k][c] for four columns and `depth` terms: 16 rows at a time stay in registers.
template <int depth>
LINKWORK_INLINE void rank_update(double* C, std::ptrdiff_t C_stride, const double* A, std::ptrdiff_t A_stride,
                                 const double (*B)[4], std::ptrdiff_t count) {
  for (std::ptrdiff_t r = 0; r < count; r += lanes) {
    Vector c0 = load(C + r), c1 = load(C + C_stride + r), c2 = load(C + 2 * C_stride + r),
           c3 = load(C + 3 * C_stride + r);
    for (int k = 0; k < depth; ++k) {
      const Vector a = load(A + k * A_stride + r);
      c0 -= a * splat(B[k][0]);
      c1 -= a * splat(B[k][1]);
      c2 -= a * splat(B[k][2]);
      c3 -= a * splat(B[k][3]);
    }
    store(C + r, c0);
    store(C + C_stride + r, c1);
    store(C + 2 * C_stride + r, c2);
    store(C + 3 * C_stride + r, c3);
  }
}

/// Column c of a front from row `from` on (from is a multiple of 8 away from the stored beginning): panel or update.
LINKWORK_INLINE double* column_of(const Front& front, const Data& data, int c) {
  if (c < front.width) return data.panels + front.panel + c * front.panel_stride;
  return data.updates + front.update + (c - front.width) * front.update_stride - front.width;
}

constexpr int block_width = 8;

/// LDL^T of the panel in place (unit L, 1/d on the diagonal) and the update U -= L D L^T, right-hand side included.
void factor_front(const Front& front, const Data& data, SmallestPivot& smallest) {
  double* panel = data.panels + front.panel;
  const std::ptrdiff_t stride = front.panel_stride;
  double scaled[block_width][4];
  for (int k0 = 0; k0 < front.width; k0 += block_width) {
    const int depth = front.width - k0 < block_width ? front.width - k0 : block_width;
    const std::ptrdiff_t top = k0 / lanes * lanes, rows = stride - top;
    double pivots[block_width];
    // the block itself, column after column, unscaled: column k holds L d
    for (int k = k0; k < k0 + depth; ++k) {
      const double d = panel[k * stride + k];
      pivots[k - k0] = d;
      const double inverse = 1.0 / d;
      for (int c = k + 1; c < k0 + depth; ++c)
        subtract(panel + c * stride + top, panel + k * stride + top, panel[k * stride + c] * inverse, rows);
    }
    // what follows, four columns at a time: C -= (L d) L^T
    for (int c = k0 + depth; c < front.size; c += 4) {
      const int wide = front.size - c < 4 ? front.size - c : 4;
      for (int k = 0; k < depth; ++k)
        for (int w = 0; w < 4; ++w) scaled[k][w] = w < wide ? panel[(k0 + k) * stride + c + w] / pivots[k] : 0.0;
      const bool inside = c + wide <= front.width || c >= front.width;
      if (wide == 4 && depth == block_width && inside) {
        double* C = column_of(front, data, c);
        const std::ptrdiff_t C_stride = c < front.width ? stride : front.update_stride;
        const std::ptrdiff_t from =
            c < front.width ? c / lanes * lanes : front.width + (c - front.width) / lanes * lanes;
        const std::ptrdiff_t until = c < front.width ? stride : front.width + front.update_stride;
        rank_update<block_width>(C + from, C_stride, panel + k0 * stride + from, stride, scaled, until - from);
      } else {
        for (int w = 0; w < wide; ++w) {
          const int column = c + w;
          double* C = column_of(front, data, column);
          const std::ptrdiff_t from =
              column < front.width ? column / lanes * lanes : front.width + (column - front.width) / lanes * lanes;
          const std::ptrdiff_t until = column < front.width ? stride : front.width + front.update_stride;
          for (int k = 0; k < depth; ++k)
            subtract(C + from, panel + (k0 + k) * stride + from, scaled[k][w], until - from);
        }
      }
    }
    for (int k = k0; k < k0 + depth; ++k) {
      const double inverse = 1.0 / pivots[k - k0];
      double* column = panel + k * stride;
      for (std::ptrdiff_t r = top; r < stride; r += lanes) store(column + r, load(column + r) * splat(inverse));
      column[k] = inverse;
      if (front.body < 0) {
        const int row = data.unknowns[front.unknown + k];
        note(smallest, pivots[k - k0], data.diagonal[row], row);
      } else if (!(pivots[k - k0] > 0.0)) {
        smallest = {pivots[k - k0] == pivots[k - k0] ? 0.0 : not_a_number, -1};
      }
    }
  }
  if (front.body >= 0)  // what this body adds to the diagonal of D M^-1 D^T
    for (int r = front.width; r < front.size; ++r)
      data.diagonal[data.unknowns[front.unknown + r]] -=
          data.updates[front.update + (r - front.width) * (front.update_stride + 1)];
}

/// Adds a front's update to its parent, run by run.
void extend_add(const Front& front, const Data& data) {
  const Front& parent = data.fronts[front.parent];
  const Segment* segments = data.segments + front.first_segment;
  const int rows = front.size - front.width;
  for (int s = 0; s < front.segments; ++s)
    for (int c = 0; c < segments[s].length; ++c) {
      const int column = segments[s].begin + c;
      const double* from = data.updates + front.update + column * front.update_stride;
      double* to = column_of(parent, data, segments[s].parent_begin + c);
      for (int r = c; r < segments[s].length; ++r)
        to[segments[s].parent_begin + r] += front.sign * from[segments[s].begin + r];
      for (int t = s + 1; t < front.segments; ++t)
        for (int r = 0; r < segments[t].length; ++r)
          to[segments[t].parent_begin + r] += front.sign * from[segments[t].begin + r];
      to[parent.size] += from[rows];
    }
}

void factor_branches(const Data& data, const double* a, const double* b, SmallestPivot& smallest) {
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s) {
    const TreeStep& step = data.steps[s];
    LINKWORK_BY_ROWS(factor_step, step, data, a, b, smallest)
  }
}

SmallestPivot factor(const Data& data, const double* a, const double* b) {
  SmallestPivot smallest;
  factor_branches(data, a, b, smallest);
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    if (front.body >= 0) begin_body(front, data, a);
    else begin_joints(front, data, b);
    factor_front(front, data, smallest);
    if (front.parent < 0) continue;
    if (front.begins_parent) clear(data.fronts[front.parent], data);
    extend_add(front, data);
  }
  return smallest;
}

/// The right-hand side part of clear, begin_body or begin_joints, factor_front and extend_add.
void clear_right_hand_side(const Front& front, const Data& data) {
  for (int c = 0; c < front.size; ++c) column_of(front, data, c)[front.size] = 0.0;
}

void forward_front(const Front& front, const Data& data, const double* a, const double* b) {
  double* panel = data.panels + front.panel;
  if (front.body >= 0) clear_right_hand_side(front, data);
  for (int k = 0; k < front.width; ++k) {
    double& value = panel[k * front.panel_stride + front.size];
    if (front.body < 0) value += b[data.unknowns[front.unknown + k]];
    else
      value = front.slot >= 0 ? data.accumulators[front.slot * accumulator_size + k * lanes + right_hand_side]
                              : a[6 * front.body + k];
  }
  for (int k = 0; k < front.width; ++k) {
    double* L = panel + k * front.panel_stride;
    const double y = L[front.size];
    for (int c = k + 1; c < front.size; ++c) column_of(front, data, c)[front.size] -= L[c] * y;
    L[front.size] = y * L[k];
  }
  if (front.parent < 0) return;
  const Front& parent = data.fronts[front.parent];
  if (front.begins_parent) clear_right_hand_side(parent, data);
  const Segment* segments = data.segments + front.first_segment;
  for (int s = 0; s < front.segments; ++s)
    for (int c = 0; c < segments[s].length; ++c)
      column_of(parent, data, segments[s].parent_begin + c)[parent.size] +=
          column_of(front, data, front.width + segments[s].begin + c)[front.size];
}

/// On open branches a substitution would cost what the factorization does: both wait for the way to the root.
void forward(const Data& data, const double* a, const double* b) {
  SmallestPivot unchanged;
  factor_branches(data, a, b, unchanged);
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) forward_front(data.fronts[f], data, a, b);
}

void backward(const Data& data, double* x, double* lambda) {
  for (std::ptrdiff_t f = data.front_count; f-- > 0;) {
    const Front& front = data.fronts[f];
    const double* panel = data.panels + front.panel;
    const int* unknown = data.unknowns + front.unknown;
    double* own = front.body >= 0 ? x : lambda;
    const double sign = front.body >= 0 ? 1.0 : -1.0;  // of the coupling: D^T lambda drives a body
    for (int k = front.width - 1; k >= 0; --k) {
      const double* L = panel + k * front.panel_stride;
      double value = L[front.size];
      for (int r = front.width; r < front.size; ++r) value += sign * L[r] * lambda[unknown[r]];
      for (int r = k + 1; r < front.width; ++r) value -= L[r] * own[unknown[r]];
      own[unknown[k]] = value;
    }
    if (front.slot >= 0) leave_for_children(load_first<6>(x + 6 * front.body), front.slot, data);
  }
  for (std::ptrdiff_t s = data.step_count; s-- > 0;) {
    const TreeStep& step = data.steps[s];
    LINKWORK_BY_ROWS(backward_step, step, data, x, lambda)
  }
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(kernels_, ISA)

extern const Kernels LINKWORK_NAME(LINKWORK_ISA);
const Kernels LINKWORK_NAME(LINKWORK_ISA) = {&factor, &forward, &backward};

}  // namespace linkwork::block
