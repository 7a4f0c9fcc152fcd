#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Between two states, of a body, or the largest of several.
struct StateDifference {
  double position = 0.0, rotation = 0.0, velocity = 0.0, omega = 0.0;  ///< m, rad, m/s, rad/s

  /// By which a turned from b, of Euler parameters of both, in body axes, where it is small [rad].
  static Vec3<double> turn(const Vec4<double>& a, const Vec4<double>& b);
  /// Between y = (q, v, ...) of both.
  static StateDifference of_body(const System& system, int body, const VectorXd& a, const VectorXd& b);
  void raise(const StateDifference& other);
  void lower(const StateDifference& by);  ///< not below zero
  void scale(double factor);
};

/// Of each of ConnectedParts.
using DifferencesOfParts = std::vector<StateDifference>;

DifferencesOfParts differences(const System& system, const VectorXd& a, const VectorXd& b);

}  // namespace linkwork
