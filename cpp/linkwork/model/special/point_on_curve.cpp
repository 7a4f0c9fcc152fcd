#include "linkwork/model/special/point_on_curve.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {
namespace {

constexpr int most_iterations = 30;
constexpr int samples = 8;  // of a piece, to find the nearest point from nowhere
constexpr double resolution = 1e-15;

/// A quantity along the curve with its first derivatives by s.
template <class T>
struct Along {
  T value, d, dd;
};
using Scalar = Along<double>;
using Vector = Along<Vec3<double>>;

Scalar dot(const Vector& a, const Vector& b) {
  return {a.value.dot(b.value), a.d.dot(b.value) + a.value.dot(b.d),
          a.dd.dot(b.value) + 2.0 * a.d.dot(b.d) + a.value.dot(b.dd)};
}

Vector operator*(const Scalar& a, const Vector& b) {
  return {a.value * b.value, a.d * b.value + a.value * b.d, a.dd * b.value + 2.0 * a.d * b.d + a.value * b.dd};
}

Vector operator-(const Vector& a, const Vector& b) { return {a.value - b.value, a.d - b.d, a.dd - b.dd}; }

Vector cross(const Vector& a, const Vector& b) {
  return {a.value.cross(b.value), a.d.cross(b.value) + a.value.cross(b.d),
          a.dd.cross(b.value) + 2.0 * a.d.cross(b.d) + a.value.cross(b.dd)};
}

/// a^power
Scalar power(const Scalar& a, double power) {
  const double value = elementary::power(a.value, power), d = power * value / a.value, dd = (power - 1.0) * d / a.value;
  return {value, d * a.d, dd * a.d * a.d + d * a.dd};
}

Vector unit(const Vector& a) { return power(dot(a, a), -0.5) * a; }

/// Value and three derivatives of a cubic piece at x from its knot.
struct Cubic {
  Vec3<double> value, d, dd, ddd;
  Cubic(const std::array<Vec3<double>, 4>& a, double x)
      : value(a[0] + x * (a[1] + x * (a[2] + x * a[3]))),
        d(a[1] + x * (2.0 * a[2] + 3.0 * x * a[3])),
        dd(2.0 * a[2] + 6.0 * x * a[3]),
        ddd(6.0 * a[3]) {}
};

}  // namespace

KindInfo point_on_curve_joint() {
  return {.name = "point_on_curve",
          .rows = 2,
          .placement = "curve",
          .equations = {{"across the curve"}, {"across the curve and its first normal"}},
          .documentation =
              "Point on curve: a point of b stays on a smooth curve through `points` fixed in a, a cubic spline with "
              "the chords' lengths as parameter. A curve that is not closed goes on straight beyond its ends."};
}

/// What the equations need of the curve at s.
struct PointOnCurve::Point {
  Vec3<double> c, c1, c2, c3;  ///< the curve and its derivatives
  Vector n[2];                 ///< unit vectors across it
};

PointOnCurve::PointOnCurve(int i, int j, const Attachment<double>& at, Curve curve)
    : bodies_{i, j}, at_(at), curve_(std::move(curve)) {
  const std::vector<double>& knots = curve_.knots;
  const bool ascending = std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()) == knots.end();
  if (curve_.c.empty() || knots.size() != curve_.c.size() + 1 || curve_.e.size() != curve_.c.size() || !ascending)
    throw ModelError("curve", "point_on_curve: a curve needs pieces between ascending knots");
}

PointOnCurve::Point PointOnCurve::at(double s) const {
  const std::vector<double>& knots = curve_.knots;
  const double length = knots.back() - knots.front();
  if (curve_.closed) s -= length * std::floor((s - knots.front()) / length);
  const double inside = std::clamp(s, knots.front(), knots.back());
  const auto above = std::upper_bound(knots.begin() + 1, knots.end() - 1, inside);
  const auto piece = static_cast<std::size_t>(above - knots.begin()) - 1;
  Cubic c(curve_.c[piece], inside - knots[piece]), e(curve_.e[piece], inside - knots[piece]);
  if (s != inside) {  // straight on
    c = Cubic({c.value, c.d, Vec3<double>::Zero(), Vec3<double>::Zero()}, s - inside);
    e = Cubic({e.value, Vec3<double>::Zero(), Vec3<double>::Zero(), Vec3<double>::Zero()}, 0.0);
  }
  const Vector tangent{c.d, c.dd, c.ddd}, across{e.value, e.d, e.dd};
  Point out{c.value, c.d, c.dd, c.ddd, {}};
  out.n[0] = unit(across - dot(across, tangent) * (power(dot(tangent, tangent), -1.0) * tangent));
  out.n[1] = cross(unit(tangent), out.n[0]);
  return out;
}

/// The parameter of the point of the curve that is nearest to d, from s on, by Newton's method on
/// c' . (d - c) = 0; where the curve bends away (beyond its center of curvature), by steps along the tangent. From
/// what it has found it finds the same again, to the last bit: a last step that is within rounding is not taken.
double PointOnCurve::nearest(const Vec3<double>& d, double s) const {
  const double longest = 0.25 * (curve_.knots.back() - curve_.knots.front());
  for (int k = 0; k < most_iterations; ++k) {
    const Point p = at(s);
    const double squared = p.c1.squaredNorm(), slope = squared - p.c2.dot(d - p.c);
    const double step = p.c1.dot(d - p.c) / std::max(slope, 0.1 * squared);
    if (std::abs(step) <= resolution * std::max(1.0, std::abs(s))) break;
    s += std::clamp(step, -longest, longest);
  }
  return s;
}

double PointOnCurve::nearest_of_all(const Vec3<double>& d) const {
  double found = curve_.knots.front(), least = (at(found).c - d).squaredNorm();
  for (std::size_t piece = 0; piece < curve_.c.size(); ++piece)
    for (int k = 1; k <= samples; ++k) {
      const double s = curve_.knots[piece] + (curve_.knots[piece + 1] - curve_.knots[piece]) * k / samples;
      if (const double distance = (at(s).c - d).squaredNorm(); distance < least) {
        least = distance;
        found = s;
      }
    }
  return found;
}

// G = n(s) . (d - c(s)) = 0 for two vectors n across the curve, d the point of j in the curve's frame, s its foot:
// F = c' . (d - c) = 0.   With F_s = -h = c'' . (d - c) - c' . c':
// s_dot = F_t / h,   s_ddot = (F_tt + 2 F_st s_dot + F_ss s_dot^2) / h
// G_dot = G_t + G_s s_dot,   G_ddot = G_tt + 2 G_st s_dot + G_ss s_dot^2 + G_s s_ddot
// Derivatives by t at fixed s are those of a point of j in a plane of i: see in_plane.
void PointOnCurve::evaluate(const BodyState<double>* bodies, const Signal<double>*, const SpecialHistory& history,
                            const SpecialRows& out) const {
  const BodyState<double>&i = bodies[0], &j = bodies[1];
  const Vec3<double> place = i.A.transpose() * way_to(i, j, at_.s_j) - at_.s_i;
  const Vec3<double> d = at_.C_i.transpose() * place;
  const double s = nearest(d, std::isnan(history.last[0]) ? nearest_of_all(d) : history.last[0]);
  history.next[0] = s;
  history.rate[0] = 0.0;
  const Point p = at(s);
  const Vec3<double> w = d - p.c, foot = at_.s_i + at_.C_i * p.c;
  const auto across = [&](const Vec3<double>& direction) {
    Equation<double> row;
    in_plane<double>(i, j, at_.C_i * direction, foot, at_.s_j, row.rows());
    return row;
  };
  const Equation<double> F = across(p.c1);
  const double h = p.c1.squaredNorm() - p.c2.dot(w), s_dot = F.rate(i, j) / h;
  const double F_st = across(p.c2).rate(i, j), F_ss = p.c3.dot(w) - 3.0 * p.c1.dot(p.c2);
  for (int k = 0; k < 2; ++k) {
    const Vector& n = p.n[k];
    const Equation<double> G = across(n.value);
    const double by_s = (n.d.dot(w) - n.value.dot(p.c1)) / h, G_st = across(n.d).rate(i, j);
    const double G_ss = n.dd.dot(w) - 2.0 * n.d.dot(p.c1) - n.value.dot(p.c2);
    out.Phi[k] = G.Phi;
    out.gamma[k] = G.gamma - 2.0 * G_st * s_dot - G_ss * s_dot * s_dot +
                   by_s * (F.gamma - 2.0 * F_st * s_dot - F_ss * s_dot * s_dot);
    for (int c = 0; c < velocity_size; ++c) {
      out.D[velocity_size * k + c] = G.D_i[c] + by_s * F.D_i[c];
      out.D[velocity_size * (2 + k) + c] = G.D_j[c] + by_s * F.D_j[c];
    }
  }
}

SpecialJointPtr PointOnCurve::seen_from(const Vec3<double>& origin) const {
  auto out = std::make_shared<PointOnCurve>(*this);
  out->at_ = linkwork::seen_from(origin, at_, bodies_[0], bodies_[1]);
  return out;
}

}  // namespace linkwork
