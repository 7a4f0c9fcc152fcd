#pragma once

#include <cmath>

#include "linkwork/math/elementary.hpp"
#include "linkwork/math/inline.hpp"
#include "linkwork/model/body_state.hpp"
#include "linkwork/model/rows.hpp"

/// The equations that joints are composed of. Each writes Phi, Phi_t, D and gamma with
///   Phi_dot = D v + Phi_t,    Phi_ddot = D v_dot - gamma,
/// v = (r_dot inertial, omega body-fixed). References: Nikravesh (1988), chapter 7; Flores (2015), chapter 7.
namespace linkwork {

/// omega x (omega x s): the centripetal acceleration of a body-fixed vector, in body axes.
template <class Real>
LINKWORK_PRIMITIVE Vec3<Real> centripetal(const Vec3<Real>& omega, const Vec3<Real>& s) {
  return omega.cross(omega.cross(s));
}

// Phi = r_i + A_i s_i - r_j - A_j s_j = 0: the points coincide (3 equations, inertial axes).
// D_i = [I, -A_i s_i~],   D_j = -[I, -A_j s_j~]
// gamma = A_j w_j x (w_j x s_j) - A_i w_i x (w_i x s_i)
template <class Real>
LINKWORK_PRIMITIVE void coincident(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& s_i,
                                   const Vec3<Real>& s_j, Rows<Real, 3> out) {
  const Vec3<Real> Phi = i.r + i.A * s_i - j.r - j.A * s_j;
  const Vec3<Real> gamma = j.A * centripetal(j.omega, s_j) - i.A * centripetal(i.omega, s_i);
  for (int k = 0; k < 3; ++k) {
    Vec3<Real> unit = Vec3<Real>::Zero();
    unit[k] = Real(1);
    const Vec3<Real> a_i = i.A.row(k), a_j = j.A.row(k);  // -a . (s~ w) = (s x a) . w
    set_row<Real>(out.D_i, k, unit, s_i.cross(a_i));
    set_row<Real>(out.D_j, k, -unit, -s_j.cross(a_j));
    out.Phi[k] = Phi[k];
    out.Phi_t[k] = Real(0);
    out.gamma[k] = gamma[k];
  }
}

/// How j turns against i, in axes of j, where C = A_j^T A_i, w = w_j - C w_i: what directions that stay perpendicular have
/// in common.
// Phi = a . b = 0 with a = C a_i, b = b_j:   Phi_dot = w . d with d = b x a
// D_i = [0, -(C^T d)^T],   D_j = [0, d^T]
// gamma = (C w_i x w_j) . d - (w . a) (w . b) + w^2 Phi
template <class Real>
class RelativeRotation {
 public:
  /// A direction of i.
  struct Direction {
    Vec3<Real> a;
    Real along;  ///< w . a
  };

  LINKWORK_PRIMITIVE RelativeRotation(const BodyState<Real>& i, const BodyState<Real>& j) : C_(j.A.transpose() * i.A) {
    const Vec3<Real> omega_i = C_ * i.omega;
    omega_ = j.omega - omega_i;
    n_ = omega_i.cross(j.omega);
    square_ = omega_.squaredNorm();
  }

  LINKWORK_PRIMITIVE Direction direction(const Vec3<Real>& a_i) const {
    const Vec3<Real> a = C_ * a_i;
    return {a, omega_.dot(a)};
  }
  LINKWORK_PRIMITIVE void perpendicular(const Direction& of_i, const Vec3<Real>& b, Rows<Real, 1> out) const {
    const Vec3<Real> d = b.cross(of_i.a), d_in_i = C_.transpose() * d;
    set_row<Real>(out.D_i, 0, Vec3<Real>::Zero(), -d_in_i);
    set_row<Real>(out.D_j, 0, Vec3<Real>::Zero(), d);
    out.Phi[0] = of_i.a.dot(b);
    out.Phi_t[0] = Real(0);
    out.gamma[0] = n_.dot(d) - of_i.along * omega_.dot(b) + square_ * out.Phi[0];
  }

 private:
  Mat3<Real> C_;
  Vec3<Real> omega_, n_;
  Real square_;
};

// Phi = a . b = 0 with a = A_i a_i, b = A_j b_j: body-fixed directions stay perpendicular.
template <class Real>
LINKWORK_PRIMITIVE void perpendicular(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& a_i,
                                      const Vec3<Real>& b_j, Rows<Real, 1> out) {
  const RelativeRotation<Real> rotation(i, j);
  rotation.perpendicular(rotation.direction(a_i), b_j, out);
}

// a = A_i a_i stays parallel to z of j: perpendicular to its x and y (2 equations).
template <class Real>
LINKWORK_PRIMITIVE void parallel(const RelativeRotation<Real>& rotation, const Vec3<Real>& a_i, const Vec3<Real>& x_j,
                                 const Vec3<Real>& y_j, Rows<Real, 2> out) {
  const auto a = rotation.direction(a_i);
  rotation.perpendicular(a, x_j, out.template slice<0, 1>());
  rotation.perpendicular(a, y_j, out.template slice<1, 1>());
}
template <class Real>
LINKWORK_PRIMITIVE void parallel(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& a_i,
                                 const Vec3<Real>& x_j, const Vec3<Real>& y_j, Rows<Real, 2> out) {
  parallel<Real>(RelativeRotation<Real>(i, j), a_i, x_j, y_j, out);
}

// The axes of i and j stay parallel: x of i is perpendicular to y of j, y to z, z to x (3 equations).
template <class Real>
LINKWORK_PRIMITIVE void same_axes(const BodyState<Real>& i, const BodyState<Real>& j, const Attachment<Real>& at,
                                  Rows<Real, 3> out) {
  const RelativeRotation<Real> rotation(i, j);
  rotation.perpendicular(rotation.direction(at.x_i()), at.y_j(), out.template slice<0, 1>());
  rotation.perpendicular(rotation.direction(at.y_i()), at.z_j(), out.template slice<1, 1>());
  rotation.perpendicular(rotation.direction(at.z_i()), at.x_j(), out.template slice<2, 1>());
}

/// Where the point of j is, in axes of i: u from the origin of i, d = u - s_i from the point of i.
// Phi = a . d = 0 with a = a_i: the point of j stays in a plane of i. With V = A_i^T (r_j_dot + A_j w_j x s_j - r_i_dot)
// D_i = [-(A_i a)^T, (a x u)^T],   D_j = [(A_i a)^T, (s_j x A_j^T A_i a)^T]
// gamma = a . (w_i x (2 V - w_i x u)) - (A_j^T A_i a) . (w_j x (w_j x s_j))
template <class Real>
class RelativePoint {
 public:
  LINKWORK_PRIMITIVE RelativePoint(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& s_i,
                                   const Vec3<Real>& s_j)
      : i_(i), j_(j), s_j_(s_j) {
    const Vec3<Real> across = j.omega.cross(s_j);
    u_ = i.A.transpose() * way_to(i, j, s_j);
    d_ = u_ - s_i;
    const Vec3<Real> V = i.A.transpose() * (j.r_dot + j.A * across - i.r_dot);
    turned_ = i.omega.cross(Real(2) * V - i.omega.cross(u_));
    centripetal_ = j.omega.cross(across);
  }

  LINKWORK_PRIMITIVE void in_plane(const Vec3<Real>& a_i, Rows<Real, 1> out) const {
    const Vec3<Real> a = i_.A * a_i, a_in_j = j_.A.transpose() * a;
    set_row<Real>(out.D_i, 0, -a, a_i.cross(u_));
    set_row<Real>(out.D_j, 0, a, s_j_.cross(a_in_j));
    out.Phi[0] = a_i.dot(d_);
    out.Phi_t[0] = Real(0);
    out.gamma[0] = a_i.dot(turned_) - a_in_j.dot(centripetal_);
  }

 private:
  const BodyState<Real>&i_, &j_;
  const Vec3<Real>& s_j_;
  Vec3<Real> u_, d_, turned_, centripetal_;
};

// Phi = a . d = 0 with a = A_i a_i, d = r_j + A_j s_j - r_i - A_i s_i: the point of j stays in a plane of i.
template <class Real>
LINKWORK_PRIMITIVE void in_plane(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& a_i,
                                 const Vec3<Real>& s_i, const Vec3<Real>& s_j, Rows<Real, 1> out) {
  RelativePoint<Real>(i, j, s_i, s_j).in_plane(a_i, out);
}

// The point of j stays on a line of i, in two planes (2 equations).
template <class Real>
LINKWORK_PRIMITIVE void on_line(const BodyState<Real>& i, const BodyState<Real>& j, const Attachment<Real>& at,
                                Rows<Real, 2> out) {
  const RelativePoint<Real> point(i, j, at.s_i, at.s_j);
  point.in_plane(at.x_i(), out.template slice<0, 1>());
  point.in_plane(at.y_i(), out.template slice<1, 1>());
}

// Phi = |d| - l(t) = 0 with d = r_j + A_j s_j - r_i - A_i s_i, u = d / |d|: two points keep a distance; the
// multiplier is a force [N], which (d.d - l^2)/2 would scale by l.
// D_i = [-u^T, -(s_i x A_i^T u)^T],   D_j = [u^T, (s_j x A_j^T u)^T],   Phi_t = -l_dot
// gamma = l_ddot - (d_dot . d_dot - (u . d_dot)^2) / |d| - u . (A_j w_j x (w_j x s_j) - A_i w_i x (w_i x s_i))
template <class Real>
LINKWORK_PRIMITIVE void separation(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& s_i,
                                   const Vec3<Real>& s_j, const Signal<Real>& length, Rows<Real, 1> out) {
  using std::sqrt;
  const Vec3<Real> d = way_between(i, j, s_i, s_j);
  const Vec3<Real> d_dot = j.r_dot + j.A * j.omega.cross(s_j) - i.r_dot - i.A * i.omega.cross(s_i);
  const Real distance = sqrt(d.squaredNorm());
  const Vec3<Real> u = d / distance;
  const Vec3<Real> u_in_i = i.A.transpose() * u, u_in_j = j.A.transpose() * u;
  const Real along = u.dot(d_dot);
  set_row<Real>(out.D_i, 0, -u, -s_i.cross(u_in_i));
  set_row<Real>(out.D_j, 0, u, s_j.cross(u_in_j));
  out.Phi[0] = distance - length.value;
  out.Phi_t[0] = -length.rate;
  out.gamma[0] = length.acceleration - (d_dot.squaredNorm() - along * along) / distance -
                 u_in_j.dot(centripetal(j.omega, s_j)) + u_in_i.dot(centripetal(i.omega, s_i));
}

/// One equation on its own, to be composed with others.
template <class Real>
struct Equation {
  Real Phi, Phi_t, gamma, D_i[6], D_j[6];

  Rows<Real, 1> rows() { return {&Phi, &Phi_t, &gamma, D_i, D_j}; }
  /// For a primitive with the bodies in the other order.
  Rows<Real, 1> swapped() { return {&Phi, &Phi_t, &gamma, D_j, D_i}; }
  /// D v.
  LINKWORK_PRIMITIVE Real rate(const BodyState<Real>& i, const BodyState<Real>& j) const {  // as Phi_dot of joints
    Real sum(0);
    for (int c = 0; c < 3; ++c) sum += D_i[c] * i.r_dot[c];
    for (int c = 0; c < 3; ++c) sum += D_i[3 + c] * i.omega[c];
    for (int c = 0; c < 3; ++c) sum += D_j[c] * j.r_dot[c];
    for (int c = 0; c < 3; ++c) sum += D_j[3 + c] * j.omega[c];
    return sum;
  }
};

/// out = sum factor_k equation_k
template <class Real, int N>
void combine(const Real (&factors)[N], const Equation<Real> (&equations)[N], Rows<Real, 1> out) {
  const auto sum = [&](auto part) {
    Real total = factors[0] * part(equations[0]);
    for (int k = 1; k < N; ++k) total += factors[k] * part(equations[k]);
    return total;
  };
  out.Phi[0] = sum([](const Equation<Real>& e) { return e.Phi; });
  out.Phi_t[0] = sum([](const Equation<Real>& e) { return e.Phi_t; });
  out.gamma[0] = sum([](const Equation<Real>& e) { return e.gamma; });
  for (int c = 0; c < 6; ++c) {
    out.D_i[c] = sum([c](const Equation<Real>& e) { return e.D_i[c]; });
    out.D_j[c] = sum([c](const Equation<Real>& e) { return e.D_j[c]; });
  }
}

// Phi = atan2(s, c) in (-pi, pi], of two quantities that are no angle's sine and cosine but in proportion to them:
// exact in every pose, whatever c^2 + s^2 is.
// Phi_dot = (c s_dot - s c_dot) / (c^2 + s^2)
// gamma = (c gamma_s - s gamma_c) / (c^2 + s^2) + 2 Phi_dot (c c_dot + s s_dot) / (c^2 + s^2)
template <class Real>
LINKWORK_PRIMITIVE void angle_of(const BodyState<Real>& i, const BodyState<Real>& j, const Equation<Real>& s,
                                 const Equation<Real>& c, Rows<Real, 1> out) {
  using elementary::arc_tangent;
  const Real scale = Real(1) / (c.Phi * c.Phi + s.Phi * s.Phi), by_s = scale * c.Phi, by_c = -scale * s.Phi;
  const Real s_dot = s.rate(i, j), c_dot = c.rate(i, j), rate = by_s * s_dot + by_c * c_dot;
  combine<Real, 2>({by_s, by_c}, {s, c}, out);
  out.Phi[0] = arc_tangent(s.Phi, c.Phi);
  out.gamma[0] += Real(2) * scale * rate * (c.Phi * c_dot + s.Phi * s_dot);
}

/// Of x_j about z_i: proportional to the cosine and the sine of its angle.
template <class Real>
struct Heading {
  Real c, s;
};

// The row of the angle of x_j against x_i about z_i without the angle itself, exact in every pose, whatever c^2 + s^2 is.
// In axes of i, where C = A_i^T A_j, b = C x_j and w = C w_j - w_i:
// c = x_i . b, s = y_i . b, n = (c y_i - s x_i) / (c^2 + s^2), to which b is normal, d = b x n
// Phi_dot = w . d,   D_i = [0, -d^T],   D_j = [0, (C^T d)^T]
// gamma = (w_i x C w_j) . d - (w . n) (w . b) + 2 Phi_dot (c c_dot + s s_dot) / (c^2 + s^2),   b_dot = w x b
template <class Real>
LINKWORK_PRIMITIVE Heading<Real> turning(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& x_i,
                                         const Vec3<Real>& y_i, const Vec3<Real>& x_j, Rows<Real, 1> out) {
  const Vec3<Real> b = i.A.transpose() * (j.A * x_j), omega_j = i.A.transpose() * (j.A * j.omega);
  const Real c = x_i.dot(b), s = y_i.dot(b), scale = Real(1) / (c * c + s * s);
  const Vec3<Real> n = scale * c * y_i - scale * s * x_i, d = b.cross(n), omega = omega_j - i.omega;
  const Vec3<Real> b_dot = omega.cross(b);
  set_row<Real>(out.D_i, 0, Vec3<Real>::Zero(), -d);
  set_row<Real>(out.D_j, 0, Vec3<Real>::Zero(), j.A.transpose() * (i.A * d));
  out.Phi[0] = out.Phi_t[0] = Real(0);
  out.gamma[0] = i.omega.cross(omega_j).dot(d) - omega.dot(n) * omega.dot(b) +
                 Real(2) * scale * omega.dot(d) * (c * x_i.dot(b_dot) + s * y_i.dot(b_dot));
  return {c, s};
}

// Phi = the angle of x_j against x_i about z_i [rad], in (-pi, pi].
template <class Real>
LINKWORK_PRIMITIVE void angle(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& x_i,
                              const Vec3<Real>& y_i, const Vec3<Real>& x_j, Rows<Real, 1> out) {
  using elementary::arc_tangent;
  const Heading<Real> heading = turning<Real>(i, j, x_i, y_i, x_j, out);
  out.Phi[0] = arc_tangent(heading.s, heading.c);
}

// Phi = the angle about z_i of the direction from the point of i to the point of j [rad], in (-pi, pi].
template <class Real>
LINKWORK_PRIMITIVE void bearing(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& x_i,
                                const Vec3<Real>& y_i, const Vec3<Real>& s_i, const Vec3<Real>& s_j,
                                Rows<Real, 1> out) {
  Equation<Real> s, c;
  const RelativePoint<Real> point(i, j, s_i, s_j);
  point.in_plane(y_i, s.rows());
  point.in_plane(x_i, c.rows());
  angle_of<Real>(i, j, s, c, out);
}

/// x modulo the period, nearest to zero: the violation of a constraint on an angle, which is known up to full turns.
template <class Real>
LINKWORK_PRIMITIVE Real wrapped(const Real& x, const Real& period) {
  using std::rint;
  return x - period * rint(x / period);
}

// A velocity constraint that no Phi has (non-holonomic): the material points of i and j at a place C have the same
// velocity along a direction a.
// rho = A^T (C - r) in each body, rho_dot how the place moves in it; a_dot in space.
// D_i = -[a^T, (rho_i x A_i^T a)^T],   D_j = [a^T, (rho_j x A_j^T a)^T],   Phi = Phi_t = 0
// gamma = -a_dot . (u_j - u_i) - a . (c_j - c_i),   u = r_dot + A w x rho,   c = A (w x (w x rho) + w x rho_dot)
template <class Real>
LINKWORK_PRIMITIVE void no_slip(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& a,
                                const Vec3<Real>& a_dot, const Vec3<Real>& rho_i, const Vec3<Real>& rho_i_dot,
                                const Vec3<Real>& rho_j, const Vec3<Real>& rho_j_dot, Rows<Real, 1> out) {
  const Vec3<Real> a_in_i = i.A.transpose() * a, a_in_j = j.A.transpose() * a;
  const Vec3<Real> u_i = i.r_dot + i.A * i.omega.cross(rho_i), u_j = j.r_dot + j.A * j.omega.cross(rho_j);
  set_row<Real>(out.D_i, 0, -a, -rho_i.cross(a_in_i));
  set_row<Real>(out.D_j, 0, a, rho_j.cross(a_in_j));
  out.Phi[0] = out.Phi_t[0] = Real(0);
  out.gamma[0] = -a_dot.dot(u_j - u_i) - a_in_j.dot(centripetal(j.omega, rho_j) + j.omega.cross(rho_j_dot)) +
                 a_in_i.dot(centripetal(i.omega, rho_i) + i.omega.cross(rho_i_dot));
}

}  // namespace linkwork
