#pragma once

#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/state_difference.hpp"

namespace linkwork {

/// An error of velocities in two parts: what forces take back within a few steps, as friction that sticks and stiff
/// dampers do, and what is left of it then.
struct DampedError {
  StateDifference lasting;  ///< with the way that the other part goes meanwhile
  StateDifference fading;   ///< what it comes to, as each step adds to what is left of the ones before
};

/// Of each of ConnectedParts, between states a and b at t, as a step of length h left them. Empty: nothing is taken back
/// so soon. Takes eight evaluations where forces take or give power, else one.
std::vector<DampedError> find_damped_errors(Dynamics& dynamics, double t, double h, const VectorXd& a,
                                            const VectorXd& b);

}  // namespace linkwork
