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

/// And what evaluates joints, force elements and bodies of one mechanism: these, and x86-64-v4 with one or two doubles
/// at a time, at the levels behind. One joint by itself would leave most of a wide register empty.
constexpr int max_evaluations = 5;

/// How many of them this processor has: levels 0 .. count - 1.
int instruction_set_count();
/// Or an evaluation.
InstructionSet instruction_set(int level);
/// The widest; level 0 where OnePath is; not wider than the environment variable LINKWORK_INSTRUCTION_SET says, by name.
/// OptionError: it says a name that is none.
InstructionSet best_instruction_set();

/// While it is there, this thread computes by the instructions that every processor has, and so with the same bits on
/// all of them: `wanted`, else nothing changes. Several may be there at a time, and go in any order.
class OnePath {
 public:
  explicit OnePath(bool wanted = true);
  ~OnePath();
  OnePath(const OnePath&) = delete;
  OnePath& operator=(const OnePath&) = delete;

 private:
  int count_;
};
/// The narrowest whose registers hold `count` doubles, or `widest`: half-empty registers cost as much as full ones.
InstructionSet instruction_set_for(int count, const InstructionSet& widest);

/// How many evaluations this processor has: levels 0 .. count - 1.
int evaluation_count();
/// As instruction_set_for, for `count` joints, force elements or bodies.
InstructionSet evaluation_for(int count, const InstructionSet& widest);

}  // namespace linkwork
