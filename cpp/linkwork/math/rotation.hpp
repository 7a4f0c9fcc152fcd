#pragma once

#include <cmath>

#include "linkwork/math/elementary.hpp"
#include "linkwork/math/inline.hpp"
#include "linkwork/math/types.hpp"

/// Rotations by Euler parameters p = (e0, e1, e2, e3) = (e0, e), scalar first; A(p) turns body axes to inertial.
namespace linkwork {

/// a~ with a~ b = a x b.
template <class Real>
Mat3<Real> skew(const Vec3<Real>& a) {
  Mat3<Real> m;
  m << Real(0), -a[2], a[1], a[2], Real(0), -a[0], -a[1], a[0], Real(0);
  return m;
}

/// A(p) = ((e0^2 - e.e) I + 2 e e^T + 2 e0 e~) / |p|^2.
///
/// Division by |p|^2 makes A a rotation for every p /= 0: the stages of a Runge-Kutta step leave the unit sphere
/// by O(h^2), and A_dot = A omega~ holds there as well. The same bits whatever the scalar: sums are in an order of our own.
template <class Real>
LINKWORK_INLINE Mat3<Real> rotation_matrix(const Vec4<Real>& p) {
  const Real square = (p[0] * p[0] + p[1] * p[1]) + (p[2] * p[2] + p[3] * p[3]);
  const Real scale = Real(2) / square;
  const Real x = p[1] * scale, y = p[2] * scale, z = p[3] * scale;
  const Real wx = p[0] * x, wy = p[0] * y, wz = p[0] * z;
  const Real xx = p[1] * x, xy = p[1] * y, xz = p[1] * z;
  const Real yy = p[2] * y, yz = p[2] * z, zz = p[3] * z;
  Mat3<Real> A;
  A << Real(1) - (yy + zz), xy - wz, xz + wy, xy + wz, Real(1) - (xx + zz), yz - wx, xz - wy, yz + wx,
      Real(1) - (xx + yy);
  return A;
}

/// The product a b: first turn by b, then by a; A(a b) = A(a) A(b).
template <class Real>
Vec4<Real> quaternion_product(const Vec4<Real>& a, const Vec4<Real>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// p_dot = 1/2 p (0, omega), omega body-fixed: the rotational part of q_dot = N(q) v.
template <class Real>
Vec4<Real> euler_parameter_rates(const Vec4<Real>& p, const Vec3<Real>& omega) {
  return Real(0.5) * quaternion_product<Real>(p, Vec4<Real>(Real(0), omega[0], omega[1], omega[2]));
}

/// Angles below which the next term of a series is roundoff: of sin(x / 2) / x after the second, of atan(x) / x after
/// the first.
constexpr double second_order_angle = 1e-4, first_order_angle = 1e-8;

/// Euler parameters of the rotation by |phi| about phi [rad].
inline Vec4<double> exponential(const Vec3<double>& phi) {
  const double angle = phi.norm();
  const auto [sine, cosine] = elementary::sine_and_cosine(0.5 * angle);
  const double factor = angle < second_order_angle ? 0.5 - angle * angle / 48.0 : sine / angle;
  return {cosine, factor * phi[0], factor * phi[1], factor * phi[2]};
}

/// The rotation vector phi [rad], |phi| <= pi, of unit p: the inverse of `exponential` up to the sign of p.
inline Vec3<double> logarithm(const Vec4<double>& p) {
  const Vec3<double> e = p[0] < 0 ? Vec3<double>(-p.tail<3>()) : Vec3<double>(p.tail<3>());
  const double sine = e.norm();
  const double factor = sine < first_order_angle ? 2.0 : 2.0 * elementary::arc_tangent(sine, std::abs(p[0])) / sine;
  return factor * e;
}

/// The rotation vector phi [rad], |phi| <= pi, of a rotation matrix R = exp(phi~).
template <class Real>
Vec3<Real> rotation_vector(const Mat3<Real>& R) {
  using elementary::arc_tangent;
  const Vec3<Real> axial = Vec3<Real>(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)) * Real(0.5);
  const Real sine = axial.norm(), cosine = (R.trace() - Real(1)) * Real(0.5);
  return sine < Real(first_order_angle) ? axial : Vec3<Real>(axial * (arc_tangent(sine, cosine) / sine));
}

}  // namespace linkwork
