#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "linkwork/math/inline.hpp"

/// What elementary functions are computed by, of one number or of one in each lane of a register (pack.hpp): the same
/// bits. Arguments are reduced to where few terms of a Taylor series are enough, with what roundoff takes away kept in a
/// second number. For files that are compiled without contraction to a b + c in one rounding.
namespace linkwork {

// What laws ask of one number, as of one in each lane.
LINKWORK_INLINE double select(bool condition, double a, double b) { return condition ? a : b; }
LINKWORK_INLINE bool any(bool condition) { return condition; }

namespace elementary {

/// hi + lo, |lo| at most half a unit of hi.
template <class Real>
struct Pair {
  Real hi, lo;
};

/// Entry k, a whole number, of a table.
template <std::size_t count>
LINKWORK_INLINE Pair<double> entry(const Pair<double> (&table)[count], double k) {
  return table[static_cast<int>(k)];
}
/// 2^k of a whole number that is an exponent.
LINKWORK_INLINE double power_of_two(double k) {
  return std::bit_cast<double>(static_cast<std::int64_t>(k + 1023.0) << 52);
}

/// Knuth (1969).
template <class Real>
LINKWORK_INLINE Pair<Real> sum(const Real& a, const Real& b) {
  const Real s = a + b, part = s - a;
  return {s, (a - (s - part)) + (b - part)};
}

/// Dekker (1971); not for numbers beyond 1e290.
template <class Real>
LINKWORK_INLINE Pair<Real> product(const Real& a, const Real& b) {
  const Real split(134217729.0);  // 2^27 + 1
  const Real pa = split * a, pb = split * b;
  const Real a1 = pa - (pa - a), b1 = pb - (pb - b), a2 = a - a1, b2 = b - b1;
  const Real p = a * b;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

template <class Real>
LINKWORK_INLINE Pair<Real> quotient(const Real& a, const Real& b) {
  const Real q = a / b;
  const Pair<Real> p = product<Real>(q, b);
  return {q, ((a - p.hi) - p.lo) / b};
}

/// c[0] + c[1] x + ...
template <int count, class Real>
LINKWORK_INLINE Real polynomial(const double (&c)[count], const Real& x) {
  Real y(c[count - 1]);
  for (int k = count - 2; k >= 0; --k) y = y * x + Real(c[k]);
  return y;
}

// --- arc tangent -------------------------------------------------------------------------------------------------------

/// Of k / 16.
constexpr Pair<double> arc_tangents[] = {{0.0, 0.0},
                                         {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
                                         {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                         {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
                                         {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                         {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
                                         {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                         {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
                                         {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                         {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
                                         {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                         {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
                                         {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                         {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
                                         {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                         {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
                                         {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

constexpr double quarter_turn[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr double half_turn[] = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// Of 0 <= a / b <= 1: with c = k / 16 near a / b it is atan(c) + atan(t), t = (a / b - c) / (1 + c a / b).
template <class Real>
LINKWORK_INLINE Pair<Real> arc_tangent_of(const Real& a, const Real& b) {
  using std::rint;
  constexpr double c[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
  const Pair<Real> q = quotient<Real>(a, b);
  const Real k = rint(Real(16.0) * q.hi), near = Real(1.0 / 16.0) * k;
  const Pair<Real> above = sum<Real>(q.hi - near, q.lo), less = product<Real>(q.hi, near),
                   below = sum<Real>(Real(1.0), less.hi);
  const Real rest = below.lo + less.lo + q.lo * near, ratio = above.hi / below.hi;
  const Pair<Real> back = product<Real>(ratio, below.hi);
  const Real lo = (((above.hi - back.hi) - back.lo) + above.lo - ratio * rest) / below.hi, z = ratio * ratio;
  const Pair<Real> known = entry(arc_tangents, k), found = sum<Real>(known.hi, ratio);
  return sum<Real>(found.hi, found.lo + (known.lo + lo + ratio * z * polynomial(c, z)));
}

/// turn - angle where `so`, else the angle.
template <class Real, class Condition>
LINKWORK_INLINE Pair<Real> less_if(const Condition& so, const double (&turn)[2], const Pair<Real>& angle) {
  const Pair<Real> s = sum<Real>(Real(turn[0]), -angle.hi), rest = sum<Real>(s.hi, s.lo + (Real(turn[1]) - angle.lo));
  return {select(so, rest.hi, angle.hi), select(so, rest.lo, angle.lo)};
}

/// Of numbers that are neither zero nor so large or small that their products were.
template <class Real>
LINKWORK_INLINE Real arc_tangent_of_usual(const Real& y, const Real& x) {
  using std::abs;
  const Real a = abs(y), b = abs(x);
  const auto steep = a > b;
  Pair<Real> angle = arc_tangent_of<Real>(select(steep, b, a), select(steep, a, b));
  angle = less_if<Real>(steep, quarter_turn, angle);
  angle = less_if<Real>(Real(0.0) > x, half_turn, angle);
  return select(Real(0.0) > y, -angle.hi, angle.hi);
}

/// Whether they are those.
template <class Real>
LINKWORK_INLINE auto usual_for_arc_tangent(const Real& y, const Real& x) {
  using std::abs;
  const Real a = abs(y), b = abs(x), least(0x1p-400), most(0x1p400);
  return (a > least) & (most > a) & (b > least) & (most > b) & (a > Real(0x1p-28) * b);
}

// --- exponential -------------------------------------------------------------------------------------------------------

constexpr double ln2_hi = 0x1.62e42feep-1, ln2_lo = 0x1.a39ef35793c76p-33;  // of 32 bits, and the rest

/// exp(r) - 1 - r, |r| <= ln 2 / 2
template <class Real>
LINKWORK_INLINE Real exponential_tail(const Real& r) {
  constexpr double c[] = {1.0 / 2,         1.0 / 6,          1.0 / 24,         1.0 / 120,     1.0 / 720,
                          1.0 / 5040,      1.0 / 40320,      1.0 / 362880,     1.0 / 3628800, 1.0 / 39916800,
                          1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};
  return r * r * polynomial(c, r);
}

/// m 2^k
template <class Real>
struct Scaled {
  Real m, k;
};

template <class Real>
LINKWORK_INLINE Scaled<Real> scaled_exponential(const Pair<Real>& x) {
  using std::rint;
  const Real k = rint(x.hi * Real(0x1.71547652b82fep+0));  // 1 / ln 2
  const Pair<Real> first = sum<Real>(x.hi, -k * Real(ln2_hi)), rest = sum<Real>(first.hi, -k * Real(ln2_lo));
  const Real lo = first.lo + rest.lo + x.lo;
  const Pair<Real> y = sum<Real>(Real(1.0), rest.hi);
  const Real tail = exponential_tail<Real>(rest.hi);
  return {y.hi + (y.lo + (tail + lo * (y.hi + tail))), k};
}

/// Neither zero nor so large that it is one.
template <class Real>
LINKWORK_INLINE auto usual_for_hyperbolic_tangent(const Real& x) {
  using std::abs;
  const Real size = abs(x);
  return (Real(22.0) > size) & (size > Real(0.0));
}

/// Of numbers that are that.
template <class Real>
LINKWORK_INLINE Real hyperbolic_tangent_of_usual(const Real& x) {
  using std::abs;
  const Real twice = Real(2.0) * abs(x);
  const Scaled<Real> whole = scaled_exponential<Real>({twice, Real(0.0)});
  const Real less_one =
      select(Real(0.34) > twice, twice + exponential_tail<Real>(twice), whole.m * power_of_two(whole.k) - Real(1.0));
  const Real found = less_one / (less_one + Real(2.0));
  return select(Real(0.0) > x, -found, found);
}

}  // namespace elementary
}  // namespace linkwork
