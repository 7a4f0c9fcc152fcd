#include "linkwork/math/interruption.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>

namespace linkwork {
namespace {

constexpr std::chrono::nanoseconds interval = std::chrono::milliseconds(50);

std::atomic<Interruption> owner{nullptr};
std::atomic<InterruptionTest> tells{nullptr};
std::atomic<std::int64_t> next{0};

}  // namespace

void set_interruption(Interruption look, InterruptionTest test) {
  owner.store(look, std::memory_order_relaxed);
  tells.store(test, std::memory_order_relaxed);
}

bool is_interruption(const std::exception& thrown) {
  const InterruptionTest test = tells.load(std::memory_order_relaxed);
  return test != nullptr && test(thrown);
}

void look_for_interruption() {
  const Interruption look = owner.load(std::memory_order_relaxed);
  if (look == nullptr) return;
  const std::int64_t now = std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  if (now < next.load(std::memory_order_relaxed)) return;
  next.store(now + interval.count(), std::memory_order_relaxed);
  look();
}

}  // namespace linkwork
