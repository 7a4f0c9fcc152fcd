#include "linkwork/linear/block/kernels.hpp"

namespace linkwork::block {

extern const Kernels kernels_v2;
#if LINKWORK_X86
extern const Kernels kernels_v3, kernels_v4;
#endif

int available_kernels(const Kernels* out[3]) {
  int count = 0;
  out[count++] = &kernels_v2;
#if LINKWORK_X86
  __builtin_cpu_init();
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  if (v3) out[count++] = &kernels_v3;
  if (v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd"))
    out[count++] = &kernels_v4;
#endif
  return count;
}

const Kernels& best_kernels() {
  const Kernels* all[3];
  return *all[available_kernels(all) - 1];
}

}  // namespace linkwork::block
