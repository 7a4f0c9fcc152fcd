#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "linkwork/math/inline.hpp"

/// Vectors of doubles for files that are compiled once per instruction set (LINKWORK_ISA = v2, v3, v4, the levels of
/// x86-64; v2 stands for any other processor), some of them for one or two doubles at a time, too (single, pair, with
/// the instructions of v4). Everything here is inlined or lives in a namespace of its own for each, so that nothing
/// compiled for a wider one is ever linked where it must not run.
namespace linkwork::simd::LINKWORK_ISA {

/// Before a loop over lanes or columns: only where all indices are known do numbers stay in registers.
#define LINKWORK_UNROLL _Pragma("GCC unroll 8")

#if defined(LINKWORK_WIDTH)
#elif defined(__AVX512F__)
#define LINKWORK_WIDTH 8
#elif defined(__AVX__)
#define LINKWORK_WIDTH 4
#else
#define LINKWORK_WIDTH 2
#endif
constexpr int width = LINKWORK_WIDTH;

/// As many doubles as one register holds.
typedef double Native __attribute__((vector_size(8 * width)));
typedef double UnalignedNative __attribute__((vector_size(8 * width), aligned(8), may_alias));
typedef long long NativeIndex __attribute__((vector_size(8 * width)));

LINKWORK_INLINE Native load_native(const double* p) { return *reinterpret_cast<const UnalignedNative*>(p); }
LINKWORK_INLINE void store_native(double* p, Native v) { *reinterpret_cast<UnalignedNative*>(p) = v; }
/// To the start of a line of memory, past the caches.
LINKWORK_INLINE void stream_native(double* to, Native v) {
#if LINKWORK_WIDTH == 8
  _mm512_stream_pd(to, (__m512d)v);
#elif LINKWORK_WIDTH == 4
  _mm256_stream_pd(to, (__m256d)v);
#else
  store_native(to, v);
#endif
}

/// Before others read what was streamed.
LINKWORK_INLINE void end_stream() {
#if defined(__AVX__)
  _mm_sfence();
#endif
}

LINKWORK_INLINE Native splat_native(double x) { return x - Native{}; }
/// Lane k in all lanes.
LINKWORK_INLINE Native spread_native(Native v, int k) {
#if defined(__clang__)
  return splat_native(v[k]);
#else  // which makes one instruction of it only where it is told of the permutation
  return __builtin_shuffle(v, k - NativeIndex{});
#endif
}

/// Whether a comparison holds in any lane.
LINKWORK_INLINE bool any(NativeIndex mask) {
#if LINKWORK_WIDTH == 8
  return _mm512_movepi64_mask((__m512i)mask) != 0;
#elif LINKWORK_WIDTH == 4
  return _mm256_movemask_pd((__m256d)mask) != 0;
#elif LINKWORK_WIDTH == 2
  return (mask[0] | mask[1]) != 0;
#else
  return mask[0] != 0;
#endif
}

/// Transposes a square of width x width numbers: lane c of row r becomes lane r of row c. Two rows give the even and
/// the odd lanes of both, or quarters of lanes; every step is one instruction.
LINKWORK_INLINE void transpose(Native* v) {
#if LINKWORK_WIDTH == 8
  Native pair[8], four[8];
  for (int k = 0; k < 8; k += 2) {
    pair[k] = __builtin_shufflevector(v[k], v[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pair[k + 1] = __builtin_shufflevector(v[k], v[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int h = 0; h < 8; h += 4)
    for (int k = 0; k < 2; ++k) {  // columns k, k + 4 and k + 2, k + 6 of four rows
      four[h + k] = __builtin_shufflevector(pair[h + k], pair[h + 2 + k], 0, 1, 4, 5, 8, 9, 12, 13);
      four[h + k + 2] = __builtin_shufflevector(pair[h + k], pair[h + 2 + k], 2, 3, 6, 7, 10, 11, 14, 15);
    }
  for (int k = 0; k < 4; ++k) {
    v[k] = __builtin_shufflevector(four[k], four[k + 4], 0, 1, 4, 5, 8, 9, 12, 13);
    v[k + 4] = __builtin_shufflevector(four[k], four[k + 4], 2, 3, 6, 7, 10, 11, 14, 15);
  }
#elif LINKWORK_WIDTH == 4
  Native pair[4];
  for (int k = 0; k < 4; k += 2) {
    pair[k] = __builtin_shufflevector(v[k], v[k + 1], 0, 4, 2, 6);
    pair[k + 1] = __builtin_shufflevector(v[k], v[k + 1], 1, 5, 3, 7);
  }
  for (int k = 0; k < 2; ++k) {
    v[k] = __builtin_shufflevector(pair[k], pair[k + 2], 0, 1, 4, 5);
    v[k + 2] = __builtin_shufflevector(pair[k], pair[k + 2], 2, 3, 6, 7);
  }
#elif LINKWORK_WIDTH == 2
  const Native low = __builtin_shufflevector(v[0], v[1], 0, 2);
  v[1] = __builtin_shufflevector(v[0], v[1], 1, 3);
  v[0] = low;
#else
  (void)v;  // which is its own
#endif
}

/// The first `count` lanes from memory, zero in the others.
template <int count>
LINKWORK_INLINE Native load_some(const double* from) {
#if LINKWORK_WIDTH == 8
  return (Native)_mm512_maskz_loadu_pd((1 << count) - 1, from);
#else
  Native v{};
  for (int k = 0; k < count; ++k) v[k] = from[k];
  return v;
#endif
}
#if LINKWORK_WIDTH == 8
/// v, with `count` lanes from `first` on from memory.
template <int first, int count>
LINKWORK_INLINE Native with_lanes(Native v, const double* from) {
  return (Native)_mm512_mask_loadu_pd((__m512d)v, ((1 << count) - 1) << first, from - first);
}
#endif
template <int count>
LINKWORK_INLINE void store_some(double* to, Native v) {
#if LINKWORK_WIDTH == 8
  _mm512_mask_storeu_pd(to, (1 << count) - 1, (__m512d)v);
#else
  for (int k = 0; k < count; ++k) to[k] = v[k];
#endif
}

/// Eight doubles in as many registers as it takes.
struct Vector {
  static constexpr int lanes = 8, parts = lanes / width;
  Native part[parts];

  LINKWORK_INLINE double operator[](int k) const { return part[k / width][k % width]; }
  LINKWORK_INLINE void set(int k, double x) { part[k / width][k % width] = x; }
};

#define LINKWORK_EACH_PART for (int p = 0; p < Vector::parts; ++p)

LINKWORK_INLINE Vector splat(double x) {
  Vector out;
  LINKWORK_EACH_PART out.part[p] = splat_native(x);
  return out;
}
LINKWORK_INLINE Vector load(const double* from) {
  Vector out;
  LINKWORK_EACH_PART out.part[p] = load_native(from + p * width);
  return out;
}
LINKWORK_INLINE void store(double* to, const Vector& v) { LINKWORK_EACH_PART store_native(to + p * width, v.part[p]); }
LINKWORK_INLINE Vector operator+(const Vector& a, const Vector& b) {
  Vector out;
  LINKWORK_EACH_PART out.part[p] = a.part[p] + b.part[p];
  return out;
}
LINKWORK_INLINE Vector operator-(const Vector& a, const Vector& b) {
  Vector out;
  LINKWORK_EACH_PART out.part[p] = a.part[p] - b.part[p];
  return out;
}
LINKWORK_INLINE Vector operator*(const Vector& a, const Vector& b) {
  Vector out;
  LINKWORK_EACH_PART out.part[p] = a.part[p] * b.part[p];
  return out;
}
LINKWORK_INLINE Vector& operator+=(Vector& a, const Vector& b) { return a = a + b; }
LINKWORK_INLINE Vector& operator-=(Vector& a, const Vector& b) { return a = a - b; }

/// Lane k of v in all lanes.
LINKWORK_INLINE Vector lane(const Vector& v, int k) {
  const Native all = spread_native(v.part[k / width], k % width);
  Vector out;
  LINKWORK_EACH_PART out.part[p] = all;
  return out;
}

/// 1 in lane k, 0 in the others.
LINKWORK_INLINE Vector unit(int k) {
  constexpr double table[15] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
  return load(table + 7 - k);
}

/// `count` lanes from `first` on from memory, zero in the others.
template <int first, int count>
LINKWORK_INLINE Vector load_lanes(const double* from) {
#if LINKWORK_WIDTH == 8
  return {(Native)_mm512_maskz_loadu_pd(((1 << count) - 1) << first, from - first)};
#else
  Vector out = splat(0.0);
  for (int k = 0; k < count; ++k) out.set(first + k, from[k]);
  return out;
#endif
}

/// The first `count` lanes from memory, zero in the others.
template <int count>
LINKWORK_INLINE Vector load_first(const double* from) {
  Vector out = splat(0.0);
  LINKWORK_EACH_PART {
    if ((p + 1) * width <= count) out.part[p] = load_native(from + p * width);
    else if (p * width < count) out.part[p] = load_some<count % width>(from + p * width);
  }
  return out;
}
template <int count>
LINKWORK_INLINE void store_first(double* to, const Vector& v) {
  LINKWORK_EACH_PART {
    if ((p + 1) * width <= count) store_native(to + p * width, v.part[p]);
    else if (p * width < count) store_some<count % width>(to + p * width, v.part[p]);
  }
}

/// Lanes after k, and lanes before k, as factors 1 and 0.
LINKWORK_INLINE Vector lanes_after(int k) {
  constexpr double table[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  return load(table + 7 - k);
}
LINKWORK_INLINE Vector lanes_before(int k) {
  constexpr double table[16] = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  return load(table + 8 - k);
}

/// to[k] += from[k] for k < count.
LINKWORK_INLINE void add(double* to, const double* from, int count) {
  for (; count >= width; count -= width, to += width, from += width)
    store_native(to, load_native(to) + load_native(from));
#if LINKWORK_WIDTH == 8
  const __mmask8 rest = (1 << count) - 1;
  _mm512_mask_storeu_pd(to, rest, _mm512_add_pd(_mm512_maskz_loadu_pd(rest, to), _mm512_maskz_loadu_pd(rest, from)));
#else
  for (int k = 0; k < count; ++k) to[k] += from[k];
#endif
}
LINKWORK_INLINE void copy(double* to, const double* from, int count) {
  for (; count >= width; count -= width, to += width, from += width) store_native(to, load_native(from));
#if LINKWORK_WIDTH == 8
  const __mmask8 rest = (1 << count) - 1;
  _mm512_mask_storeu_pd(to, rest, _mm512_maskz_loadu_pd(rest, from));
#else
  for (int k = 0; k < count; ++k) to[k] = from[k];
#endif
}

/// The first `count` lanes to memory.
LINKWORK_INLINE void store_leading(double* to, Native v, int count) {
#if LINKWORK_WIDTH == 8
  _mm512_mask_storeu_pd(to, (1 << count) - 1, (__m512d)v);
#else
  for (int k = 0; k < count; ++k) to[k] = v[k];
#endif
}

/// Transposes a square of eight vectors.
LINKWORK_INLINE void transpose(Vector* v) {
  LINKWORK_UNROLL for (int p = 0; p < Vector::parts; ++p) LINKWORK_UNROLL
    for (int q = 0; q <= p; ++q) {
      Native a[width], b[width];
      LINKWORK_UNROLL for (int k = 0; k < width; ++k) {
        a[k] = v[p * width + k].part[q];
        b[k] = v[q * width + k].part[p];
      }
      transpose(a);
      transpose(b);
      LINKWORK_UNROLL for (int k = 0; k < width; ++k) {
        v[p * width + k].part[q] = b[k];
        v[q * width + k].part[p] = a[k];
      }
    }
}

/// Reads `count` numbers at each of `width` places: number k of all places into out[k].
template <int count>
LINKWORK_INLINE void gather(const double* const* from, Native* out) {
  constexpr int step = count < width ? count : width;
  LINKWORK_UNROLL for (int c = 0; c < count; c += width) {
    const int first = c + step > count ? count - step : c;  // the last numbers may be read twice
    Native square[width];
    LINKWORK_UNROLL for (int l = 0; l < width; ++l) {
      if constexpr (count < width) square[l] = load_some<step>(from[l] + first);
      else square[l] = load_native(from[l] + first);
    }
    transpose(square);
    LINKWORK_UNROLL for (int k = 0; k < step; ++k)
      out[first + k] = square[k];
  }
}

template <int count>
LINKWORK_INLINE Native total(const Native* v) {
  if constexpr (count == 1) return v[0];
  else return total<count / 2>(v) + total<count / 2>(v + count / 2);
}

/// Lane k of the result is the sum of the lanes of v[k], for the first `count` vectors; zero in the others.
template <int count>
LINKWORK_INLINE Vector sums(const Vector* v) {
  Vector out;
  LINKWORK_EACH_PART {
    Native square[width];
    for (int k = 0; k < width; ++k) {
      square[k] = Native{};
      if (p * width + k >= count) continue;
      for (int q = 0; q < Vector::parts; ++q) square[k] += v[p * width + k].part[q];
    }
    transpose(square);
    out.part[p] = total<width>(square);
  }
  return out;
}

}  // namespace linkwork::simd::LINKWORK_ISA
