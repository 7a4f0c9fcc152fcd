// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4, without fused operations.
#include "linkwork/ensemble/lane_solution.hpp"

namespace linkwork {

extern const LaneElimination LINKWORK_NAME(lane_plain_, LINKWORK_ISA);
const LaneElimination LINKWORK_NAME(lane_plain_, LINKWORK_ISA) = {&factor, &forward, &backward};

}  // namespace linkwork
