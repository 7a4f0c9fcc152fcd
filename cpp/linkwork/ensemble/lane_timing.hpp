#pragma once

#include <vector>

#include "linkwork/ensemble/lane_pack.hpp"

namespace linkwork {

/// What right-hand sides with reactions cost in the lanes of full packs.
struct LaneTiming {
  int lanes = 0;                ///< of all packs
  double seconds = 0.0;         ///< wall time of one evaluation of all lanes
  std::vector<VectorXd> v_dot;  ///< of each mechanism
};

/// Evaluates mechanisms of one structure `repetitions` times at their initial states, in as many packs as there are
/// `threads`. OptionError: lanes cannot run them, or they do not fill the packs.
LaneTiming time_lanes(const std::vector<Dynamics*>& dynamics, int repetitions, int threads,
                      const InstructionSet& widest);
/// Mechanisms that fill a pack.
int lane_count(const InstructionSet& widest);

}  // namespace linkwork
