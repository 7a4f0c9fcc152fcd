#include "linkwork/math/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
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

/// The work at hand is open while parts of it are left; who is inside may take one. Before it is closed and all have
/// left, its caller does not go on.
struct ThreadPool::Crew {
  explicit Crew(int threads) : looks(threads <= usable_cores() ? looks_before_sleep : 0) {
    const WithoutSignals scope;
    try {
      for (int worker = 1; worker < threads; ++worker) crew.emplace_back([this, worker] { serve(worker); });
    } catch (const std::system_error&) {  // no more threads here: fewer do the same
    }
  }

  ~Crew() {
    {
      const std::lock_guard lock(mutex);
      ended = true;
      number.fetch_add(1, std::memory_order_release);
    }
    wake.notify_all();
    for (std::thread& thread : crew) thread.join();
  }

  void serve(int worker) {
    for (unsigned seen = 0;;) {
      for (int k = 0; k < looks && number.load(std::memory_order_acquire) == seen; ++k) pause();
      {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return number.load(std::memory_order_relaxed) != seen; });
        seen = number.load(std::memory_order_relaxed);
        if (ended) return;
        if (!open) continue;
        inside += 1;
      }
      take_parts(worker);
      const std::lock_guard lock(mutex);
      inside -= 1;
      if (inside == 0 && !open) left.notify_one();
    }
  }

  void take_parts(int worker) {
    for (int k; (k = next.fetch_add(1, std::memory_order_relaxed)) < work.count;) try {
        work.call(work.context, k, worker);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error || k < place_of_error) {
          error = std::current_exception();
          place_of_error = k;
        }
        next.store(work.count, std::memory_order_relaxed);
      }
  }

  void run(const Work& given) {
    {
      const std::lock_guard lock(mutex);
      work = given;
      next.store(0, std::memory_order_relaxed);
      open = true;
      number.fetch_add(1, std::memory_order_release);
    }
    wake.notify_all();
    take_parts(0);
    std::unique_lock lock(mutex);
    open = false;
    if (inside > 0) {
      lock.unlock();
      for (int k = 0; k < looks && inside.load(std::memory_order_acquire) > 0; ++k) pause();
      lock.lock();
      left.wait(lock, [&] { return inside == 0; });
    }
    if (std::exception_ptr thrown = std::exchange(error, nullptr)) std::rethrow_exception(thrown);
  }

  const long owner = process();
  const int looks;
  std::atomic<bool> busy{false};
  std::mutex mutex;
  std::condition_variable wake, left;
  std::atomic<unsigned> number{0};  ///< of works so far
  bool open = false, ended = false;
  std::atomic<int> inside{0};  ///< changed under the mutex
  Work work{};
  std::atomic<int> next{0};  ///< part that nobody has taken
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
