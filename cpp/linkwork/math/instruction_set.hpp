#pragma once

namespace linkwork {

/// An instruction set that the hot loops are compiled for; see simd.hpp. The best that the processor has is chosen at
/// run time, so that one binary is right and fast everywhere.
struct InstructionSet {
  int level;         ///< 0, 1, 2: place in tables of functions
  const char* name;  ///< such as "x86-64-v3"
  int width;         ///< doubles in a register
};

constexpr int max_instruction_sets = 3;

/// How many of them this processor has: levels 0 .. count - 1.
int instruction_set_count();
InstructionSet instruction_set(int level);
/// The widest.
InstructionSet best_instruction_set();
/// The narrowest whose registers hold `count` doubles, or `widest`: half-empty registers cost as much as full ones.
InstructionSet instruction_set_for(int count, const InstructionSet& widest);

}  // namespace linkwork
