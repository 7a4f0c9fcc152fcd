#pragma once

#include <cmath>
#include <numbers>

#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/primitives.hpp"

/// Coordinates between two bodies along which force elements act, with the equation whose row of D is their direction:
/// a force f along one of them has the generalized force f D^T, and the power f x_dot, in every pose.
namespace linkwork {

/// The distance of two points [m].
struct Length {
  static constexpr const char* placement = "two_points";
  static constexpr int memory = 0;

  template <class Real>
  static Real evaluate(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j, Real*,
                       Equation<Real>& row) {
    separation<Real>(i, j, at.s_i, at.s_j, Signal<Real>{}, row.rows());
    return row.Phi;
  }
};

/// The angle of x_j against x_i about z_i [rad], continued over full turns: the element remembers the last.
struct Angle {
  static constexpr const char* placement = "axis";
  static constexpr int memory = 1;

  template <class Real>
  static Real evaluate(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j, Real* memory,
                       Equation<Real>& row) {
    constexpr double turn = 2.0 * std::numbers::pi;
    angle<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), row.rows());
    memory[0] = row.Phi + turn * std::round((memory[0] - row.Phi) / turn);
    return memory[0];
  }
};

/// The shift of the point of j along z_i [m].
struct Displacement {
  static constexpr const char* placement = "axis";
  static constexpr int memory = 0;

  template <class Real>
  static Real evaluate(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j, Real*,
                       Equation<Real>& row) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, row.rows());
    return row.Phi;
  }
};

/// A force along the coordinate of `row`.
template <class Real>
void act(const Equation<Real>& row, Real force, Wrenches<Real>& out) {
  using Row = Eigen::Map<const Vec3<Real>>;
  out.force_i += force * Row(row.D_i);
  out.torque_i += force * Row(row.D_i + 3);
  out.force_j += force * Row(row.D_j);
  out.torque_j += force * Row(row.D_j + 3);
}

}  // namespace linkwork
