#pragma once

#include <optional>
#include <vector>

#include "linkwork/integration/step_sampling.hpp"

namespace linkwork {

/// An error of velocities in two parts: what forces take back within a few steps, as friction that sticks and stiff
/// dampers do, and what is left of it then.
struct DampedError {
  StateDifference lasting;  ///< with the way that the other part goes meanwhile
  StateDifference fading;   ///< what it comes to, as each step adds to what is left of the ones before
};

/// Between states a and b at t, as a step of length h left them. None: nothing is taken back so soon. `part`: of each
/// body, the connected part that it belongs to. Takes eight evaluations where forces take or give power, else one.
std::optional<DampedError> find_damped_error(Dynamics& dynamics, double t, double h, const VectorXd& a,
                                             const VectorXd& b, const std::vector<int>& part);

}  // namespace linkwork
