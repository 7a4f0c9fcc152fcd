// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/block/kernels.hpp"

#include "linkwork/linear/block/core_kernels.hpp"
#include "linkwork/linear/block/tree_kernels.hpp"

namespace linkwork::block {
namespace {

SmallestPivot factor(const Data& data, const double* a, const double* b) {
  SmallestPivot smallest;
  factor_branches(data, a, b, smallest);
  factor_core(data, a, b, smallest);
  return smallest;
}

/// On open branches a substitution would cost what the factorization does: both wait for the way to the root.
void forward(const Data& data, const double* a, const double* b) {
  SmallestPivot unchanged;
  factor_branches(data, a, b, unchanged);
  forward_core(data, a, b);
}

void backward(const Data& data, const double* a, double* x, double* lambda) {
  backward_core(data, a, x, lambda);
  backward_branches(data, x, lambda);
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(kernels_, ISA)

extern const Kernels LINKWORK_NAME(LINKWORK_ISA);
const Kernels LINKWORK_NAME(LINKWORK_ISA) = {&factor, &forward, &backward};

}  // namespace linkwork::block
