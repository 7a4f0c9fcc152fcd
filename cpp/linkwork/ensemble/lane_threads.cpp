#include "linkwork/ensemble/lane_threads.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "linkwork/math/instruction_set.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(20);

/// Ends a task.
struct Stopped {};

/// What the threads share.
struct Work {
  const std::vector<LaneTask>& tasks;
  std::atomic<std::size_t> next{0};
  std::atomic<int> working{0};
  std::atomic<bool> stopped{false};
  std::exception_ptr failure;
  std::mutex access;

  void stop(std::exception_ptr why) {
    const std::lock_guard<std::mutex> lock(access);
    if (!failure) failure = std::move(why);
    stopped = true;
  }

  void run(const std::function<void()>& look) {
    const OnePath path(true);  // whatever is computed lane by lane
    try {
      for (std::size_t task = next++; task < tasks.size(); task = next++) tasks[task](look);
    } catch (const Stopped&) {
    } catch (...) {
      stop(std::current_exception());
    }
    working -= 1;
  }
};

}  // namespace

void run_on_threads(const std::vector<LaneTask>& tasks, int threads) {
  Work work{.tasks = tasks, .next = 0, .working = 0, .stopped = false, .failure = {}, .access = {}};
  if (threads <= 1 || tasks.size() <= 1) {
    work.run([] { look_for_interruption(); });
  } else {
    const auto look = [&] {
      if (work.stopped) throw Stopped();
    };
    std::vector<std::thread> workers;
    const auto count = std::min<std::size_t>(threads, tasks.size());
    work.working = static_cast<int>(count);
    try {
      for (std::size_t k = 0; k < count; ++k) workers.emplace_back([&] { work.run(look); });
    } catch (...) {  // there are no more threads to be had
      work.stop(std::current_exception());
      work.working -= static_cast<int>(count - workers.size());
    }
    while (work.working > 0) {
      std::this_thread::sleep_for(between_looks);
      try {
        look_for_interruption();
      } catch (...) {
        work.stop(std::current_exception());
        break;
      }
    }
    for (std::thread& worker : workers) worker.join();
  }
  if (work.failure) std::rethrow_exception(work.failure);
}

}  // namespace linkwork
