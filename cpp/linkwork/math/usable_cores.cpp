#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "linkwork/math/thread_pool.hpp"

#if defined(__linux__)
#include <sched.h>
#endif

namespace linkwork {
namespace {

int cores_of_affinity() {
#if defined(__linux__)
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
#endif
  return static_cast<int>(std::thread::hardware_concurrency());
}

/// Quota over period, both in us, or 0: "max", -1 or nothing at all.
double share(const std::string& quota, const std::string& period) {
  char* end = nullptr;
  const double q = std::strtod(quota.c_str(), &end), p = std::strtod(period.c_str(), nullptr);
  return end != quota.c_str() && q > 0.0 && p > 0.0 ? q / p : 0.0;
}

std::string first_word(const std::string& file) {
  std::ifstream in(file);
  std::string word;
  in >> word;
  return word;
}

/// Of one group: version 2 says both in one file, version 1 in two.
double share_of_group(const std::string& folder) {
  std::ifstream in(folder + "/cpu.max");
  std::string quota, period;
  if (in >> quota >> period) return share(quota, period);
  return share(first_word(folder + "/cpu.cfs_quota_us"), first_word(folder + "/cpu.cfs_period_us"));
}

/// The least of a group and those above it: inside a container the path may be that of the host, and only the top is
/// there.
double least_share(const std::string& mount, std::string path) {
  double least = 0.0;
  while (true) {
    if (path == "/") path.clear();
    if (const double found = share_of_group(mount + path); found > 0.0 && (least == 0.0 || found < least))
      least = found;
    if (path.empty()) return least;
    path.erase(path.rfind('/'));
  }
}

int wanted_by_environment() {
  const char* const wanted = std::getenv("OMP_NUM_THREADS");
  return wanted ? std::atoi(wanted) : 0;  // "4,2" is 4 on the outer level
}

}  // namespace

int cores_of_quota(const std::string& root) {
  double least = 0.0;
  std::ifstream groups(root + "/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {  // number:controllers:path
    std::istringstream fields(line);
    std::string number, controllers, path;
    if (!std::getline(fields, number, ':') || !std::getline(fields, controllers, ':') || !std::getline(fields, path))
      continue;
    const bool version_1 = ("," + controllers + ",").find(",cpu,") != std::string::npos;
    if (path.empty() || path.front() != '/' || (!controllers.empty() && !version_1)) continue;
    const double found = least_share(root + "/sys/fs/cgroup" + (version_1 ? "/cpu" : ""), path);
    if (found > 0.0 && (least == 0.0 || found < least)) least = found;
  }
  return static_cast<int>(std::ceil(least));
}

int usable_cores() {
  static const int quota = cores_of_quota();  // to read it takes longer than to make a small mechanism
  int cores = cores_of_affinity();
  for (const int limit : {quota, wanted_by_environment()})
    if (limit > 0) cores = std::min(cores, limit);
  return std::max(cores, 1);
}

}  // namespace linkwork
