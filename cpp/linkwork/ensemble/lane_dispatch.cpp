#include "linkwork/ensemble/lanes.hpp"

namespace linkwork {

extern const LaneKernels lane_kernels_v2;
extern const LaneElimination lane_plain_v2, lane_fused_v2;
#if LINKWORK_X86
extern const LaneKernels lane_kernels_v3, lane_kernels_v4;
extern const LaneElimination lane_plain_v3, lane_plain_v4, lane_fused_v3, lane_fused_v4;
#endif

const LaneKernels& lane_kernels(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return lane_kernels_v4;
  if (instructions.level == 1) return lane_kernels_v3;
#endif
  static_cast<void>(instructions);
  return lane_kernels_v2;
}

const LaneElimination& lane_elimination(const InstructionSet& instructions, bool fused) {
#if LINKWORK_X86
  if (instructions.level == 2) return fused ? lane_fused_v4 : lane_plain_v4;
  if (instructions.level == 1) return fused ? lane_fused_v3 : lane_plain_v3;
#endif
  static_cast<void>(instructions);
  return fused ? lane_fused_v2 : lane_plain_v2;
}

}  // namespace linkwork
