#pragma once

#include <type_traits>

#include "linkwork/math/instruction_set.hpp"

/// What other compilations define in namespaces of their own, one for each instruction set and, of what evaluates one
/// mechanism, for one and two doubles at a time: declarations in all of these, and addresses by level.
#if LINKWORK_X86
#define LINKWORK_FOR_INSTRUCTION_SETS(...) \
  namespace v2 {                           \
  __VA_ARGS__                              \
  }                                        \
  namespace v3 {                           \
  __VA_ARGS__                              \
  }                                        \
  namespace v4 {                           \
  __VA_ARGS__                              \
  }
#define LINKWORK_FOR_EVALUATIONS(...)        \
  LINKWORK_FOR_INSTRUCTION_SETS(__VA_ARGS__) \
  namespace single {                         \
  __VA_ARGS__                                \
  }                                          \
  namespace pair {                           \
  __VA_ARGS__                                \
  }
#define LINKWORK_BY_INSTRUCTION_SET(NAME) &v2::NAME, &v3::NAME, &v4::NAME
#define LINKWORK_BY_EVALUATION(NAME) LINKWORK_BY_INSTRUCTION_SET(NAME), &single::NAME, &pair::NAME
#else
#define LINKWORK_FOR_INSTRUCTION_SETS(...) \
  namespace v2 {                           \
  __VA_ARGS__                              \
  }
#define LINKWORK_FOR_EVALUATIONS(...) LINKWORK_FOR_INSTRUCTION_SETS(__VA_ARGS__)
#define LINKWORK_BY_INSTRUCTION_SET(NAME) &v2::NAME
#define LINKWORK_BY_EVALUATION(NAME) LINKWORK_BY_INSTRUCTION_SET(NAME)
#endif

/// Defines TYPE NAME(const InstructionSet&), which gives the function of this type and name that evaluates by it.
#define LINKWORK_CHOOSE_BY_INSTRUCTION_SET(TYPE, NAME)        \
  LINKWORK_FOR_EVALUATIONS(std::remove_pointer_t<TYPE> NAME;) \
  TYPE NAME(const InstructionSet& instructions) {             \
    constexpr TYPE all[] = {LINKWORK_BY_EVALUATION(NAME)};    \
    return all[instructions.level];                           \
  }

/// Definitions that only lanes need: evaluations of one or two doubles have none.
#if defined(LINKWORK_WITHOUT_LANES)
#define LINKWORK_OF_LANES(...)
#else
#define LINKWORK_OF_LANES(...) __VA_ARGS__
#endif
