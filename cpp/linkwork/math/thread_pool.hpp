#pragma once

#include <algorithm>
#include <memory>
#include <string>

namespace linkwork {

/// Processors that this process may use: its affinity, the quotas of its control groups and OMP_NUM_THREADS, whichever
/// is least; at least 1.
int usable_cores();
/// What the quotas of the control groups of this process come to, rounded up; 0 where there is none. `root`: before
/// /proc and /sys.
int cores_of_quota(const std::string& root = "");

/// Threads that work on the parts of one piece of work. They are made with the first work, sleep when there is none,
/// and take no signals. Which of them does a part is not said: the parts must neither depend on each other nor on that.
///
/// A pool works for one caller at a time; who comes meanwhile, or from one of its parts, works alone. In a process that
/// was forked off, where only the forking thread goes on, a pool from before works alone; one that is made there is
/// like any other.
class ThreadPool {
 public:
  /// So many, the caller's own among them.
  explicit ThreadPool(int threads = 1);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Also `worker`s of `run`: 0 .. threads - 1.
  int threads() const { return threads_; }

  /// Calls part(k, worker) for k = 0 .. count - 1, and returns when all have ended. No two calls at the same time have
  /// the same worker. Where parts throw, none is begun any more, and the exception of the first of them goes through:
  /// the same as if they were done one after the other.
  template <class Part>
  void run(int count, const Part& part) {
    if (count == 1) return part(0, 0);
    run({[](const void* context, int k, int worker) { (*static_cast<const Part*>(context))(k, worker); }, &part,
         count});
  }

  /// Calls part(first, last) for 0 .. count in chunks; with one thread for all of them at once.
  template <class Part>
  void in_chunks(int count, int chunk, const Part& part) {
    if (threads_ == 1 || count <= chunk) return part(0, count);
    run((count - 1) / chunk + 1,
        [&](int k, int) { part(k * chunk, static_cast<int>(std::min<long>(count, (k + 1L) * chunk))); });
  }

 private:
  struct Work {
    void (*call)(const void* context, int k, int worker);
    const void* context;
    int count;
  };
  struct Crew;
  void run(const Work& work);

  int threads_;
  std::unique_ptr<Crew> crew_;
};

}  // namespace linkwork
