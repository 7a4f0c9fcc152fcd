#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkwork {

/// The zero of a continuous function between a and b, f(a) f(b) <= 0, to |error| <= tolerance + 4 eps |zero|: Brent's
/// method, Brent (1973), Algorithms for Minimization without Derivatives, chapter 4. Takes some ten evaluations
/// where the zero is simple and f smooth, and converges in any case. `fa` and `fb` are the values at the ends.
template <class Function>
double brent(Function f, double a, double fa, double b, double fb, double tolerance) {
  double c = a, fc = fa, step = b - a, last = step;
  for (;;) {
    if (std::abs(fc) < std::abs(fb)) {  // b is the best value, c the other end of the bracket, a the value before b
      a = b, fa = fb;
      b = c, fb = fc;
      c = a, fc = fa;
    }
    const double least = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(b) + 0.5 * tolerance;
    const double half = 0.5 * (c - b);
    if (std::abs(half) <= least || fb == 0.0) return b;
    if (std::abs(last) < least || std::abs(fa) <= std::abs(fb)) {
      step = last = half;
    } else {
      const double s = fb / fa;
      double p, q;
      if (a == c) {  // secant
        p = 2.0 * half * s;
        q = 1.0 - s;
      } else {  // inverse quadratic interpolation
        const double u = fa / fc, r = fb / fc;
        p = s * (2.0 * half * u * (u - r) - (b - a) * (r - 1.0));
        q = (u - 1.0) * (r - 1.0) * (s - 1.0);
      }
      if (p > 0.0) q = -q;
      p = std::abs(p);
      const bool interpolate = 2.0 * p < std::min(3.0 * half * q - std::abs(least * q), std::abs(last * q));
      last = interpolate ? step : half;
      step = interpolate ? p / q : half;
    }
    a = b, fa = fb;
    b += std::abs(step) > least ? step : std::copysign(least, half);
    fb = f(b);
    if ((fb > 0.0) == (fc > 0.0)) {
      c = a, fc = fa;
      step = last = b - a;
    }
  }
}

}  // namespace linkwork
