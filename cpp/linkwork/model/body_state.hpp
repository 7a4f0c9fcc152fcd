#pragma once

#include "linkwork/math/elementary_series.hpp"
#include "linkwork/math/inline.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork {

/// Where a body is and how it moves: what every joint and force reads.
template <class Real>
struct BodyState {
  Vec3<Real> r;      ///< centre of mass [m], inertial
  Mat3<Real> A;      ///< body axes to inertial
  Vec3<Real> r_dot;  ///< [m/s], inertial
  Vec3<Real> omega;  ///< [rad/s], body-fixed

  static BodyState ground() {
    return {Vec3<Real>::Zero(), Mat3<Real>::Identity(), Vec3<Real>::Zero(), Vec3<Real>::Zero()};
  }
};

/// The way from the center of mass of i to the point s_j of j [m], inertial. What arms and directions are made of are such
/// differences, those of centers first: of bodies that are near each other it is exact however far from the origin they
/// are, where the coordinates of a point would be rounded to what is left of digits there.
template <class Real>
LINKWORK_PRIMITIVE Vec3<Real> way_to(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& s_j) {
  return j.r - i.r + j.A * s_j;
}

/// The way from the point s_i of i to the point s_j of j [m], inertial.
template <class Real>
LINKWORK_PRIMITIVE Vec3<Real> way_between(const BodyState<Real>& i, const BodyState<Real>& j, const Vec3<Real>& s_i,
                                          const Vec3<Real>& s_j) {
  return way_to(i, j, s_j) - i.A * s_i;
}

/// Where a joint or force element sits on bodies i and j, in body coordinates.
template <class Real>
struct Attachment {
  Vec3<Real> s_i, s_j;  ///< the point [m]
  Mat3<Real> C_i, C_j;  ///< the axes (x, y, z) of the joint frame as columns; z is the joint axis

  Vec3<Real> x_i() const { return C_i.col(0); }
  Vec3<Real> y_i() const { return C_i.col(1); }
  Vec3<Real> z_i() const { return C_i.col(2); }
  Vec3<Real> x_j() const { return C_j.col(0); }
  Vec3<Real> y_j() const { return C_j.col(1); }
  Vec3<Real> z_j() const { return C_j.col(2); }
};

/// The same where positions are counted from `origin`: what moves is a point on the ground (-1).
inline Attachment<double> seen_from(const Vec3<double>& origin, Attachment<double> at, int i, int j) {
  if (i < 0) at.s_i -= origin;
  if (j < 0) at.s_j -= origin;
  return at;
}

/// A quantity given as a function of time, with its first two derivatives.
template <class Real>
struct Signal {
  Real value, rate, acceleration;
};

}  // namespace linkwork
