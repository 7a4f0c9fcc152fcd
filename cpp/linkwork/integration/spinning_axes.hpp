#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Axes of rotors, unit vectors fixed in them; zero for all other bodies. Nothing depends on how far a rotor has turned:
/// its inertia is symmetric about the axis of the only joint that holds it, a hinge or a sleeve, and weight is all that
/// acts on it.
Eigen::Matrix3Xd rotor_axes(const System& system);

/// Of the joint of a rotor, at an evaluation, accelerations and all other multipliers being given: the multipliers that
/// move it so, by D^T lambda = M v_dot - g of the rotor alone.
void hold_rotor(const System& system, const Evaluation& at, int rotor, const VectorXd& v_dot, MutableVector lambda);

/// Axes that turn with fast rotors, each at the rate Omega that it has at a start: the motion that is seen from them is
/// as smooth as that of the bodies that hold the rotors, however fast these are. With s = exp(Omega t),
///   p^ = p s^-1,  p^_dot = (p_dot - 1/2 p Omega) s^-1,
///   omega^ = A(s) omega,  omega^_dot = A(s) (omega_dot + Omega x omega);
/// bodies that are no rotors are seen as they are.
struct SpinningAxes {
  MatrixXd Omega;  ///< 3 x bodies [rad/s]

  /// `axes`: see rotor_axes; v: 6 per body.
  static SpinningAxes at_start(const Eigen::Matrix3Xd& axes, const ConstVector& v);

  /// A state (q, v, ...) `time` after the start, and back.
  void see(double time, VectorXd& y) const;
  void carry(double time, VectorXd& y) const;
  /// Its rates, at the state y as it is.
  void see_rates(double time, const VectorXd& y, VectorXd& y_dot) const;
  /// Seen accelerations, 6 per body, as they are at the state y as it is.
  void carry_accelerations(double time, const VectorXd& y, MutableVector v_dot) const;
  /// Forces, 6 per body: torques in body axes.
  void see_forces(double time, MutableVector g) const;
  void carry_forces(double time, MutableVector g) const;
};

}  // namespace linkwork
