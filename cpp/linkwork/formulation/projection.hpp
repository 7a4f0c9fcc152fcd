#pragma once

#include <cmath>

#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// Whether the iterations of a projection come to rest, from the changes that they make, relative to the size of the
/// mechanism and its distance from the origin, or to its rate.
class ProjectionProgress {
 public:
  enum class State { going_on, converged, diverged };
  State judge(double change);

 private:
  double last_ = INFINITY;
  int iterations_ = 0;
};

/// Takes states back to the constraints with the least change in the metric of the mass matrix,
///   dq = -M^-1 D^T S^+ Phi  by Newton's method,   dv = -M^-1 D^T S^+ (D v + Phi_t),   S = D M^-1 D^T,
/// solved by the formulation as M x - D^T lambda = 0, D x = b. All iterations use the one factorization at the state
/// where `dynamics` was evaluated last; a state that a step has led off the constraints needs two or three.
///
/// The change of the velocities is also what an impact does: joints answer with impulses D^T lambda.
class Projection {
 public:
  explicit Projection(Dynamics& dynamics);

  /// Positions and rotations of y = (q, v, work) at t. NotConvergedError: too far from the constraints.
  void positions(double t, VectorXd& y);
  /// Velocities of y at t, with the positions as they are.
  void velocities(double t, VectorXd& y);

  /// What the stabilization of the run asks for, if anything; evaluates `dynamics` at (t, y) first.
  void stabilize(double t, VectorXd& y);

 private:
  template <class Violation, class Move>
  void iterate(double t, VectorXd& y, double scale, Violation violation, Move move);
  double relative_violation(double scale) const;

  Dynamics& dynamics_;
  Evaluation at_;
  NaturalSize size_;
  VectorXd none_, b_, x_, lambda_;
};

/// What changes of positions are relative to, from a state (q, ...) on.
double projection_reach(const NaturalSize& size, const System& system, const VectorXd& y);

}  // namespace linkwork
