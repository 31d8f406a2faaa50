#include "memory.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace pardel::cli {
namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// The system's own estimate of what can be had without swapping (proc(5)).
std::uint64_t of_system() {
  std::ifstream file("/proc/meminfo");
  for (std::string name, unit; file >> name;) {
    std::uint64_t kibibytes = 0;
    if (!(file >> kibibytes)) break;
    if (name == "MemAvailable:") return kibibytes * 1024;
    std::getline(file, unit);
  }
  return unknown;
}

/// A number in a file; unknown where there is none ("max" means no limit).
std::uint64_t number_in(const char* name) {
  std::uint64_t value = 0;
  return std::ifstream(name) >> value ? value : unknown;
}

/// Of the group that the process sees as its root: cgroups(7), version 2.
std::uint64_t of_control_group() {
  const std::uint64_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::uint64_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit == unknown || used == unknown) return unknown;
  return limit - std::min(limit, used);
}

std::uint64_t of_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
  return limit.rlim_cur;
}

}  // namespace

std::uint64_t available_memory() {
  const std::uint64_t least = std::min({of_system(), of_control_group(), of_process()});
  return least == unknown ? 0 : least;
}

}  // namespace pardel::cli
