#include "linkwork/ensemble/lane_speeds.hpp"
#include "linkwork/ensemble/lanes.hpp"

namespace linkwork {

extern const LaneKernels lane_kernels_v2;
extern const LaneElimination lane_elimination_v2;
extern const LaneSpeeds lane_speeds_v2;
#if LINKWORK_X86
extern const LaneKernels lane_kernels_v3, lane_kernels_v4;
extern const LaneElimination lane_elimination_v3, lane_elimination_v4;
extern const LaneSpeeds lane_speeds_v3, lane_speeds_v4;
#endif

const LaneKernels& lane_kernels(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return lane_kernels_v4;
  if (instructions.level == 1) return lane_kernels_v3;
#endif
  static_cast<void>(instructions);
  return lane_kernels_v2;
}

const LaneElimination& lane_elimination(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return lane_elimination_v4;
  if (instructions.level == 1) return lane_elimination_v3;
#endif
  static_cast<void>(instructions);
  return lane_elimination_v2;
}

const LaneSpeeds& lane_speeds(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return lane_speeds_v4;
  if (instructions.level == 1) return lane_speeds_v3;
#endif
  static_cast<void>(instructions);
  return lane_speeds_v2;
}

}  // namespace linkwork
