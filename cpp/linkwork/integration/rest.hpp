#pragma once

#include <optional>
#include <vector>

#include "linkwork/integration/step_parts.hpp"
#include "linkwork/integration/step_sampling.hpp"

namespace linkwork {

/// A connected part whose exact motion is rest, in axes that move with it: what the run moved it is all error, and there
/// is no motion that errors could be weighed by.
struct Rest {
  std::vector<StateDifference> moved;  ///< from there, at the end of each step
  double speed = 0.0;                  ///< by which it would have fallen its own size, or gone as far in the run [m/s]
  double energy = 0.0;                 ///< kinetic, of that [J]
};

/// Of each of ConnectedParts; none: it moves. It rests where it began without a velocity, the run hardly moved it, and no
/// force accelerates it from there, nor does a driver move it, where any of the parts of these steps begins or ends.
/// Takes four evaluations for each while anything may rest. `lengths`: sizes [m].
std::vector<std::optional<Rest>> find_rest(Dynamics& dynamics, const std::vector<const KeptStep*>& steps,
                                           const StepParts& parts, const VectorXd& lengths);

}  // namespace linkwork
