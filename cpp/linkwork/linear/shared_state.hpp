#pragma once

#include <mutex>

namespace linkwork {

/// Held while a library is called that keeps state which all threads of the process share: OpenBLAS without threads of
/// its own hands the same buffers to whoever calls it, and METIS draws from the C library's random numbers. Two
/// factorizations at once gave numbers that were wrong in every digit.
class SharedState {
 public:
  SharedState() : lock_(mutex()) {}

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  std::lock_guard<std::mutex> lock_;
};

}  // namespace linkwork
