#pragma once

#include <cmath>

#include "linkwork/model/model.hpp"
#include "support.hpp"

/// A rod on a hinge, its states, and what is known of its motion.
namespace support::swinging_rod {

inline constexpr double g = 9.81, arm = 0.5, inertia = 0.1, mass = 2.0;               // m/s^2, m, kg m^2, kg
inline const double pace = std::sqrt(mass * g * arm / (inertia + mass * arm * arm));  // of small swings [rad/s]

/// A rod on a hinge in the origin, along y.
inline Model pendulum(const Vec3<double>& gravity = -g * Vec3<double>::UnitZ()) {
  Model model(gravity);
  Body body;
  body.mass = mass;
  body.inertia = inertia * Mat3<double>::Identity();
  body.position = {0.0, 0.0, -arm};
  model.add_body("rod", body);
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j = {0.0, 0.0, arm};
  at.C_i = at.C_j = Eigen::AngleAxisd(-M_PI / 2.0, Vec3<double>::UnitX()).toRotationMatrix();  // z along y
  model.add_joint("revolute", "pin", ground, 0, at, {});
  return model;
}

/// Its state at an angle from below and a rate.
inline VectorXd state(double angle, double rate) {
  VectorXd y = VectorXd::Zero(14);
  y.segment<3>(0) = Eigen::AngleAxisd(angle, Vec3<double>::UnitY()) * Vec3<double>(0.0, 0.0, -arm);
  y.segment<4>(3) << std::cos(angle / 2.0), 0.0, std::sin(angle / 2.0), 0.0;
  y.segment<3>(7) = (rate * Vec3<double>::UnitY()).cross(Vec3<double>(y.segment<3>(0)));
  y[11] = rate;
  return y;
}

}  // namespace support::swinging_rod
