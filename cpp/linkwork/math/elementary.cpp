#include "linkwork/math/elementary.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

// Arguments are reduced to where few terms of a Taylor series are enough, with what roundoff takes away kept in a second
// number. Compiled without contraction to a b + c in one rounding, and of <cmath> only what is exact is used: sqrt, rint,
// frexp, ldexp, abs, copysign, and the cases that have exact results.
namespace linkwork::elementary {
namespace {

/// hi + lo, |lo| at most half a unit of hi.
struct Pair {
  double hi, lo;
};

/// Knuth (1969).
Pair sum(double a, double b) {
  const double s = a + b, part = s - a;
  return {s, (a - (s - part)) + (b - part)};
}

/// Dekker (1971); not for numbers beyond 1e290.
Pair product(double a, double b) {
  constexpr double split = 134217729.0;  // 2^27 + 1
  const double pa = split * a, pb = split * b;
  const double a1 = pa - (pa - a), b1 = pb - (pb - b), a2 = a - a1, b2 = b - b1;
  const double p = a * b;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

Pair quotient(double a, double b) {
  const double q = a / b;
  const Pair p = product(q, b);
  return {q, ((a - p.hi) - p.lo) / b};
}

/// c[0] + c[1] x + ...
template <int count>
double polynomial(const double (&c)[count], double x) {
  double y = c[count - 1];
  for (int k = count - 2; k >= 0; --k) y = y * x + c[k];
  return y;
}

// --- sine and cosine ---------------------------------------------------------------------------------------------------

constexpr double half_pi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
constexpr double most_multiples =
    524288.0;  // whose products with the first three parts of pi / 2, of 33 bits, are exact

/// 2 / pi, the bits after the point.
constexpr std::uint64_t bits_of_two_over_pi[] = {
    0xa2f9836e4e441529u, 0xfc2757d1f534ddc0u, 0xdb6295993c439041u, 0xfe5163abdebbc561u, 0xb7246e3a424dd2e0u,
    0x06492eea09d1921cu, 0xfe1deb1cb129a73eu, 0xe88235f52ebb4484u, 0xe99c7026b45f7e41u, 0x3991d639835339f4u,
    0x9c845f8bbdf9283bu, 0x1ff897ffde05980fu, 0xef2f118b5a0a6d1fu, 0x6d367ecf27cb09b7u, 0x4f463f669e5fea2du,
    0x7527bac7ebe5f17bu, 0x3d0739f78a5292eau, 0x6bfb5fb11f8d5d08u, 0x56033046fc7b6babu, 0xf0cfbc209af4361du};

/// x = quadrant pi / 2 + rest, |rest| <= pi / 4 but for roundoff; the quadrant modulo 4.
struct Reduced {
  int quadrant;
  Pair rest;
};

/// 64 bits of 2 / pi from this one on; those before the first are zero.
std::uint64_t bits_from(int bit) {
  const auto word = [](int k) { return k < 0 ? std::uint64_t{0} : bits_of_two_over_pi[k]; };
  const int first = bit >= 0 ? bit / 64 : -((63 - bit) / 64), shift = bit - 64 * first;
  return shift == 0 ? word(first) : (word(first) << shift) | (word(first + 1) >> (64 - shift));
}

/// Payne and Hanek (1983): of x 2 / pi = m 2^e (2 / pi), m whole, no bits are needed that stand for multiples of 4.
Reduced reduce_large(double x) {
  using Wide = unsigned __int128;
  int exponent;
  const double fraction = std::frexp(std::abs(x), &exponent);
  const auto m = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int first = exponent - 53 - 2;  // its product with m counts 4 and so nothing; the bit after it counts 2
  const std::uint64_t words[3] = {bits_from(first), bits_from(first + 64), bits_from(first + 128)};
  const Wide low = Wide{m} * words[2], middle = Wide{m} * words[1] + static_cast<std::uint64_t>(low >> 64);
  std::uint64_t high = m * words[0] + static_cast<std::uint64_t>(middle >> 64);
  const auto next = static_cast<std::uint64_t>(middle);
  int quadrant = static_cast<int>(high >> 62);
  high &= (std::uint64_t{1} << 62) - 1;  // fractions of a quarter turn: 62 bits here, 64 in the next word
  const bool over = (high >> 61) != 0;
  Wide part = (Wide{high} << 64) | next;  // of 2^126
  if (over) part = (Wide{1} << 126) - part, quadrant += 1;
  const int zeros =
      std::countl_zero(static_cast<std::uint64_t>(part >> 64));  // up to 61, where x is next to a multiple
  part <<= zeros;
  const double hi = std::ldexp(static_cast<double>(static_cast<std::uint64_t>(part >> 75)), -51 - zeros);
  const auto left = static_cast<std::uint64_t>((part & ((Wide{1} << 75) - 1)) >> 22);
  const double lo = std::ldexp(static_cast<double>(left), -104 - zeros);
  const Pair q = product(hi, half_pi[0] + half_pi[1]);
  const Pair turned = sum(q.hi, q.lo + hi * 0x1.1a62633145c07p-54 + lo * (half_pi[0] + half_pi[1]));
  const double sign = (over ? -1.0 : 1.0) * (x < 0.0 ? -1.0 : 1.0);
  return {x < 0.0 ? -quadrant & 3 : quadrant & 3, {sign * turned.hi, sign * turned.lo}};
}

Reduced reduce(double x) {
  const double n = std::rint(x * two_over_pi);
  if (!(std::abs(n) < most_multiples)) return reduce_large(x);
  Pair rest = sum(x, -n * half_pi[0]);
  for (int k = 1; k < 4; ++k) {
    const Pair less = sum(rest.hi, -n * half_pi[k]);
    rest = sum(less.hi, less.lo + rest.lo);
  }
  return {static_cast<int>(n) & 3, rest};
}

/// x - x^3 / 3! + ...
double sine_of(const Pair& x) {
  constexpr double c[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                          -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double z = x.hi * x.hi;
  return x.hi + (x.hi * z * polynomial(c, z) + x.lo * (1.0 - 0.5 * z));
}

/// 1 - x^2 / 2 + ...
double cosine_of(const Pair& x) {
  constexpr double c[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                          1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
  const double z = x.hi * x.hi, half = 0.5 * z;
  const Pair first = sum(1.0, -half);
  return first.hi + (first.lo + (z * z * polynomial(c, z) - x.hi * x.lo));
}

double sine_from(const Reduced& x, int shift) {
  const int quadrant = (x.quadrant + shift) & 3;
  const double y = quadrant & 1 ? cosine_of(x.rest) : sine_of(x.rest);
  return quadrant & 2 ? -y : y;
}

// --- arc tangent -------------------------------------------------------------------------------------------------------

/// Of k / 16.
constexpr Pair arc_tangents[] = {{0.0, 0.0},
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
constexpr Pair quarter_turn = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
constexpr Pair half_turn = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

/// Of 0 <= a / b <= 1: with c = k / 16 near a / b it is atan(c) + atan(t), t = (a / b - c) / (1 + c a / b).
Pair arc_tangent_of(double a, double b) {
  constexpr double c[] = {-1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13};
  const Pair q = quotient(a, b);
  const int k = static_cast<int>(std::rint(16.0 * q.hi));
  Pair t = q;
  if (k > 0) {
    const double near = k / 16.0;
    const Pair above = sum(q.hi - near, q.lo), less = product(q.hi, near), below = sum(1.0, less.hi);
    const double rest = below.lo + less.lo + q.lo * near, ratio = above.hi / below.hi;
    const Pair back = product(ratio, below.hi);
    t = {ratio, (((above.hi - back.hi) - back.lo) + above.lo - ratio * rest) / below.hi};
  }
  const double z = t.hi * t.hi;
  const Pair found = sum(arc_tangents[k].hi, t.hi);
  return sum(found.hi, found.lo + (arc_tangents[k].lo + t.lo + t.hi * z * polynomial(c, z)));
}

Pair less(const Pair& a, const Pair& b) {
  const Pair s = sum(a.hi, -b.hi);
  return sum(s.hi, s.lo + (a.lo - b.lo));
}

/// The larger of the two becomes about 1, so that no product of parts is too large or too small.
void scale(double& a, double& b) {
  int exponent;
  std::frexp(std::max(a, b), &exponent);
  a = std::ldexp(a, -exponent);
  b = std::ldexp(b, -exponent);
}

// --- exponential and logarithm -----------------------------------------------------------------------------------------

constexpr double ln2_hi = 0x1.62e42feep-1, ln2_lo = 0x1.a39ef35793c76p-33;  // of 32 bits, and the rest
constexpr double one_over_ln2 = 0x1.71547652b82fep+0;
constexpr double largest_exponent = 745.2;  // beyond, an exponential is zero or infinite

/// exp(r) - 1 - r, |r| <= ln 2 / 2
double exponential_tail(double r) {
  constexpr double c[] = {1.0 / 2,         1.0 / 6,          1.0 / 24,         1.0 / 120,     1.0 / 720,
                          1.0 / 5040,      1.0 / 40320,      1.0 / 362880,     1.0 / 3628800, 1.0 / 39916800,
                          1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};
  return r * r * polynomial(c, r);
}

double exponential_of(const Pair& x) {
  if (!(std::abs(x.hi) < largest_exponent)) return x.hi < 0.0 ? 0.0 : x.hi + std::numeric_limits<double>::infinity();
  const double k = std::rint(x.hi * one_over_ln2);
  const Pair first = sum(x.hi, -k * ln2_hi), rest = sum(first.hi, -k * ln2_lo);
  const double lo = first.lo + rest.lo + x.lo;
  const Pair y = sum(1.0, rest.hi);
  const double tail = exponential_tail(rest.hi);
  return std::ldexp(y.hi + (y.lo + (tail + lo * (y.hi + tail))), static_cast<int>(k));
}

/// Of x > 0: with x = 2^k m and s = (m - 1) / (m + 1) it is k ln 2 + 2 (s + s^3 / 3 + ...), m from sqrt(1/2) to sqrt(2).
Pair logarithm_of(double x) {
  constexpr double c[] = {1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13,
                          1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23};
  constexpr Pair third = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
  int k;
  double m = std::frexp(x, &k);
  if (m < 0x1.6a09e667f3bcdp-1) m *= 2.0, k -= 1;
  const Pair below = sum(m, 1.0);
  const double above = m - 1.0, s = above / below.hi;
  const Pair back = product(s, below.hi);
  const double s_lo = (((above - back.hi) - back.lo) - s * below.lo) / below.hi;
  const Pair z = product(s, s), cubic = product(z.hi, third.hi);  // of s (1 + z / 3 + ...)
  const double cubic_lo = cubic.lo + z.hi * third.lo + (z.lo + 2.0 * s * s_lo) * third.hi;
  const Pair more = product(s, cubic.hi);
  const double more_lo = more.lo + s * (cubic_lo + z.hi * z.hi * polynomial(c, z.hi)) + s_lo * cubic.hi;
  const Pair first = sum(k * ln2_hi, 2.0 * s), second = sum(first.hi, k * ln2_lo), last = sum(second.hi, 2.0 * more.hi);
  return sum(last.hi, last.lo + second.lo + (first.lo + 2.0 * (s_lo + more_lo)));
}

/// Neither zero nor infinite nor no number.
bool ordinary(double x) { return std::isfinite(x) && x != 0.0; }

}  // namespace

double sine(double x) {
  if (std::abs(x) < 0x1p-27 || !std::isfinite(x)) return std::isfinite(x) ? x : x - x;
  return sine_from(reduce(x), 0);
}

double cosine(double x) { return std::isfinite(x) ? sine_from(reduce(x), 1) : x - x; }

SineAndCosine sine_and_cosine(double x) {
  if (std::abs(x) < 0x1p-27 || !std::isfinite(x)) return {sine(x), cosine(x)};
  const Reduced reduced = reduce(x);
  return {sine_from(reduced, 0), sine_from(reduced, 1)};
}

double arc_tangent(double y, double x) {
  if (!ordinary(x) || !ordinary(y)) return std::atan2(y, x);  // multiples of pi / 4, and what is no number
  double a = std::abs(y), b = std::abs(x);
  if (x > 0.0 && a < 0x1p-28 * b) return y / x;
  scale(a, b);
  const bool steep = a > b;
  Pair angle = steep ? arc_tangent_of(b, a) : arc_tangent_of(a, b);
  if (steep) angle = less(quarter_turn, angle);
  if (x < 0.0) angle = less(half_turn, angle);
  return std::copysign(angle.hi, y);
}

double exponential(double x) { return std::isnan(x) ? x : exponential_of({x, 0.0}); }

double logarithm(double x) { return x > 0.0 && std::isfinite(x) ? logarithm_of(x).hi : std::log(x); }

double power(double x, double y) {
  if (!ordinary(x) || !ordinary(y) || x == 1.0) return std::pow(x, y);  // exact
  if (y == 1.0) return x;
  if (x < 0.0) {
    if (std::rint(y) != y) return std::numeric_limits<double>::quiet_NaN();
    return std::rint(0.5 * y) == 0.5 * y ? power(-x, y) : -power(-x, y);
  }
  const Pair log = logarithm_of(x);
  if (!(std::abs(y * log.hi) < largest_exponent)) return exponential_of({y * log.hi, 0.0});
  const Pair e = product(y, log.hi);
  return exponential_of({e.hi, e.lo + y * log.lo});
}

double hyperbolic_tangent(double x) {
  const double twice = 2.0 * std::abs(x);
  if (!(twice < 44.0)) return std::isnan(x) ? x : std::copysign(1.0, x);
  const double less_one = twice < 0.34 ? twice + exponential_tail(twice) : exponential_of({twice, 0.0}) - 1.0;
  return std::copysign(less_one / (less_one + 2.0), x);
}

}  // namespace linkwork::elementary
