#include "linkwork/linear/block/kernels.hpp"

namespace linkwork::block {

extern const Kernels kernels_v2;
#if LINKWORK_X86
extern const Kernels kernels_v3, kernels_v4;
#endif

const Kernels& kernels(const InstructionSet& instructions) {
#if LINKWORK_X86
  if (instructions.level == 2) return kernels_v4;
  if (instructions.level == 1) return kernels_v3;
#endif
  static_cast<void>(instructions);
  return kernels_v2;
}

}  // namespace linkwork::block
