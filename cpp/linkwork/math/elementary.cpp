#include "linkwork/math/elementary.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "linkwork/math/elementary_series.hpp"

// Of <cmath> only what is exact is used: sqrt, rint, frexp, ldexp, abs, copysign, and the cases that have exact results.
namespace linkwork::elementary {
namespace {

using Number = Pair<double>;

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
  Number rest;
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
  const Number q = product(hi, half_pi[0] + half_pi[1]);
  const Number turned = sum(q.hi, q.lo + hi * 0x1.1a62633145c07p-54 + lo * (half_pi[0] + half_pi[1]));
  const double sign = (over ? -1.0 : 1.0) * (x < 0.0 ? -1.0 : 1.0);
  return {x < 0.0 ? -quadrant & 3 : quadrant & 3, {sign * turned.hi, sign * turned.lo}};
}

Reduced reduce(double x) {
  const double n = std::rint(x * two_over_pi);
  if (!(std::abs(n) < most_multiples)) return reduce_large(x);
  Number rest = sum(x, -n * half_pi[0]);
  for (int k = 1; k < 4; ++k) {
    const Number less = sum(rest.hi, -n * half_pi[k]);
    rest = sum(less.hi, less.lo + rest.lo);
  }
  return {static_cast<int>(n) & 3, rest};
}

/// x - x^3 / 3! + ...
double sine_of(const Number& x) {
  constexpr double c[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                          -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double z = x.hi * x.hi;
  return x.hi + (x.hi * z * polynomial(c, z) + x.lo * (1.0 - 0.5 * z));
}

/// 1 - x^2 / 2 + ...
double cosine_of(const Number& x) {
  constexpr double c[] = {1.0 / 24,        -1.0 / 720,         1.0 / 40320,         -1.0 / 3628800,
                          1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
  const double z = x.hi * x.hi, half = 0.5 * z;
  const Number first = sum(1.0, -half);
  return first.hi + (first.lo + (z * z * polynomial(c, z) - x.hi * x.lo));
}

double sine_from(const Reduced& x, int shift) {
  const int quadrant = (x.quadrant + shift) & 3;
  const double y = quadrant & 1 ? cosine_of(x.rest) : sine_of(x.rest);
  return quadrant & 2 ? -y : y;
}

/// The larger of the two becomes about 1, so that no product of parts is too large or too small.
void scale(double& a, double& b) {
  int exponent;
  std::frexp(std::max(std::abs(a), std::abs(b)), &exponent);
  a = std::ldexp(a, -exponent);
  b = std::ldexp(b, -exponent);
}

// --- exponential and logarithm -----------------------------------------------------------------------------------------

constexpr double largest_exponent = 745.2;  // beyond, an exponential is zero or infinite

double exponential_of(const Number& x) {
  if (!(std::abs(x.hi) < largest_exponent)) return x.hi < 0.0 ? 0.0 : x.hi + std::numeric_limits<double>::infinity();
  const Scaled<double> found = scaled_exponential(x);
  return std::ldexp(found.m, static_cast<int>(found.k));
}

/// Of x > 0: with x = 2^k m and s = (m - 1) / (m + 1) it is k ln 2 + 2 (s + s^3 / 3 + ...), m from sqrt(1/2) to sqrt(2).
Number logarithm_of(double x) {
  constexpr double c[] = {1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13,
                          1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23};
  constexpr Number third = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
  int k;
  double m = std::frexp(x, &k);
  if (m < 0x1.6a09e667f3bcdp-1) m *= 2.0, k -= 1;
  const Number below = sum(m, 1.0);
  const double above = m - 1.0, s = above / below.hi;
  const Number back = product(s, below.hi);
  const double s_lo = (((above - back.hi) - back.lo) - s * below.lo) / below.hi;
  const Number z = product(s, s), cubic = product(z.hi, third.hi);  // of s (1 + z / 3 + ...)
  const double cubic_lo = cubic.lo + z.hi * third.lo + (z.lo + 2.0 * s * s_lo) * third.hi;
  const Number more = product(s, cubic.hi);
  const double more_lo = more.lo + s * (cubic_lo + z.hi * z.hi * polynomial(c, z.hi)) + s_lo * cubic.hi;
  const Number first = sum(k * ln2_hi, 2.0 * s), second = sum(first.hi, k * ln2_lo),
               last = sum(second.hi, 2.0 * more.hi);
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
  if (usual_for_arc_tangent(y, x)) return arc_tangent_of_usual(y, x);
  if (!ordinary(x) || !ordinary(y)) return std::atan2(y, x);  // multiples of pi / 4, and what is no number
  if (x > 0.0 && std::abs(y) < 0x1p-28 * x) return y / x;
  double a = y, b = x;
  scale(a, b);  // which may leave nothing of y but its sign
  return std::copysign(arc_tangent_of_usual(a, b), y);
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
  const Number log = logarithm_of(x);
  if (!(std::abs(y * log.hi) < largest_exponent)) return exponential_of({y * log.hi, 0.0});
  const Number e = product(y, log.hi);
  return exponential_of({e.hi, e.lo + y * log.lo});
}

double hyperbolic_tangent(double x) {
  if (usual_for_hyperbolic_tangent(x)) return hyperbolic_tangent_of_usual(x);
  return x == 0.0 || std::isnan(x) ? x : std::copysign(1.0, x);
}

}  // namespace linkwork::elementary
