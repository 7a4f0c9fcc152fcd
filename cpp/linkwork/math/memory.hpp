#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace linkwork {

/// Gives memory that was freed back to the system: after a large model is set up, glibc would keep what the setting up
/// needed (a tenth of the whole).
inline void return_free_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace linkwork
