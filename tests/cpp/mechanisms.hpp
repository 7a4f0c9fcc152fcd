#pragma once

#include <string>

#include "support.hpp"

/// Small mechanisms, their joints placed in space.
namespace support {

/// With mass 1 and unit inertia, at rest.
inline Body body_at(const Vec3<double>& position) {
  Body body;
  body.position = position;
  return body;
}

/// A joint at the point P with axes along those of space.
inline int join(Model& model, const std::string& kind, const std::string& name, int i, int j, const Vec3<double>& P) {
  const Mat3<double> I = Mat3<double>::Identity();
  return model.add_joint(kind, name, i, j, place(model, i, j, P, P, I, I));
}

/// Crank, coupler and rocker on hinges about z: 20 equations, of which three are redundant. With all bars along x where
/// `flat`: it can go on in two ways.
inline Model four_bar(bool flat = false) {
  const Vec3<double> A(0, 0, 0), B = flat ? Vec3<double>(1, 0, 0) : Vec3<double>(0, 1, 0),
                                 C = flat ? Vec3<double>(3, 0, 0) : Vec3<double>(2, 1.5, 0), D(2, 0, 0);
  Model model;
  model.add_body("crank", body_at(0.5 * (A + B)));
  model.add_body("coupler", body_at(0.5 * (B + C)));
  model.add_body("rocker", body_at(0.5 * (C + D)));
  join(model, "revolute", "A", ground, 0, A);
  join(model, "revolute", "B", 0, 1, B);
  join(model, "revolute", "C", 1, 2, C);
  join(model, "revolute", "D", ground, 2, D);
  return model;
}

/// Without weight: a ball that comes along x from the origin, one that waits at this place; both of 1 cm.
inline Model two_balls(double speed, const Vec3<double>& waits) {
  Model model(Vec3<double>::Zero());
  Body first;
  first.velocity = {speed, 0, 0};
  model.add_body("first", first);
  model.add_body("second", body_at(waits));
  const Vec3<double> O = Vec3<double>::Zero();
  const Mat3<double> I = Mat3<double>::Identity();
  std::vector<Parameter> parameters;
  for (const ParameterInfo& it : force_kinds()[force_kind_index("sphere_sphere_contact")].info.parameters)
    parameters.push_back({it.name.starts_with("radius") ? 0.01 : it.value.usual.value_or(1e6), -1});
  model.add_force("sphere_sphere_contact", "contact", 0, 1, {O, O, I, I}, parameters);
  return model;
}

/// A row of four-bars with posts and beams of 1 m, on hinges about z: three redundant equations each, one motion of all.
inline Model ladder(int loops) {
  Model model;
  for (int k = 0; k <= loops; ++k) {
    model.add_body("post " + std::to_string(k), body_at({1.0 * k, 0.5, 0.0}));
    join(model, "revolute", "pin " + std::to_string(k), ground, k, {1.0 * k, 0, 0});
  }
  for (int k = 0; k < loops; ++k) {
    const int beam = model.add_body("beam " + std::to_string(k), body_at({k + 0.5, 1.0, 0.0}));
    join(model, "revolute", "left " + std::to_string(k), k, beam, {1.0 * k, 1, 0});
    join(model, "revolute", "right " + std::to_string(k), k + 1, beam, {k + 1.0, 1, 0});
  }
  return model;
}

/// A door of this size on two hinges about z; on the ground the upper one is off by this part of the size. Both hold at
/// first if `placed`, else the door is made for hinges that are not off.
inline Model door(double size, const Vec3<double>& off, bool placed = false) {
  Model model;
  Body body = body_at({0.5 * size, 0, 0.5 * size});
  body.inertia *= size * size;
  model.add_body("door", body);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> high{0, 0, size}, on_ground = high + size * off;
  join(model, "revolute", "low", ground, 0, {0, 0, 0});
  model.add_joint("revolute", "high", ground, 0, place(model, ground, 0, on_ground, placed ? on_ground : high, I, I));
  return model;
}

/// The same with two links that hang on the coupler.
inline Model four_bar_with_tail() {
  Model model = four_bar();
  for (int k = 0; k < 2; ++k) {
    model.add_body("link" + std::to_string(k), body_at({1.0, 1.0 - k, 0.5}));
    join(model, "spherical", "ball" + std::to_string(k), k == 0 ? 1 : 2 + k, 3 + k, {1.0, 1.5 - k, 0.5});
  }
  return model;
}

/// A parallelogram with bars of 1, 2, 1 m on 2 m of ground, turned by theta out of its line, which is singular; its
/// crank turns at `rate`.
inline Model parallelogram(double theta, double rate = 0.0) {
  Model model;
  const Vec3<double> up(std::cos(theta), std::sin(theta), 0), along(2, 0, 0), axis(0, 0, 1);
  const Vec4<double> turned(std::cos(theta / 2), 0, 0, std::sin(theta / 2));
  const auto bar = [&](const char* name, const Vec3<double>& center, double arm, bool turns) {
    Body body = body_at(center);
    if (turns) body.orientation = turned;
    if (turns) body.omega = rate * axis;
    body.velocity = arm * rate * axis.cross(up);
    model.add_body(name, body);
  };
  bar("crank", 0.5 * up, 0.5, true);
  bar("rod", up + 0.5 * along, 1.0, false);
  bar("rocker", along + 0.5 * up, 0.5, true);
  join(model, "revolute", "A", ground, 0, {0, 0, 0});
  join(model, "revolute", "B", 0, 1, up);
  join(model, "revolute", "C", 1, 2, up + along);
  join(model, "revolute", "D", ground, 2, along);
  return model;
}

/// The matrix [M D^T; D -E] of an evaluation, and its solution (x, -lambda) for a right-hand side.
inline MatrixXd dense_kkt(const MatrixXd& M, const MatrixXd& D, const VectorXd& e) {
  MatrixXd K = MatrixXd::Zero(M.rows() + D.rows(), M.rows() + D.rows());
  K << M, D.transpose(), D, -MatrixXd(e.asDiagonal());
  return K;
}

}  // namespace support
