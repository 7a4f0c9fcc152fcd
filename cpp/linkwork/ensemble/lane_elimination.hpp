#pragma once

#include <type_traits>

#include "linkwork/ensemble/lanes.hpp"
#include "linkwork/linear/block/ground_elimination.hpp"
#include "linkwork/math/simd.hpp"

/// What the eliminations of lanes share. For lane_kernels.cpp only, which is compiled once per instruction set.
namespace linkwork {
namespace {

using namespace simd::LINKWORK_ISA;

/// Number k of a list.
LINKWORK_INLINE Native get(const double* from, std::ptrdiff_t k) { return load_native(from + k * width); }
LINKWORK_INLINE void put(double* to, std::ptrdiff_t k, Native x) { store_native(to + k * width, x); }

struct Lanes {
  using Number = Native;
  static constexpr std::ptrdiff_t stride = width;
  static LINKWORK_INLINE Native get(const double* from, std::ptrdiff_t k) { return linkwork::get(from, k); }
  static LINKWORK_INLINE void put(double* to, std::ptrdiff_t k, Native x) { linkwork::put(to, k, x); }
};

constexpr double not_a_number = -__builtin_inf();  // as a ratio of pivots: the smallest of all
constexpr int articulated = 48;                    // numbers of an articulated inertia: columns of 8
constexpr int right_hand_side = block::right_hand_side;

/// The smallest pivot relative to its diagonal entry in each lane; what follows a breakdown is its consequence.
struct SmallestPivots {
  double breakdown = 0.0;
  Native ratio = splat_native(1.0);

  LINKWORK_INLINE void note(Native pivot, Native diagonal) {
    const NativeIndex smaller = ~(pivot >= ratio * diagonal) & ~(ratio < splat_native(breakdown));
    if (!any(smaller)) return;
    const Native found = pivot / diagonal;
    ratio = smaller ? (found == found ? found : splat_native(not_a_number)) : ratio;
  }
  /// Where `fails`, nothing that was eliminated counts.
  LINKWORK_INLINE void note_failure(NativeIndex fails) { ratio = fails ? Native{} : ratio; }
  /// Of a mass matrix, where so much is needed.
  LINKWORK_INLINE void note_mass(Native pivot, Native least = Native{}) {
    const NativeIndex bad = ~(pivot > least);
    if (!any(bad)) return;
    ratio = bad ? (pivot == pivot ? Native{} : splat_native(not_a_number)) : ratio;
  }
};

/// One by one: of an initializer compilers make string instructions, which are slow to begin.
template <int count>
LINKWORK_INLINE void clear_numbers(Native (&x)[count]) {
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    x[k] = Native{};
}

/// The sum over the 8 lanes of a vector as block/kernels.cpp takes it on every processor: even and odd ones apart.
LINKWORK_INLINE Native sum_of_eight(const Native* x) {
  return ((x[0] + x[2]) + x[4]) + x[6] + (((x[1] + x[3]) + x[5]) + x[7]);
}

/// x = L^-1 x.
template <int size>
LINKWORK_INLINE void substitute_forward(const Native (*L)[size], Native* x) {
  LINKWORK_UNROLL for (int k = 0; k < size; ++k) LINKWORK_UNROLL
    for (int c = k + 1; c < size; ++c) x[c] -= x[k] * L[k][c];
}

/// Calls f with the count, 1 to `most`, as a constant.
template <int most, class Function>
LINKWORK_INLINE void with_count(int count, const Function& f) {
  if constexpr (most > 1) {
    if (count < most) return with_count<most - 1>(count, f);
  }
  f(std::integral_constant<int, most>());
}

/// Calls f with a count of 8 and each eighth number from `begin` on, then with the count and place of the rest: each
/// count has a loop of its own, with sums in registers.
template <class Function>
LINKWORK_INLINE void by_eights(int begin, int end, const Function& f) {
  for (; begin + 8 <= end; begin += 8) f(std::integral_constant<int, 8>(), begin);
  if (begin < end) with_count<7>(end - begin, [&](auto count) { f(count, begin); });
}

/// Of a body or a step, its joint on the ground at D.
template <class Body>
LINKWORK_INLINE block::GroundPlaces ground_places(const Body& body, std::ptrdiff_t D, std::ptrdiff_t factors,
                                                  const LaneData& data, const double* a) {
  constexpr std::ptrdiff_t stride = width;
  return {.D = data.D + D * stride,
          .articulated_inertia = body.slot < 0 ? nullptr : data.articulated_inertias + body.slot * articulated * stride,
          .mass = data.mass + 10 * stride * body.body,
          .a = a + 6 * stride * body.body,
          .factors = data.factors + factors * stride};
}

/// Calls f with the elimination on a hinge or on a slider.
template <class Function>
LINKWORK_INLINE auto with_ground_joint(bool slides, const block::GroundPlaces& places, const Function& f) {
  if (slides) return f(block::GroundElimination<Lanes, block::SliderOnGround>(places));
  return f(block::GroundElimination<Lanes, block::HingeOnGround>(places));
}

/// Begins at a joint; lanes where it is violated by far fail.
template <class Elimination>
LINKWORK_INLINE void eliminate_joint(Elimination& joint, int row, const double* b, SmallestPivots& smallest,
                                     Native least = Native{}) {
  const Native size = joint.read(b + std::ptrdiff_t{row} * width), pivot = joint.release();
  smallest.note_mass(pivot, least);
  smallest.note_failure(~(size > splat_native(block::least_size)));
}

}  // namespace
}  // namespace linkwork
