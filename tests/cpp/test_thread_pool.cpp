#include "linkwork/math/thread_pool.hpp"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using linkwork::ThreadPool;

namespace {

/// How often each part is done, and that no worker has two at a time.
std::vector<int> times_done(ThreadPool& pool, int count) {
  std::vector<int> out(count, 0);
  std::vector<std::atomic<int>> at_work(pool.threads());
  std::atomic<bool> alone = true;
  pool.run(count, [&](int k, int worker) {
    if (at_work[worker]++ > 0) alone = false;
    out[k] += 1;
    --at_work[worker];
  });
  CHECK(alone);
  return out;
}

struct Failed : std::runtime_error {
  explicit Failed(int part) : std::runtime_error(std::to_string(part)) {}
};

std::string first_failure(ThreadPool& pool, int count, int every) {
  try {
    pool.run(count, [&](int k, int) {
      if (k % every == every - 1) throw Failed(k);
    });
  } catch (const Failed& error) {
    return error.what();
  }
  return "none";
}

/// Neither the sanitizer of races nor an emulator of another processor has them.
bool threads_begin_after_fork() {
#if defined(__SANITIZE_THREAD__)
  return false;
#else
  return std::getenv("EMULATED") == nullptr;
#endif
}

/// In a process that is forked off: what `work` returns.
template <class Work>
int in_child(const Work& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Files as a kernel with control groups shows them.
class Groups {
 public:
  Groups() : root_(std::filesystem::temp_directory_path() / ("linkwork_groups_" + std::to_string(getpid()))) {}
  ~Groups() { std::filesystem::remove_all(root_); }
  void write(const std::string& file, const std::string& text) {
    const std::filesystem::path path = root_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  int cores() const { return linkwork::cores_of_quota(root_.string()); }

 private:
  std::filesystem::path root_;
};

}  // namespace

TEST_CASE("each part is done once, whatever the number of threads, in many works of few parts") {
  for (const int threads : {1, 2, 3, 8}) {
    CAPTURE(threads);
    ThreadPool pool(threads);
    CHECK(pool.threads() == threads);
    for (int round = 0; round < 300; ++round)
      CHECK(times_done(pool, round % 20) == std::vector<int>(static_cast<std::size_t>(round % 20), 1));
  }
}

TEST_CASE("chunks cover what there is, without one part in two of them") {
  for (const int threads : {1, 3}) {
    ThreadPool pool(threads);
    for (const int count : {0, 1, 9, 10, 11, 95}) {
      std::vector<int> done(count, 0);
      pool.in_chunks(count, 10, [&](int first, int last) {
        for (int k = first; k < last; ++k) done[k] += 1;
      });
      CHECK(done == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("of a hundred works that fail each ends with its first failure, and the pool works on") {
  ThreadPool pool(4);
  for (int round = 0; round < 100; ++round) {
    CHECK(first_failure(pool, 64, 3 + round % 7) == std::to_string(2 + round % 7));
    CHECK(first_failure(pool, 64, 100) == "none");
  }
  CHECK(times_done(pool, 64) == std::vector<int>(64, 1));
}

TEST_CASE("a hundred errors, some at a time, on any thread and in any part, end works, and nobody waits for ever") {
  ThreadPool pool(4);
  std::mt19937 random(5);
  std::vector<char> threw(pool.threads(), 0);
  for (int errors = 0; errors < 100;) {
    const int count = 1 + static_cast<int>(random() % 200);
    std::vector<char> fails(count, 0);
    for (int k = static_cast<int>(random() % 4); k-- > 0;) fails[random() % count] = 1;
    const auto first = std::find(fails.begin(), fails.end(), 1) - fails.begin();
    std::atomic<int> done = 0;
    std::string found = "none";
    try {
      pool.run(count, [&](int k, int worker) {
        if (k % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(20));  // so that others have a turn
        if (fails[k]) {
          threw[worker] = 1;
          throw Failed(k);
        }
        ++done;
      });
    } catch (const Failed& error) {
      found = error.what();
      ++errors;
    }
    CHECK(found == (first < count ? std::to_string(first) : "none"));
    if (first == count) CHECK(done == count);
  }
  CHECK(std::count(threw.begin(), threw.end(), 1) > 1);
  CHECK(times_done(pool, 64) == std::vector<int>(64, 1));
}

TEST_CASE("who comes while a pool is at work, or from one of its parts, works alone") {
  ThreadPool pool(3);
  std::atomic<int> inner = 0;
  pool.run(6, [&](int, int) {
    const std::thread::id own = std::this_thread::get_id();
    pool.run(5, [&](int, int worker) { inner += worker == 0 && std::this_thread::get_id() == own ? 1 : 100; });
  });
  CHECK(inner == 30);
}

TEST_CASE("a process that is forked off works alone with a pool from before, and with the threads of its own") {
  ThreadPool before(4), never_used(4);
  times_done(before, 64);
  const auto in_the_child = [](ThreadPool& pool, bool alone) {
    std::atomic<bool> right = true;
    const std::thread::id own = std::this_thread::get_id();
    std::atomic<int> done = 0;
    pool.run(64, [&](int, int) {
      if (alone && std::this_thread::get_id() != own) right = false;
      ++done;
    });
    return right && done == 64;
  };
  CHECK(in_child([&] { return in_the_child(before, true) ? 7 : 1; }) == 7);
  if (threads_begin_after_fork()) {
    CHECK(in_child([&] { return in_the_child(never_used, false) ? 7 : 1; }) == 7);
    CHECK(in_child([&] {
            ThreadPool own(3);
            return in_the_child(own, false) ? 7 : 1;
          }) == 7);
  }
  CHECK(in_child([&] {  // a copy that ends in the child does not wait for threads that are not there
          before.~ThreadPool();
          return 7;
        }) == 7);
  CHECK(times_done(before, 64) == std::vector<int>(64, 1));
}

TEST_CASE("the quotas of control groups count, those above them, too, of both versions") {
  Groups groups;
  CHECK(groups.cores() == 0);
  groups.write("proc/self/cgroup", "0::/user/job\n");
  groups.write("sys/fs/cgroup/user/job/cpu.max", "max 100000\n");
  CHECK(groups.cores() == 0);
  groups.write("sys/fs/cgroup/user/cpu.max", "350000 100000\n");
  CHECK(groups.cores() == 4);  // 3.5
  groups.write("sys/fs/cgroup/user/job/cpu.max", "20000 100000\n");
  CHECK(groups.cores() == 1);
  groups.write("proc/self/cgroup", "12:memory:/a\n3:cpu,cpuacct:/docker/x\n0::/\n");
  groups.write("sys/fs/cgroup/cpu/docker/x/cpu.cfs_quota_us", "-1\n");
  groups.write("sys/fs/cgroup/cpu/docker/x/cpu.cfs_period_us", "100000\n");
  CHECK(groups.cores() == 0);
  groups.write("sys/fs/cgroup/cpu/docker/x/cpu.cfs_quota_us", "200000\n");
  CHECK(groups.cores() == 2);
}

TEST_CASE("OMP_NUM_THREADS is heeded where it is less than there are processors") {
  const char* const given = std::getenv("OMP_NUM_THREADS");
  const std::string before = given ? given : "";
  setenv("OMP_NUM_THREADS", "1,4", 1);
  CHECK(linkwork::usable_cores() == 1);
  setenv("OMP_NUM_THREADS", "100000", 1);
  const int all = linkwork::usable_cores();
  CHECK(all >= 1);
  CHECK(all <= 100000);
  unsetenv("OMP_NUM_THREADS");
  CHECK(linkwork::usable_cores() == all);
  if (given) setenv("OMP_NUM_THREADS", before.c_str(), 1);
}
