#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace linkwork {

/// Memory from the start of a cache line on: a register of 8 doubles never lies across two lines, which would take
/// twice the time.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  LineAllocator() = default;
  template <class Other>
  LineAllocator(const LineAllocator<Other>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
  void deallocate(T* place, std::size_t) { ::operator delete(place, line); }
  bool operator==(const LineAllocator&) const { return true; }
};

using AlignedDoubles = std::vector<double, LineAllocator<double>>;

}  // namespace linkwork
