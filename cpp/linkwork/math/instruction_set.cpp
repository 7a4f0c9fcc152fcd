#include "linkwork/math/instruction_set.hpp"

namespace linkwork {

int instruction_set_count() {
#if LINKWORK_X86
  static const int count = [] {
    __builtin_cpu_init();
    if (!(__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))) return 1;
    const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                    __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd");
    return v4 ? 3 : 2;
  }();
  return count;
#else
  return 1;
#endif
}

InstructionSet instruction_set(int level) {
#if LINKWORK_X86
  constexpr InstructionSet all[max_instruction_sets] = {{0, "x86-64-v2", 2}, {1, "x86-64-v3", 4}, {2, "x86-64-v4", 8}};
  return all[level];
#else
  return {level, "portable", 2};
#endif
}

InstructionSet best_instruction_set() { return instruction_set(instruction_set_count() - 1); }

InstructionSet instruction_set_for(int count, const InstructionSet& widest) {
  for (int level = 0; level < widest.level; ++level)
    if (instruction_set(level).width >= count) return instruction_set(level);
  return widest;
}

}  // namespace linkwork
