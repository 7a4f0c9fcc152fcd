#pragma once

#include <chrono>

namespace linkwork {

/// Adds the time from its construction to its destruction to a total [s]. It may stand for `count` such times, of which
/// the others were not taken: with 0 it does not look at the clock.
class Stopwatch {
 public:
  explicit Stopwatch(double& total, int count = 1) : total_(total), count_(count) {
    if (count_ > 0) start_ = std::chrono::steady_clock::now();
  }
  ~Stopwatch() {
    if (count_ == 0) return;
    total_ += count_ * std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_;
  int count_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace linkwork
