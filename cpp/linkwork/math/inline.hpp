#pragma once

/// For small functions that must not be calls: arguments stay in registers, and what is constant is seen to be.
#define LINKWORK_INLINE inline __attribute__((always_inline))

/// For what joints and force elements are composed of: calls cost more than code. Only where there are few registers the
/// code itself costs as much, as it must find room in the cache beside that of other kinds.
#if defined(__AVX__)
#define LINKWORK_PRIMITIVE LINKWORK_INLINE
#else
#define LINKWORK_PRIMITIVE inline
#endif
