#pragma once

/// For small functions that must not be calls: arguments stay in registers, and what is constant is seen to be.
#define LINKWORK_INLINE inline __attribute__((always_inline))
