#pragma once

#include <type_traits>

#include "linkwork/math/instruction_set.hpp"

/// Defines TYPE NAME(const InstructionSet&), which gives the function of this type and name in the namespace of an
/// instruction set, for which another compilation defines it.
#if LINKWORK_X86
#define LINKWORK_CHOOSE_BY_INSTRUCTION_SET(TYPE, NAME)      \
  namespace v2 {                                            \
  std::remove_pointer_t<TYPE> NAME;                         \
  }                                                         \
  namespace v3 {                                            \
  std::remove_pointer_t<TYPE> NAME;                         \
  }                                                         \
  namespace v4 {                                            \
  std::remove_pointer_t<TYPE> NAME;                         \
  }                                                         \
  TYPE NAME(const InstructionSet& instructions) {           \
    if (instructions.level == 2) return &v4::NAME;          \
    return instructions.level == 1 ? &v3::NAME : &v2::NAME; \
  }
#else
#define LINKWORK_CHOOSE_BY_INSTRUCTION_SET(TYPE, NAME) \
  namespace v2 {                                       \
  std::remove_pointer_t<TYPE> NAME;                    \
  }                                                    \
  TYPE NAME(const InstructionSet&) { return &v2::NAME; }
#endif
