// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/block/kernels.hpp"

#include "linkwork/linear/block/core_kernels.hpp"
#include "linkwork/linear/block/tree_kernels.hpp"

namespace linkwork::block {

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(kernels_, ISA)

extern const Kernels LINKWORK_NAME(LINKWORK_ISA);
const Kernels LINKWORK_NAME(LINKWORK_ISA) = {&factor_branches, &factor_core, &forward_core, &backward_core,
                                             &backward_branches};

}  // namespace linkwork::block
