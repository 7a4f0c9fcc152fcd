#pragma once

namespace linkwork {

/// OpenBLAS takes a buffer when it is called first, and where there is no memory for it tries again for ever. This has it
/// taken, once in a process, where there is. While SharedState is held, under which one buffer is enough.
/// std::bad_alloc: there is none.
void reserve_blas_buffer();

}  // namespace linkwork
