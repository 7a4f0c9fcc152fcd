// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/block/kernels.hpp"
#include <type_traits>

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

/// Keeps the smallest pivot relative to its diagonal entry; what follows a breakdown is its consequence.
LINKWORK_INLINE void note(SmallestPivot& smallest, double pivot, double diagonal, int row, const Data& data) {
  if (pivot >= smallest.ratio * diagonal || smallest.ratio < data.breakdown) return;
  const double ratio = pivot / diagonal;
  smallest = {ratio == ratio ? ratio : not_a_number, row};
}

// --- memory ----------------------------------------------------------------------------------------------------------
//
// A large model does not fit into the caches, and its order is not the one that a processor guesses: what comes a few
// steps later is asked for in time.

constexpr int steps_ahead = 8, fronts_ahead = 6;
constexpr std::ptrdiff_t most_prefetched = 64 * lanes;  // of a front; more would drive out what is needed now

/// Lines of 64 bytes, to be read, or written too.
template <bool written>
LINKWORK_INLINE void prefetch(const double* from, std::ptrdiff_t count) {
  for (std::ptrdiff_t k = 0; k < count; k += lanes) __builtin_prefetch(from + k, written, 3);
}

LINKWORK_INLINE void prefetch_step(const TreeStep& step, const Data& data) {
  prefetch<false>(data.D + step.D_body, 6 * step.rows);
  prefetch<false>(data.D + step.D_parent, 6 * step.rows);
  prefetch<true>(data.factors + step.storage, step_storage(step.rows));
  __builtin_prefetch(&data.mass[step.body]);
}

LINKWORK_INLINE void prefetch_front(const Front& front, const Data& data) {
  if (front.body >= 0) {
    const std::ptrdiff_t* D_rows = data.D_rows + front.D_row;
    for (int r = 0; r < front.size - 6; ++r) __builtin_prefetch(data.D + D_rows[r]);
  }
  if (!front.keeps_panel()) return;
  const std::ptrdiff_t size = (front.width + 1) * static_cast<std::ptrdiff_t>(front.stride());
  prefetch<true>(data.panels + front.panel, size < most_prefetched ? size : most_prefetched);
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
      note(smallest, pivot[0], diagonal[k], step.row + k, data);
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

// --- the core: closed loops ------------------------------------------------------------------------------------------
//
// A body is a front of its own: what it keeps are the rows of its joints, and the update is its part of D M^-1 D^T.
// Joints are eliminated in supernodes. Every front goes through the same steps, 8 columns at a time.
//
// A hub, a body with many joints, is eliminated among the joints, for it would couple all of them: then the matrix is
// [S D; D^T -M] with S of the other bodies, quasi-definite, and pivots of hubs are negative.

LINKWORK_INLINE double* right_hand_side_of(const Front& front, const Data& data) {
  return data.panels + front.panel + front.width * static_cast<std::ptrdiff_t>(front.stride());
}

/// The column at a position, such that its entry at position p is [p]: of the panel, or of the update.
LINKWORK_INLINE double* column_of(const Front& front, const Data& data, int position) {
  if (position < front.top) return data.panels + front.panel + position * static_cast<std::ptrdiff_t>(front.stride());
  return data.updates + front.update + (position - front.top) * static_cast<std::ptrdiff_t>(front.kept) - front.top;
}

/// Zeros where a front's children add: the lower triangle, from the vector on that holds the diagonal.
void clear(const Front& front, const Data& data) {
  for (int c = 0; c < front.size; ++c) {
    const int position = c < front.width ? c : c - front.width + front.top;
    double* column = column_of(front, data, position);
    for (int p = position / lanes * lanes; p < front.stride(); p += lanes) store(column + p, splat(0.0));
  }
  double* right = right_hand_side_of(front, data);
  for (int p = 0; p < front.stride(); p += lanes) store(right + p, splat(0.0));
}

LINKWORK_INLINE Vector body_right_hand_side(int body, int slot, const Data& data, const double* a) {
  if (slot < 0) return load_first<6>(a + 6 * body);
  const double* accumulator = data.accumulators + slot * accumulator_size;
  Vector out = splat(0.0);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) out += unit(c) * splat(accumulator[c * lanes + right_hand_side]);
  return out;
}

/// The columns of D^T of as many kept rows as a register holds.
LINKWORK_INLINE void gather_D(const Front& front, const Data& data, int first, Native* columns) {
  static constexpr double nothing[6] = {};
  const std::ptrdiff_t* D_rows = data.D_rows + front.D_row;
  const double* rows[width];
  for (int l = 0; l < width; ++l) rows[l] = first + l < front.size - 6 ? data.D + D_rows[first + l] : nothing;
  gather<6>(rows, columns);
}

LINKWORK_INLINE Vector column_of_mass(int body, int slot, int c, const Data& data) {
  if (slot >= 0) return load(data.accumulators + slot * accumulator_size + c * lanes);
  return mass_column(data.mass[body], c, 0.0);
}

/// Fills a body's front with [M; D | a].
void begin_body(const Front& front, const Data& data, const double* a) {
  double* panel = data.panels + front.panel;
  const std::ptrdiff_t stride = front.stride();
  const Vector first_six = lanes_before(6);
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c)
      store(panel + c * stride, column_of_mass(front.body, front.slot, c, data) * first_six);
  for (int first = 0; first < front.kept; first += width) {
    Native columns[6];
    gather_D(front, data, first, columns);
    LINKWORK_UNROLL for (int c = 0; c < 6; ++c) store_native(panel + c * stride + front.top + first, columns[c]);
  }
  double* right = panel + 6 * stride;
  store(right, body_right_hand_side(front.body, front.slot, data, a));
  for (int p = front.top; p < front.stride(); p += lanes) store(right + p, splat(0.0));
}

/// Adds b, and -a of hubs, to the right-hand side of a front of joints.
void add_given(const Front& front, const Data& data, const double* a, const double* b) {
  double* right = right_hand_side_of(front, data);
  for (int c = 0; c < front.width; ++c)
    if (const int row = data.unknowns[front.unknown + c]; row >= 0) right[c] += b[row];
  if (front.mixed < 0) return;
  const MixedFront& mixed = data.mixed[front.mixed];
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const Vector a_hub = body_right_hand_side(data.hubs[h].body, data.hubs[h].slot, data, a);
    for (int k = 0; k < 6; ++k) right[data.hubs[h].position + k] -= a_hub[k];
  }
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

void begin_joints(const Front& front, const Data& data, const double* a, const double* b) {
  const bool mixed = front.mixed >= 0;
  if (mixed && data.mixed[front.mixed].childless) clear(front, data);
  for (int c = 0; c < front.width; ++c)
    if (const int row = data.unknowns[front.unknown + c]; row >= 0) column_of(front, data, c)[c] += data.e[row];
  if (mixed) add_hubs(front, data.mixed[front.mixed], data);
  add_given(front, data, a, b);
}

/// C(:, w) = (C(:, w) or 0) -+ sum_k A(:, k) B(k, w) for `columns` columns, `rows` vectors of rows at a time.
template <int depth, int columns, int rows, bool fresh>
LINKWORK_INLINE void multiply_add(double* C, std::ptrdiff_t C_stride, const double* A, std::ptrdiff_t A_stride,
                                  const double* B, std::ptrdiff_t B_stride) {
  Vector c[columns][rows];
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int r = 0; r < rows; ++r) c[w][r] =
      fresh ? splat(0.0) : load(C + w * C_stride + r * lanes);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    Vector a[rows];
    LINKWORK_UNROLL for (int r = 0; r < rows; ++r) a[r] = load(A + k * A_stride + r * lanes);
    LINKWORK_UNROLL for (int w = 0; w < columns; ++w) {
      const Vector factor = splat(B[k * B_stride + w]);
      LINKWORK_UNROLL for (int r = 0; r < rows; ++r) {
        if constexpr (fresh) c[w][r] += a[r] * factor;
        else c[w][r] -= a[r] * factor;
      }
    }
  }
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL for (int r = 0; r < rows; ++r)
      store(C + w * C_stride + r * lanes, c[w][r]);
}

/// The columns at positions [first, last) of a front, from their diagonal on: C -+= U L^T with the `depth` columns of a
/// narrow front, U unscaled in the scratch memory and L in the panel.
template <int depth, bool fresh>
void update_columns(const Front& front, const Data& data, int first, int last) {
  const std::ptrdiff_t stride = front.stride();
  const double* L = data.panels + front.panel;
  const int end = front.stride();
  for (int c = first; c < last;) {
    double* C = column_of(front, data, c);
    const int columns = last - c;
    int p = c / lanes * lanes;
    const auto sweep = [&](auto count) {
      for (; p + lanes < end; p += 2 * lanes)
        multiply_add<depth, count, 2, fresh>(C + p, front.kept, data.scratch + p, stride, L + c, stride);
      if (p < end) multiply_add<depth, count, 1, fresh>(C + p, front.kept, data.scratch + p, stride, L + c, stride);
      c += count;
    };
    if (columns >= 4) sweep(std::integral_constant<int, 4>());
    else if (columns == 3) sweep(std::integral_constant<int, 3>());
    else if (columns == 2) sweep(std::integral_constant<int, 2>());
    else sweep(std::integral_constant<int, 1>());
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
  const std::ptrdiff_t stride = front.stride();
  const double* panel = data.panels + front.panel;
  double* B = data.scratch;  // D L^T, `lanes` columns of it
  for (int k = 0; k < depth; ++k) store(B + k * lanes, load(panel + k * stride + c) * splat(data.pivots[k]));
  double* C = column_of(front, data, c);
  const std::ptrdiff_t C_stride = c < front.top ? stride : front.kept;
  constexpr int tile = width == 8 ? 8 : width == 4 ? 4 : 2;
  constexpr int tile_rows = width == 8 ? 2 : 1;  // accumulators fill the registers
  int w = 0;
  const auto sweep = [&](auto count) {
    int p = c;
    for (; p + tile_rows * lanes <= front.stride(); p += tile_rows * lanes)
      subtract_product<count, tile_rows>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
    for (; p < front.stride(); p += lanes)
      subtract_product<count, 1>(C + w * C_stride + p, C_stride, panel + p, stride, B + w, depth);
    w += count;
  };
  while (w + tile <= columns) sweep(std::integral_constant<int, tile>());
  while (w < columns) sweep(std::integral_constant<int, 1>());
}

/// LDL^T of `depth` columns from k0 on and of the right-hand side. The panel is left with unit L, 1/d on its diagonal,
/// and D^-1 L^-1 of the right-hand side; the scratch memory with L D.
template <int depth, bool is_body>
void eliminate(const Front& front, const Data& data, int k0, SmallestPivot& smallest) {
  const std::ptrdiff_t stride = front.stride();
  double *panel = data.panels + front.panel + k0 * stride, *right = right_hand_side_of(front, data);
  Vector T[depth], inverse[depth], z[depth];
  LINKWORK_UNROLL for (int c = 0; c < depth; ++c) T[c] = load(panel + c * stride + k0);
  Vector y = load(right + k0), solved = splat(0.0);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    const Vector pivot = lane(T[k], k);
    if constexpr (is_body) {
      if (!(pivot[0] > 0.0)) smallest = {pivot[0] == pivot[0] ? 0.0 : not_a_number, -1};
    } else {
      const int row = data.unknowns[front.unknown + k0 + k];
      if (row >= 0) note(smallest, pivot[0], data.diagonal[row], row, data);
      else note(smallest, -pivot[0], 0.0, -1, data);
    }
    data.pivots[k0 + k] = pivot[0];
    inverse[k] = splat(1.0 / pivot[0]);
    const Vector L = T[k] * inverse[k];
    z[k] = lane(y, k) * inverse[k];
    LINKWORK_UNROLL for (int c = k + 1; c < depth; ++c) {
      if (c == k + 1) T[c] -= (T[k] * lane(T[k], c)) * inverse[k];
      else T[c] -= T[k] * lane(L, c);
    }
    y -= T[k] * z[k];
    solved += unit(k) * z[k];
    T[k] = L;
    store(panel + k * stride + k0, L * lanes_after(k) + unit(k) * inverse[k]);
  }
  store(right + k0, solved);
  for (int p = k0 + lanes; p < front.stride(); p += lanes) {
    Vector B[depth], r = load(right + p);
    LINKWORK_UNROLL for (int c = 0; c < depth; ++c) B[c] = load(panel + c * stride + p);
    LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
      LINKWORK_UNROLL for (int c = k + 1; c < depth; ++c) B[c] -= B[k] * lane(T[k], c);
      r -= B[k] * z[k];
      store(data.scratch + k * stride + p, B[k]);
      store(panel + k * stride + p, B[k] * inverse[k]);
    }
    store(right + p, r);
  }
}

/// y = D^-1 L^-1 a of a body without branches.
LINKWORK_INLINE void solve_lower(const MassFactor& factor, double* y) {
  y[4] -= factor.L43 * y[3];
  y[5] -= factor.L53 * y[3] + factor.L54 * y[4];
  for (int k = 0; k < 6; ++k) y[k] *= factor.inverse[k];
}

/// A body without branches: what [M; D | a] leaves, with constant factors of M. With `right_hand_side_only` nothing but
/// the last column.
template <bool right_hand_side_only>
void eliminate_constant_mass(const Front& front, const Data& data, const double* a) {
  const std::ptrdiff_t stride = front.stride();
  const MassFactor& factor = data.mass_factors[front.mass_factor];
  double *panel = data.panels + front.panel, *right = panel + 6 * stride;
  double y[6];
  for (int k = 0; k < 6; ++k) y[k] = a[6 * front.body + k];
  solve_lower(factor, y);
  for (int first = 0; first < front.kept; first += width) {
    Native B[6], r{};
    gather_D(front, data, first, B);
    B[4] -= B[3] * splat_native(factor.L43);
    B[5] -= B[3] * splat_native(factor.L53) + B[4] * splat_native(factor.L54);
    LINKWORK_UNROLL for (int k = 0; k < 6; ++k) {
      r -= B[k] * splat_native(y[k]);
      if constexpr (right_hand_side_only) continue;
      store_native(data.scratch + k * stride + front.top + first, B[k]);
      store_native(panel + k * stride + front.top + first, B[k] * splat_native(factor.inverse[k]));
    }
    store_native(right + front.top + first, r);
  }
}

/// x = M^-1 (a + D^T lambda) of a body without branches.
void backward_constant_mass(const Front& front, const Data& data, const double* a, double* x, const double* lambda) {
  const int rows = front.size - 6, *row = data.unknowns + front.unknown + 6;
  const std::ptrdiff_t* D_rows = data.D_rows + front.D_row;
  Vector even = load_first<6>(a + 6 * front.body), odd = splat(0.0);
  int r = 0;
  for (; r + 1 < rows; r += 2) {
    even += load_first<6>(data.D + D_rows[r]) * splat(lambda[row[r]]);
    odd += load_first<6>(data.D + D_rows[r + 1]) * splat(lambda[row[r + 1]]);
  }
  if (r < rows) even += load_first<6>(data.D + D_rows[r]) * splat(lambda[row[r]]);
  even += odd;
  double y[6];
  for (int k = 0; k < 6; ++k) y[k] = even[k];
  const MassFactor& factor = data.mass_factors[front.mass_factor];
  solve_lower(factor, y);
  y[4] -= factor.L54 * y[5];
  y[3] -= factor.L43 * y[4] + factor.L53 * y[5];
  for (int k = 0; k < 6; ++k) x[6 * front.body + k] = y[k];
}

/// Calls f with the number of columns, 1 to 8, as a constant.
template <class Function>
LINKWORK_INLINE void with_depth(int depth, const Function& f) {
  switch (depth) {
    case 1:
      return f(std::integral_constant<int, 1>());
    case 2:
      return f(std::integral_constant<int, 2>());
    case 3:
      return f(std::integral_constant<int, 3>());
    case 4:
      return f(std::integral_constant<int, 4>());
    case 5:
      return f(std::integral_constant<int, 5>());
    case 6:
      return f(std::integral_constant<int, 6>());
    case 7:
      return f(std::integral_constant<int, 7>());
    default:
      return f(std::integral_constant<int, 8>());
  }
}

LINKWORK_INLINE int depth_at(const Front& front, int k0) { return front.width - k0 < lanes ? front.width - k0 : lanes; }

void factor_body(const Front& front, const Data& data, const double* a, SmallestPivot& smallest) {
  if (front.mass_factor >= 0) {
    eliminate_constant_mass<false>(front, data, a);
  } else {
    begin_body(front, data, a);
    eliminate<6, true>(front, data, 0, smallest);
  }
  update_columns<6, true>(front, data, front.top, front.top + front.size - 6);
  const double* update = data.updates + front.update;
  const int* row = data.unknowns + front.unknown + 6;  // what this body adds to the diagonal of D M^-1 D^T
  for (int r = 0; r < front.size - 6; ++r) data.diagonal[row[r]] += update[r * (front.kept + 1l)];
}

void factor_joints(const Front& front, const Data& data, const double* a, const double* b, SmallestPivot& smallest) {
  begin_joints(front, data, a, b);
  const int last = front.top + front.size - front.width;
  if (front.width <= lanes) {
    with_depth(front.width, [&](auto depth) {
      eliminate<depth, false>(front, data, 0, smallest);
      update_columns<depth, false>(front, data, front.top, last);
    });
    return;
  }
  for (int k0 = 0; k0 < front.width; k0 += lanes) {
    if (k0 > 0) update_eight_columns(front, data, k0, k0, depth_at(front, k0));
    with_depth(depth_at(front, k0), [&](auto depth) { eliminate<depth, false>(front, data, k0, smallest); });
  }
  for (int c = front.top; c < last; c += lanes)
    update_eight_columns(front, data, front.width, c, last - c < lanes ? last - c : lanes);
}

void add_right_hand_side(const Front& front, const Front& parent, const Data& data) {
  const double* from = right_hand_side_of(front, data) + front.top;
  double* to = right_hand_side_of(parent, data);
  const Segment* segments = data.segments + front.first_segment;
  for (int s = 0; s < front.segments; ++s)
    add(to + segments[s].parent_begin, from + segments[s].begin, segments[s].length);
}

/// Adds a front's update to its parent, run by run.
void extend_add(const Front& front, const Data& data) {
  const Front& parent = data.fronts[front.parent];
  const Segment* segments = data.segments + front.first_segment;
  for (int s = 0; s < front.segments; ++s)
    for (int c = 0; c < segments[s].length; ++c) {
      const double* from =
          data.updates + front.update + (segments[s].begin + c) * static_cast<std::ptrdiff_t>(front.kept);
      double* to = column_of(parent, data, segments[s].parent_begin + c);
      add(to + segments[s].parent_begin + c, from + segments[s].begin + c, segments[s].length - c);
      for (int t = s + 1; t < front.segments; ++t)
        add(to + segments[t].parent_begin, from + segments[t].begin, segments[t].length);
    }
  add_right_hand_side(front, parent, data);
}

void factor_branches(const Data& data, const double* a, const double* b, SmallestPivot& smallest) {
  for (std::ptrdiff_t s = 0; s < data.step_count; ++s) {
    const TreeStep& step = data.steps[s];
    if (s + steps_ahead < data.step_count) prefetch_step(data.steps[s + steps_ahead], data);
    LINKWORK_BY_ROWS(factor_step, step, data, a, b, smallest)
  }
}

SmallestPivot factor(const Data& data, const double* a, const double* b) {
  SmallestPivot smallest;
  factor_branches(data, a, b, smallest);
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    const Front& front = data.fronts[f];
    if (f + fronts_ahead < data.front_count) prefetch_front(data.fronts[f + fronts_ahead], data);
    if (front.body >= 0) factor_body(front, data, a, smallest);
    else factor_joints(front, data, a, b, smallest);
    if (front.parent < 0) continue;
    if (front.begins_parent) clear(data.fronts[front.parent], data);
    extend_add(front, data);
  }
  return smallest;
}

template <int depth>
void forward_block(const Front& front, const Data& data, int k0) {
  const std::ptrdiff_t stride = front.stride();
  double* right = right_hand_side_of(front, data);
  const double* panel = data.panels + front.panel + k0 * stride;
  Vector y = load(right + k0), solved = splat(0.0), y_of[depth];
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

/// The right-hand side part of clear, begin_body or begin_joints, factor_front and extend_add.
void forward_front(const Front& front, const Data& data, const double* a, const double* b) {
  double* right = right_hand_side_of(front, data);
  if (front.mass_factor >= 0) {
    eliminate_constant_mass<true>(front, data, a);
  } else {
    if (front.body >= 0) {
      store(right, body_right_hand_side(front.body, front.slot, data, a));
      for (int p = front.top; p < front.stride(); p += lanes) store(right + p, splat(0.0));
    } else {
      if (front.mixed >= 0 && data.mixed[front.mixed].childless)
        for (int p = 0; p < front.stride(); p += lanes) store(right + p, splat(0.0));
      add_given(front, data, a, b);
    }
    for (int k0 = 0; k0 < front.width; k0 += lanes)
      with_depth(depth_at(front, k0), [&](auto depth) { forward_block<depth>(front, data, k0); });
  }
  if (front.parent < 0) return;
  const Front& parent = data.fronts[front.parent];
  if (front.begins_parent)
    for (int p = 0; p < parent.stride(); p += lanes) store(right_hand_side_of(parent, data) + p, splat(0.0));
  add_right_hand_side(front, parent, data);
}

/// On open branches a substitution would cost what the factorization does: both wait for the way to the root.
void forward(const Data& data, const double* a, const double* b) {
  SmallestPivot unchanged;
  factor_branches(data, a, b, unchanged);
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f) {
    if (f + fronts_ahead < data.front_count) prefetch_front(data.fronts[f + fronts_ahead], data);
    forward_front(data.fronts[f], data, a, b);
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

void backward_front(const Front& front, const Data& data, const double* a, double* x, double* lambda) {
  if (front.mass_factor >= 0) return backward_constant_mass(front, data, a, x, lambda);
  double* right = right_hand_side_of(front, data);
  if (front.parent >= 0) {
    const double* known = right_hand_side_of(data.fronts[front.parent], data);
    const Segment* segments = data.segments + front.first_segment;
    for (int s = 0; s < front.segments; ++s)
      copy(right + front.top + segments[s].begin, known + segments[s].parent_begin, segments[s].length);
  }
  for (int p = front.top + front.size - front.width; p < front.stride(); ++p) right[p] = 0.0;
  if (front.body >= 0) {
    const Vector minus = splat(-1.0);  // D^T lambda drives a body
    for (int p = front.top; p < front.stride(); p += lanes) store(right + p, load(right + p) * minus);
    backward_block<6>(front, data, 0);
    const Vector solution = load(right);
    store_first<6>(x + 6 * front.body, solution);
    if (front.slot >= 0) leave_for_children(solution, front.slot, data);
    return;
  }
  for (int k0 = (front.width - 1) / lanes * lanes; k0 >= 0; k0 -= lanes)
    with_depth(depth_at(front, k0), [&](auto depth) { backward_block<depth>(front, data, k0); });
  for (int k = 0; k < front.width; ++k) {
    const int unknown = data.unknowns[front.unknown + k];
    (unknown >= 0 ? lambda[unknown] : x[~unknown]) = right[k];
  }
  if (front.mixed < 0) return;
  const MixedFront& mixed = data.mixed[front.mixed];
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h)
    if (data.hubs[h].slot >= 0) leave_for_children(load_first<6>(x + 6 * data.hubs[h].body), data.hubs[h].slot, data);
}

void backward(const Data& data, const double* a, double* x, double* lambda) {
  for (std::ptrdiff_t f = data.front_count; f-- > 0;) {
    if (f >= fronts_ahead) prefetch_front(data.fronts[f - fronts_ahead], data);
    backward_front(data.fronts[f], data, a, x, lambda);
  }
  for (std::ptrdiff_t s = data.step_count; s-- > 0;) {
    const TreeStep& step = data.steps[s];
    if (s >= steps_ahead) {
      const TreeStep& ahead = data.steps[s - steps_ahead];
      prefetch<false>(data.factors + ahead.storage, step_storage(ahead.rows));
    }
    LINKWORK_BY_ROWS(backward_step, step, data, x, lambda)
  }
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(kernels_, ISA)

extern const Kernels LINKWORK_NAME(LINKWORK_ISA);
const Kernels LINKWORK_NAME(LINKWORK_ISA) = {&factor, &forward, &backward};

}  // namespace linkwork::block
