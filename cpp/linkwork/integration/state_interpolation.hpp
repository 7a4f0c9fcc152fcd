#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// A state of a run and its accelerations.
struct MovingState {
  double t = 0.0;     ///< [s]
  VectorXd y, v_dot;  ///< y = (q, v, work), and what v changes by
};

/// Between two states, h apart, at this share of the way: cubic in positions and Euler parameters, as velocities at both
/// ends have it. Euler parameters are to have the same sign at both.
VectorXd cubic_between(const System& system, const VectorXd& begin, const VectorXd& end, double h, double share);

/// Of the fifth degree, as accelerations have it, too.
VectorXd quintic_between(const System& system, const MovingState& begin, const MovingState& end, double share);

}  // namespace linkwork
