#include "linkwork/linear/blas_buffer.hpp"

#include <cstddef>
#include <new>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

// Of whatever BLAS the libraries that we link are linked with; not there without them.
extern "C" __attribute__((weak)) void dtrsm_(const char* side, const char* triangle, const char* transposed,
                                             const char* diagonal, const int* rows, const int* columns,
                                             const double* alpha, const double* A, const int* stride_A, double* B,
                                             const int* stride_B);

namespace linkwork {
namespace {

constexpr std::size_t buffer_bytes = (std::size_t{32} << 22) + (std::size_t{1} << 20);  // BUFFER_SIZE, and some more

void check_room() {
#if __has_include(<sys/mman.h>)
  void* const room = mmap(nullptr, buffer_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  munmap(room, buffer_bytes);
#endif
}

}  // namespace

void reserve_blas_buffer() {
  static bool reserved = false;
  if (reserved) return;
  check_room();
  const int one = 1;
  const double factor = 1.0;
  double x = 1.0;
  if (dtrsm_ != nullptr) dtrsm_("L", "L", "N", "N", &one, &one, &factor, &factor, &one, &x, &one);
  reserved = true;
}

}  // namespace linkwork
