#pragma once

#include "linkwork/linear/block/common_kernels.hpp"

/// Where the numbers of a front stand, and products of panels that are added to its columns.
namespace linkwork::block {
namespace {

constexpr int fronts_ahead = 3;                         // that are prefetched
constexpr std::ptrdiff_t most_prefetched = 64 * lanes;  // of a front; more would drive out what is needed now
// What the registers hold beside a factor: sums.
constexpr int columns_at_once = width == 8 ? 8 : width == 4 ? 4 : 2, vectors_at_once = width == 8 ? 2 : 1;

LINKWORK_INLINE void prefetch_front(const Front& front, const Data& data) {
  for (int body = front.first_body; body < front.first_body + front.bodies; ++body)
    for (int r = 0; r < data.bodies[body].rows; ++r)
      __builtin_prefetch(data.D + data.rows[data.bodies[body].first_row + r].D);
  const std::ptrdiff_t size = (front.width + 2) * static_cast<std::ptrdiff_t>(front.stride());
  prefetch<true>(data.panels + front.panel, size < most_prefetched ? size : most_prefetched);
}

LINKWORK_INLINE double* right_hand_side_of(const Front& front, const Data& data) {
  return data.panels + front.panel + front.width * static_cast<std::ptrdiff_t>(front.stride());
}
LINKWORK_INLINE double* diagonal_of(const Front& front, const Data& data) {
  return right_hand_side_of(front, data) + front.stride();
}

/// The column at a position, such that its entry at position p is [p]: of the panel, or of the contribution block.
LINKWORK_INLINE double* column_of(const Front& front, const Data& data, int position) {
  if (position < front.top) return data.panels + front.panel + position * static_cast<std::ptrdiff_t>(front.stride());
  return data.contributions + front.contribution +
         (position - front.top) * static_cast<std::ptrdiff_t>(front.contribution_rows) - front.top;
}

/// From a column at a position to the next.
LINKWORK_INLINE std::ptrdiff_t column_stride(const Front& front, int position) {
  return position < front.top ? front.stride() : front.contribution_rows;
}

LINKWORK_INLINE int depth_at(const Front& front, int k0) { return front.width - k0 < lanes ? front.width - k0 : lanes; }

/// Zeros where children and bodies add: the lower triangle, from the vector on that holds the diagonal.
void clear(const Front& front, const Data& data) {
  const std::ptrdiff_t end = front.stride();
  const auto clear_columns = [&](int first, int last) {
    const std::ptrdiff_t stride = column_stride(front, first);
    double* column = column_of(front, data, first);
    for (std::ptrdiff_t c = first; c < last; ++c, column += stride)
      for (std::ptrdiff_t p = c / lanes * lanes; p < end; p += lanes) store(column + p, splat(0.0));
  };
  clear_columns(0, front.width);
  clear_columns(front.top, front.top + front.size - front.width);
  double* right = right_hand_side_of(front, data);
  for (std::ptrdiff_t p = 0; p < 2 * end; p += lanes) store(right + p, splat(0.0));
}

/// C(:, w) = C(:, w) +- sum_k A(:, k) B(k, w) for `columns` columns, `vectors` vectors of rows at the places `at`.
template <int sign, int depth, int columns, int vectors>
LINKWORK_INLINE void add_product(double* C, std::ptrdiff_t C_stride, const int* at, const double* A, const double* B,
                                 std::ptrdiff_t stride) {
  Vector c[columns][vectors];
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL
    for (int v = 0; v < vectors; ++v) c[w][v] = load(C + w * C_stride + at[v]);
  LINKWORK_UNROLL for (int k = 0; k < depth; ++k) {
    Vector a[vectors];
    LINKWORK_UNROLL for (int v = 0; v < vectors; ++v)
      a[v] = load(A + k * stride + v * lanes);
    LINKWORK_UNROLL for (int w = 0; w < columns; ++w) {
      const Vector factor = splat(B[k * stride + w]);
      LINKWORK_UNROLL for (int v = 0; v < vectors; ++v) {
        if constexpr (sign > 0) c[w][v] += a[v] * factor;
        else c[w][v] -= a[v] * factor;
      }
    }
  }
  LINKWORK_UNROLL for (int w = 0; w < columns; ++w) LINKWORK_UNROLL
    for (int v = 0; v < vectors; ++v) store(C + w * C_stride + at[v], c[w][v]);
}

}  // namespace
}  // namespace linkwork::block
