#pragma once

#include <Eigen/Core>

#include "linkwork/math/elementary.hpp"
#include "linkwork/math/elementary_series.hpp"
#include "linkwork/math/simd.hpp"

/// A number for as many joints or bodies as a register has lanes: the `Real` of templates over the scalar. For files
/// that are compiled once per instruction set; they also rename Eigen's namespace (see CMakeLists.txt).
namespace linkwork::simd::LINKWORK_ISA {

/// What a comparison says of each lane.
struct Mask {
  NativeIndex v;

  friend LINKWORK_INLINE Mask operator|(const Mask& a, const Mask& b) { return {a.v | b.v}; }
  friend LINKWORK_INLINE Mask operator&(const Mask& a, const Mask& b) { return {a.v & b.v}; }
  friend LINKWORK_INLINE Mask operator!(const Mask& a) { return {~a.v}; }
  friend LINKWORK_INLINE bool any(const Mask& a) { return simd::LINKWORK_ISA::any(a.v); }
};

struct Pack {
  Native v;

  Pack() = default;
  LINKWORK_INLINE Pack(double x) : v(splat_native(x)) {}
  LINKWORK_INLINE explicit Pack(Native lanes) : v(lanes) {}

  LINKWORK_INLINE Pack& operator+=(const Pack& b) { return *this = Pack(v + b.v); }
  LINKWORK_INLINE Pack& operator-=(const Pack& b) { return *this = Pack(v - b.v); }
  LINKWORK_INLINE Pack& operator*=(const Pack& b) { return *this = Pack(v * b.v); }
  LINKWORK_INLINE Pack& operator/=(const Pack& b) { return *this = Pack(v / b.v); }
  friend LINKWORK_INLINE Pack operator+(const Pack& a, const Pack& b) { return Pack(a.v + b.v); }
  friend LINKWORK_INLINE Pack operator-(const Pack& a, const Pack& b) { return Pack(a.v - b.v); }
  friend LINKWORK_INLINE Pack operator*(const Pack& a, const Pack& b) { return Pack(a.v * b.v); }
  friend LINKWORK_INLINE Pack operator/(const Pack& a, const Pack& b) { return Pack(a.v / b.v); }
  friend LINKWORK_INLINE Pack operator-(const Pack& a) { return Pack(-a.v); }
  friend LINKWORK_INLINE Mask operator==(const Pack& a, const Pack& b) { return {a.v == b.v}; }
  friend LINKWORK_INLINE Mask operator>(const Pack& a, const Pack& b) { return {a.v > b.v}; }
  friend LINKWORK_INLINE Pack select(const Mask& mask, const Pack& a, const Pack& b) {
    return Pack(mask.v ? a.v : b.v);
  }
  friend LINKWORK_INLINE Pack sqrt(const Pack& a) {
    Pack out;
    for (int k = 0; k < width; ++k) out.v[k] = __builtin_sqrt(a.v[k]);
    return out;
  }
  friend LINKWORK_INLINE Pack rint(const Pack& a) {
    Pack out;
    for (int k = 0; k < width; ++k) out.v[k] = __builtin_rint(a.v[k]);
    return out;
  }
  friend LINKWORK_INLINE Pack abs(const Pack& a) {
    Pack out;
    for (int k = 0; k < width; ++k) out.v[k] = __builtin_fabs(a.v[k]);
    return out;
  }
  friend LINKWORK_INLINE Pack power_of_two(const Pack& k) {  // the sum has the exponent in its last bits
    return Pack((Native)((NativeIndex)(k.v + splat_native(0x1p52 + 1023.0)) << 52));
  }
  template <std::size_t count>
  friend LINKWORK_INLINE elementary::Pair<Pack> entry(const elementary::Pair<double> (&table)[count], const Pack& k) {
    elementary::Pair<Pack> out;
    for (int l = 0; l < width; ++l) {
      const auto& it = table[static_cast<int>(k.v[l])];
      out.hi.v[l] = it.hi;
      out.lo.v[l] = it.lo;
    }
    return out;
  }
  friend LINKWORK_INLINE Pack hyperbolic_tangent(const Pack& x) {
    const Mask unusual = !elementary::usual_for_hyperbolic_tangent(x);
    Pack out = elementary::hyperbolic_tangent_of_usual(select(unusual, Pack(1.0), x));
    if (!any(unusual)) return out;
    for (int l = 0; l < width; ++l)
      if (unusual.v[l]) out.v[l] = elementary::hyperbolic_tangent(x.v[l]);
    return out;
  }
  friend LINKWORK_INLINE Pack arc_tangent(const Pack& y, const Pack& x) {
    const Mask unusual = !elementary::usual_for_arc_tangent(y, x);
    Pack out = elementary::arc_tangent_of_usual(select(unusual, Pack(1.0), y), select(unusual, Pack(1.0), x));
    if (!any(unusual)) return out;
    for (int l = 0; l < width; ++l)
      if (unusual.v[l]) out.v[l] = elementary::arc_tangent(y.v[l], x.v[l]);
    return out;
  }
};

template <int count>
LINKWORK_INLINE void gather(const double* const* from, Pack* out) {
  Native numbers[count];
  gather<count>(from, numbers);
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    out[k].v = numbers[k];
}

/// The way back of gather.
template <int count>
LINKWORK_INLINE void scatter(const Pack* in, double* const* to) {
  constexpr int step = count < width ? count : width;
  LINKWORK_UNROLL for (int c = 0; c < count; c += width) {
    const int first = c + step > count ? count - step : c;
    Native square[width];
    LINKWORK_UNROLL for (int k = 0; k < width; ++k)
      square[k] = k < step ? in[first + k].v : Native{};
    transpose(square);
    LINKWORK_UNROLL for (int l = 0; l < width; ++l) {
      if constexpr (count < width) store_some<step>(to[l] + first, square[l]);
      else store_native(to[l] + first, square[l]);
    }
  }
}

}  // namespace linkwork::simd::LINKWORK_ISA

template <>
struct Eigen::NumTraits<linkwork::simd::LINKWORK_ISA::Pack>
    : Eigen::GenericNumTraits<linkwork::simd::LINKWORK_ISA::Pack> {
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
