#include "linkwork/math/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#if __has_include(<unistd.h>)
#include <pthread.h>
#include <signal.h>
#include <unistd.h>
#endif

namespace linkwork {
namespace {

constexpr int looks_before_sleep = 2000;  // for the next work: some 30 us

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

long process() {
#if __has_include(<unistd.h>)
  return getpid();
#else
  return 0;
#endif
}

/// As condition.wait(lock, met), which since GCC 12 asks for that version's library: wheels run with older ones.
template <class Met>
void sleep_until(std::condition_variable& condition, std::unique_lock<std::mutex>& lock, Met met) {
  while (!condition.wait_for(lock, std::chrono::hours(1), met)) continue;
}

/// Signals are for the threads that were there before.
class WithoutSignals {
 public:
#if __has_include(<unistd.h>)
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
#endif
};

}  // namespace

/// How many parts of the work at hand are left to be taken stands in one number with the number of that work: who takes
/// a part knows that the work is still the one he saw, and its caller goes on as soon as all parts that were taken are
/// done, whoever else has not even looked yet.
struct ThreadPool::Crew {
  explicit Crew(int threads) : looks(threads <= usable_cores() ? looks_before_sleep : 0) {
    const WithoutSignals scope;
    crew.reserve(static_cast<std::size_t>(threads));  // or nobody would join those that are there
    try {
      for (int worker = 1; worker < threads; ++worker) crew.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error&) {  // no more threads here: fewer do the same
    }
  }

  ~Crew() {
    {
      const std::lock_guard lock(mutex);
      ended = true;
    }
    wake.notify_all();
    for (std::thread& thread : crew) thread.join();
  }

  bool parts_left() const { return (ticket.load(std::memory_order_acquire) & parts_mask) != 0; }

  void serve(int worker) {
    while (true) {
      for (int k = 0; k < looks && !parts_left(); ++k) pause();
      if (!parts_left()) {
        std::unique_lock lock(mutex);
        sleep_until(wake, lock, [&] { return ended || parts_left(); });
        if (ended) return;
      }
      take_parts(worker);
    }
  }

  void take_parts(int worker) {
    std::uint64_t seen = ticket.load(std::memory_order_acquire);
    while ((seen & parts_mask) != 0) {
      if (!ticket.compare_exchange_weak(seen, seen - 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
      const int k = work.count - static_cast<int>(seen & parts_mask);
      try {
        work.call(work.context, k, worker);
      } catch (...) {
        keep_error(k);
        finish(leave_out_rest());
      }
      finish(1);
      seen = ticket.load(std::memory_order_acquire);
    }
  }

  void keep_error(int k) {
    const std::lock_guard lock(mutex);
    if (error && k > place_of_error) return;
    error = std::current_exception();
    place_of_error = k;
  }

  /// How many parts nobody has taken, nor will.
  int leave_out_rest() {
    std::uint64_t seen = ticket.load(std::memory_order_acquire);
    while (!ticket.compare_exchange_weak(seen, seen & ~parts_mask, std::memory_order_acq_rel)) continue;
    return static_cast<int>(seen & parts_mask);
  }

  /// The caller may go on with the last of them: nothing of the work is read after this.
  void finish(int parts) {
    if (parts == 0 || unfinished.fetch_sub(parts, std::memory_order_acq_rel) != parts) return;
    const std::lock_guard lock(mutex);
    done.notify_one();
  }

  void run(const Work& given) {
    work = given;
    unfinished.store(given.count, std::memory_order_relaxed);
    {
      const std::lock_guard lock(mutex);
      number += 1;
      ticket.store((number << 32) | static_cast<std::uint64_t>(given.count), std::memory_order_release);
    }
    wake.notify_all();
    take_parts(0);
    for (int k = 0; k < looks && unfinished.load(std::memory_order_acquire) > 0; ++k) pause();
    std::unique_lock lock(mutex);
    sleep_until(done, lock, [&] { return unfinished.load(std::memory_order_acquire) == 0; });
    if (const std::exception_ptr thrown = std::exchange(error, nullptr)) std::rethrow_exception(thrown);
  }

  static constexpr std::uint64_t parts_mask = 0xffffffff;

  const long owner = process();
  const int looks;
  std::atomic<bool> busy{false};
  std::mutex mutex;
  std::condition_variable wake, done;
  bool ended = false;
  Work work{};
  std::uint64_t number = 0;  ///< of the work at hand
  std::atomic<std::uint64_t> ticket{0};
  std::atomic<int> unfinished{0};
  std::exception_ptr error;
  int place_of_error = 0;
  std::vector<std::thread> crew;  ///< last: it uses all of the above
};

ThreadPool::ThreadPool(int threads) : threads_(std::max(threads, 1)) {}

ThreadPool::~ThreadPool() {
  if (crew_ && crew_->owner != process()) static_cast<void>(crew_.release());  // nobody is there to be joined
}

void ThreadPool::run(const Work& work) {
  if (threads_ > 1 && work.count > 1) {
    if (!crew_) crew_ = std::make_unique<Crew>(threads_);
    if (crew_->owner == process() && !crew_->busy.exchange(true, std::memory_order_acquire)) {
      struct Free {
        std::atomic<bool>& busy;
        ~Free() { busy.store(false, std::memory_order_release); }
      } const free{crew_->busy};
      return crew_->run(work);
    }
  }
  for (int k = 0; k < work.count; ++k) work.call(work.context, k, 0);
}

}  // namespace linkwork
