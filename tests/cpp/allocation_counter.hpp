#pragma once

#include <cstdlib>

/// Counts every allocation of the executable that includes this (in one file), those of Eigen and SuiteSparse too:
/// with glibc a malloc defined here takes the place of the library's for all of them.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CAN_COUNT_ALLOCATIONS 1

inline volatile long allocation_count = 0;              // volatile: compilers think that allocating changes no variable
#define COUNTED __attribute__((visibility("default")))  // for the calls of shared libraries, such as those of new

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);

COUNTED void* malloc(std::size_t size) noexcept {
  allocation_count = allocation_count + 1;
  return __libc_malloc(size);
}
COUNTED void* calloc(std::size_t count, std::size_t size) noexcept {
  allocation_count = allocation_count + 1;
  return __libc_calloc(count, size);
}
COUNTED void* realloc(void* memory, std::size_t size) noexcept {
  allocation_count = allocation_count + 1;
  return __libc_realloc(memory, size);
}
}

/// Allocations during a call.
template <class Call>
long allocations(Call call) {
  const long before = allocation_count;
  call();
  return allocation_count - before;
}
#endif
