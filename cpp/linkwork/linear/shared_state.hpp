#pragma once

#include <mutex>

#if __has_include(<pthread.h>)
#include <pthread.h>
#endif

namespace linkwork {

/// Held while a library is called that keeps state which all threads of the process share, such as BLAS without threads
/// of its own, or METIS, which draws from the C library's random numbers. Two factorizations by SPQR at once gave
/// numbers that were wrong in every digit. A process that is forked meanwhile begins with it free.
class SharedState {
 public:
  SharedState() : lock_(mutex()) {}

 private:
  static std::mutex& mutex() {
    static std::mutex& one = *new std::mutex;  // never destroyed: threads may outlive the end of the program
#if __has_include(<pthread.h>)
    static const int forks = pthread_atfork([] { one.lock(); }, [] { one.unlock(); }, [] { one.unlock(); });
    static_cast<void>(forks);
#endif
    return one;
  }
  std::lock_guard<std::mutex> lock_;
};

}  // namespace linkwork
