#pragma once

#include <type_traits>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/math/simd.hpp"

/// What the sweeps over open branches and over the core share. For kernels.cpp only, which is compiled once per
/// instruction set.
namespace linkwork::block {
namespace {

using namespace simd::LINKWORK_ISA;

constexpr double right_hand_side_lane[lanes] = {0, 0, 0, 0, 0, 0, 1, 0};

/// Calls f with the count, 1 to `most`, as a constant.
template <int most, class Function>
LINKWORK_INLINE void with_count(int count, const Function& f) {
  if constexpr (most > 1) {
    if (count < most) return with_count<most - 1>(count, f);
  }
  f(std::integral_constant<int, most>());
}

/// 1 / (lane k of v) in all lanes: sooner there than a number that would have to be spread out.
LINKWORK_INLINE Vector inverse_of_lane(const Vector& v, int k) {
  const Native inverse = 1.0 / spread_native(v.part[k / width], k % width);
  Vector out;
  LINKWORK_EACH_PART out.part[p] = inverse;
  return out;
}

/// Columns of a block of D with `rows` rows, of which row r stands at row_at(r).
template <int rows, class RowAt>
LINKWORK_INLINE void load_columns(const RowAt& row_at, Vector* columns) {
  if constexpr (width == 8) {
    Native square[width];
    for (int r = 0; r < width; ++r) square[r] = r < rows ? load_first<6>(row_at(r)).part[0] : Native{};
    transpose(square);
    for (int c = 0; c < 6; ++c) columns[c].part[0] = square[c];
  } else {
    for (int c = 0; c < 6; ++c) {
      columns[c] = splat(0.0);
      for (int r = 0; r < rows; ++r) columns[c].set(r, row_at(r)[c]);
    }
  }
}

/// Column c of M, and a_c in the lane of the right-hand side.
LINKWORK_INLINE Vector mass_column(const MassBlock& mass, int c, double a_c) {
  const Vector column = c < 3 ? unit(c) * splat(mass.m) : load_lanes<3, 3>(mass.J + 3 * (c - 3));
  return column + unit(right_hand_side) * splat(a_c);
}

/// Lane k from b, the others from a, whatever numbers stand there.
LINKWORK_INLINE Vector with_lane(const Vector& a, const Vector& b, int k) {
  Vector out;
  LINKWORK_EACH_PART {
    NativeIndex index{};
    for (int l = 0; l < width; ++l) index[l] = p * width + l;
    out.part[p] = index == k - NativeIndex{} ? b.part[p] : a.part[p];
  }
  return out;
}

/// Whether a lane of a is below that of b, or not a number.
LINKWORK_INLINE bool any_below(const Vector& a, const Vector& b) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask((__m512d)a.part[0], (__m512d)b.part[0], _CMP_NGE_UQ) != 0;
#else
  bool all = true;
  for (int k = 0; k < lanes; ++k) all = all && a[k] >= b[k];
  return !all;
#endif
}

constexpr double not_a_number = -__builtin_inf();  // as a ratio of pivots: the smallest of all

/// A little more than the smallest ratio: pivots that are not below this part of their diagonal have no smaller one,
/// whatever rounding does, and need no division.
LINKWORK_INLINE double clearly_above(const SmallestPivot& smallest) { return smallest.ratio * (1.0 + 1e-15); }

/// Keeps the smallest pivot relative to its diagonal entry, the same one in whatever order they come; what follows a
/// breakdown is its consequence.
LINKWORK_INLINE void note(SmallestPivot& smallest, double pivot, double diagonal, int row, const Data& data) {
  if (pivot >= clearly_above(smallest) * diagonal || smallest.ratio < data.breakdown) return;
  const double ratio = pivot / diagonal;
  if (ratio >= smallest.ratio) return;
  smallest = {ratio == ratio ? ratio : not_a_number, row};
}

/// x of a body as (-x, 1), in the articulated inertia that the way back no longer needs.
LINKWORK_INLINE void leave_for_children(Vector x, int slot, const Data& data) {
  constexpr double minus_x[lanes] = {-1, -1, -1, -1, -1, -1, 0, 0};
  store(data.articulated_inertias + slot * articulated_inertia_size, x * load(minus_x) + unit(right_hand_side));
}

/// Lines of 64 bytes, to be read, or written too. A large model does not fit into the caches, and its order is not the
/// one that a processor guesses: what comes a few steps later is asked for in time. A core's first cache waits for some
/// 20 lines at a time only: where more are asked for, they go to the second, which waits for more.
template <bool written, int nearest_cache = 1>
LINKWORK_INLINE void prefetch(const double* from, std::ptrdiff_t count) {
  for (std::ptrdiff_t k = 0; k < count; k += lanes) __builtin_prefetch(from + k, written, 4 - nearest_cache);
}

}  // namespace
}  // namespace linkwork::block
