#include "linkwork/integration/run.hpp"

#include <chrono>

namespace linkwork {

Frames Run::advance(std::int64_t max_frames, double max_seconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  while (!finished_ && static_cast<std::int64_t>(recorder_.count()) < max_frames) {
    work();
    if (std::chrono::duration<double>(Clock::now() - start).count() > max_seconds) break;
  }
  return take_frames();
}

}  // namespace linkwork
