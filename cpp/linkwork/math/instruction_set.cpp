#include "linkwork/math/instruction_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

thread_local int one_paths = 0;

/// Those that this program is compiled for, whatever the processor has.
#if LINKWORK_X86
constexpr int named_sets = max_instruction_sets;
constexpr InstructionSet all[max_evaluations] = {
    {0, "x86-64-v2", 2}, {1, "x86-64-v3", 4}, {2, "x86-64-v4", 8}, {3, "x86-64-v4", 1}, {4, "x86-64-v4", 2}};
#else
constexpr int named_sets = 1;
constexpr InstructionSet all[] = {{0, "portable", 2}};
#endif

/// OptionError: there is no set of this name.
int level_named(std::string_view wanted) {
  std::string names;
  for (int k = 0; k < named_sets; ++k) {
    if (wanted == instruction_set(k).name) return k;
    names += (k ? ", " : "") + std::string(instruction_set(k).name);
  }
  throw OptionError("instruction_set", "environment variable LINKWORK_INSTRUCTION_SET: '" + std::string(wanted) +
                                           "' is none of " + names + "; give one of them, or unset it");
}

int allowed_level() {
  static const int level = [] {
    const int widest = instruction_set_count() - 1;
    const char* const wanted = std::getenv("LINKWORK_INSTRUCTION_SET");
    return wanted && *wanted ? std::min(widest, level_named(wanted)) : widest;
  }();
  return level;
}

}  // namespace

OnePath::OnePath(bool wanted) : count_(wanted ? 1 : 0) { one_paths += count_; }
OnePath::~OnePath() { one_paths -= count_; }

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

InstructionSet instruction_set(int level) { return all[level]; }

InstructionSet best_instruction_set() { return instruction_set(one_paths > 0 ? 0 : allowed_level()); }

InstructionSet instruction_set_for(int count, const InstructionSet& widest) {
  for (int level = 0; level < widest.level; ++level)
    if (instruction_set(level).width >= count) return instruction_set(level);
  return widest;
}

int evaluation_count() {
  const int count = instruction_set_count();
  return count == max_instruction_sets ? max_evaluations : count;
}

InstructionSet evaluation_for(int count, const InstructionSet& widest) {
  if (widest.level < max_instruction_sets - 1 || count > 2) return instruction_set_for(count, widest);
  return instruction_set(max_instruction_sets + (count == 2 ? 1 : 0));
}

}  // namespace linkwork
