// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/block/kernels.hpp"

namespace linkwork::block {
namespace {

typedef double Vector __attribute__((vector_size(8 * lanes)));
typedef double Unaligned __attribute__((vector_size(8 * lanes), aligned(8), may_alias));

#define LINKWORK_INLINE inline __attribute__((always_inline))

LINKWORK_INLINE Vector splat(double x) { return Vector{x, x, x, x, x, x, x, x}; }
LINKWORK_INLINE Vector load(const double* p) { return *reinterpret_cast<const Unaligned*>(p); }
LINKWORK_INLINE void store(double* p, Vector v) { *reinterpret_cast<Unaligned*>(p) = v; }
LINKWORK_INLINE Vector load6(const double* p) { return Vector{p[0], p[1], p[2], p[3], p[4], p[5], 0.0, 0.0}; }
LINKWORK_INLINE double sum6(Vector v) { return ((v[0] + v[1]) + (v[2] + v[3])) + (v[4] + v[5]); }

/// Column c of M with a_c in the lane of the right-hand side.
LINKWORK_INLINE Vector mass_column(const MassBlock& mass, int c, double a_c) {
  Vector v = splat(0.0);
  if (c < 3) {
    v[c] = mass.m;
  } else {
    for (int r = 0; r < 3; ++r) v[3 + r] = mass.J[3 * r + c - 3];
  }
  v[right_hand_side] = a_c;
  return v;
}

LINKWORK_INLINE void note(SmallestPivot& smallest, double ratio, int row) {
  if (!(ratio >= smallest.ratio)) smallest = {ratio == ratio ? ratio : -1.0, row};
}

// --- open branches
// -----------------------------------------------------------------------------------------------------
//
// A body b held by one joint with rows D_b, D_p (p: the parent):
//   M_b = L D L^T,  W = D_b L^-T,  S = E + W D^-1 W^T = K D' K^T,  V = K^-1 D_p
//   M_p += V^T D'^-1 V,  a_p += V^T D'^-1 z,  z = K^-1 (b - W D^-1 y),  y = L^-1 a_b
// Right-hand sides ride along as a further row of each panel. Stored: unit L with 1/d on its diagonal and y/d in lane
// 6, the same for K, and V scaled by 1/d' with z/d' in lane 6.

template <int rows>
LINKWORK_INLINE void factor_step(const TreeStep& step, const Data& data, const double* a, const double* b,
                                 SmallestPivot& smallest) {
  constexpr int n = rows > 0 ? rows : 1;  // arrays of length zero are not C++
  Vector M[6], W[6];
  const double* D_body = data.D + step.D_body;
  for (int c = 0; c < 6; ++c) {
    M[c] = step.slot >= 0 ? load(data.accumulators + step.slot * accumulator_size + c * lanes)
                          : mass_column(data.mass[step.body], c, a[6 * step.body + c]);
    W[c] = splat(0.0);
    for (int r = 0; r < rows; ++r) W[c][r] = D_body[6 * r + c];
  }
  double* factors = data.factors + step.storage;
  Vector W_scaled[6], z = splat(0.0);
  for (int r = 0; r < rows; ++r) z[r] = b[step.row + r];
  for (int k = 0; k < 6; ++k) {
    const double inverse = 1.0 / M[k][k];
    Vector L = M[k] * splat(inverse);
    W_scaled[k] = W[k] * splat(inverse);
    for (int c = k + 1; c < 6; ++c) {
      M[c] -= M[k] * splat(L[c]);
      W[c] -= W[k] * splat(L[c]);
    }
    z -= W[k] * splat(L[right_hand_side]);
    if (!(M[k][k] > 0.0)) note(smallest, M[k][k] == M[k][k] ? 0.0 : -1.0, rows > 0 ? step.row : -1);
    L[k] = inverse;
    store(factors + k * lanes, L);
  }
  if constexpr (rows > 0) {
    Vector S[n], V[n], V_scaled[n];
    const double* D_parent = data.D + step.D_parent;
    for (int c = 0; c < rows; ++c) {
      Vector sum = splat(0.0);
      for (int k = 0; k < 6; ++k) sum += W[k] * splat(W_scaled[k][c]);
      sum[c] += data.e[step.row + c];
      S[c] = sum;
      V[c] = step.parent >= 0 ? load6(D_parent + 6 * c) : splat(0.0);
      V[c][right_hand_side] = z[c];
    }
    double diagonal[n];
    for (int k = 0; k < rows; ++k) diagonal[k] = S[k][k];
    for (int k = 0; k < rows; ++k) {
      note(smallest, S[k][k] / diagonal[k], step.row + k);
      const double inverse = 1.0 / S[k][k];
      Vector K = S[k] * splat(inverse);
      V_scaled[k] = V[k] * splat(inverse);
      for (int c = k + 1; c < rows; ++c) {
        S[c] -= S[k] * splat(K[c]);
        V[c] -= V[k] * splat(K[c]);
      }
      K[k] = inverse;
      store(factors + (6 + k) * lanes, K);
      store(factors + (6 + rows + k) * lanes, V_scaled[k]);
    }
    if (step.parent >= 0) {
      double* accumulator = data.accumulators + step.parent_slot * accumulator_size;
      for (int c = 0; c < 6; ++c) {
        Vector sum = step.parent_begins ? mass_column(data.mass[step.parent], c, a[6 * step.parent + c])
                                        : load(accumulator + c * lanes);
        for (int k = 0; k < rows; ++k) sum += V[k] * splat(V_scaled[k][c]);
        store(accumulator + c * lanes, sum);
      }
    }
  }
}

/// The right-hand side part of factor_step. Accumulators hold only a here, in the first vector.
template <int rows>
LINKWORK_INLINE void forward_step(const TreeStep& step, const Data& data, const double* a, const double* b) {
  double* factors = data.factors + step.storage;
  double y[6], t[6];
  for (int c = 0; c < 6; ++c)
    y[c] = step.slot >= 0 ? data.accumulators[step.slot * accumulator_size + c] : a[6 * step.body + c];
  for (int k = 0; k < 6; ++k)
    for (int c = k + 1; c < 6; ++c) y[c] -= factors[k * lanes + c] * y[k];
  for (int k = 0; k < 6; ++k) {
    t[k] = y[k] * factors[k * lanes + k];
    factors[k * lanes + right_hand_side] = t[k];
  }
  if constexpr (rows > 0) {
    for (int k = 5; k >= 0; --k)
      for (int c = k + 1; c < 6; ++c) t[k] -= factors[k * lanes + c] * t[c];
    const double* D_body = data.D + step.D_body;
    double z[rows];
    for (int r = 0; r < rows; ++r) {
      z[r] = b[step.row + r];
      for (int c = 0; c < 6; ++c) z[r] -= D_body[6 * r + c] * t[c];
    }
    double* accumulator = data.accumulators + step.parent_slot * accumulator_size;
    if (step.parent >= 0 && step.parent_begins)
      for (int c = 0; c < 6; ++c) accumulator[c] = a[6 * step.parent + c];
    for (int k = 0; k < rows; ++k) {
      const double* K = factors + (6 + k) * lanes;
      double* V = factors + (6 + rows + k) * lanes;
      for (int c = k + 1; c < rows; ++c) z[c] -= K[c] * z[k];
      V[right_hand_side] = z[k] * K[k];
      if (step.parent >= 0)
        for (int c = 0; c < 6; ++c) accumulator[c] += V[c] * z[k];
    }
  }
}

// lambda = K^-T (D'^-1 z - D'^-1 V x_p),   x_b = L^-T (D^-1 y + D^-1 L^-1 D_b^T lambda)
template <int rows>
LINKWORK_INLINE void backward_step(const TreeStep& step, const Data& data, double* x, double* lambda) {
  const double* factors = data.factors + step.storage;
  double c[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  if constexpr (rows > 0) {
    double l[rows];
    const Vector x_parent = step.parent >= 0 ? load6(x + 6 * step.parent) : splat(0.0);
    for (int k = 0; k < rows; ++k) {
      const Vector V = load(factors + (6 + rows + k) * lanes);
      l[k] = V[right_hand_side] - sum6(V * x_parent);
    }
    for (int k = rows - 1; k >= 0; --k) {
      const double* K = factors + (6 + k) * lanes;
      for (int r = k + 1; r < rows; ++r) l[k] -= K[r] * l[r];
      lambda[step.row + k] = l[k];
    }
    const double* D_body = data.D + step.D_body;
    for (int r = 0; r < rows; ++r)
      for (int k = 0; k < 6; ++k) c[k] += D_body[6 * r + k] * l[r];
    for (int k = 0; k < 6; ++k)
      for (int r = k + 1; r < 6; ++r) c[r] -= factors[k * lanes + r] * c[k];
  }
  for (int k = 0; k < 6; ++k) c[k] = c[k] * factors[k * lanes + k] + factors[k * lanes + right_hand_side];
  for (int k = 5; k >= 0; --k)
    for (int r = k + 1; r < 6; ++r) c[k] -= factors[k * lanes + r] * c[r];
  for (int k = 0; k < 6; ++k) x[6 * step.body + k] = c[k];
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
        note(smallest, pivots[k - k0] / data.diagonal[row], row);
      } else if (!(pivots[k - k0] > 0.0)) {
        note(smallest, pivots[k - k0] == pivots[k - k0] ? 0.0 : -1.0, -1);
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

SmallestPivot factor(const Data& data, const double* a, const double* b) {
  SmallestPivot smallest;
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s) {
    const TreeStep& step = data.steps[s];
    LINKWORK_BY_ROWS(factor_step, step, data, a, b, smallest)
  }
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
    else value = front.slot >= 0 ? data.accumulators[front.slot * accumulator_size + k] : a[6 * front.body + k];
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

void forward(const Data& data, const double* a, const double* b) {
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s) {
    const TreeStep& step = data.steps[s];
    LINKWORK_BY_ROWS(forward_step, step, data, a, b)
  }
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
  }
  for (std::ptrdiff_t s = data.step_count; s-- > 0;) {
    const TreeStep& step = data.steps[s];
    LINKWORK_BY_ROWS(backward_step, step, data, x, lambda)
  }
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(kernels_, ISA)
#define LINKWORK_TEXT(ISA) LINKWORK_STRING(ISA)
#define LINKWORK_STRING(ISA) #ISA

extern const Kernels LINKWORK_NAME(LINKWORK_ISA);
const Kernels LINKWORK_NAME(LINKWORK_ISA) = {"x86-64-" LINKWORK_TEXT(LINKWORK_ISA), &factor, &forward, &backward};

}  // namespace linkwork::block
