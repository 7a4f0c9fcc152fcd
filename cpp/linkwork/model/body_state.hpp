#pragma once

#include "linkwork/math/elementary_series.hpp"
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

/// A quantity given as a function of time, with its first two derivatives.
template <class Real>
struct Signal {
  Real value, rate, acceleration;
};

}  // namespace linkwork
