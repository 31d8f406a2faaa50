#include "memory.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace pardel::cli {
namespace {

constexpr std::uint64_t unknown = std::numeric_limits<std::uint64_t>::max();

/// The number after the name `wanted` in a file of lines `NAME NUMBER`; `unknown` if the name is missing.
std::uint64_t entry(const char* path, std::string_view wanted) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  for (std::string name, rest; file >> name >> value; std::getline(file, rest))
    if (name == wanted) return value;
  return unknown;
}

/// The number at the start of a file; `unknown` if there is none, for example if the file contains "max" (no limit).
std::uint64_t number_in(const char* path) {
  std::uint64_t value = 0;
  return std::ifstream(path) >> value ? value : unknown;
}

std::uint64_t rest_of(std::uint64_t limit, std::uint64_t used) { return limit - std::min(limit, used); }

/// The kernel's estimate of the memory that is available without swapping: proc(5).
std::uint64_t of_system() {
  const std::uint64_t kibibytes = entry("/proc/meminfo", "MemAvailable:");
  return kibibytes == unknown ? unknown : kibibytes * 1024;
}

/// The memory left in the control group that is the root for this process: cgroups(7), version 2. The used memory
/// includes cached files, although the kernel frees them on demand.
std::uint64_t of_control_group() {
  const std::uint64_t limit = number_in("/sys/fs/cgroup/memory.max");
  const std::uint64_t used = number_in("/sys/fs/cgroup/memory.current");
  if (limit == unknown || used == unknown) return unknown;
  const std::uint64_t files = entry("/sys/fs/cgroup/memory.stat", "inactive_file");
  return rest_of(limit, files == unknown ? used : rest_of(used, files));
}

std::uint64_t bytes_of(std::uint64_t pages) { return pages * static_cast<std::uint64_t>(getpagesize()); }

std::uint64_t of_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
  const std::uint64_t pages = number_in("/proc/self/statm");  // size of the address space
  return pages == unknown ? limit.rlim_cur : rest_of(limit.rlim_cur, bytes_of(pages));
}

}  // namespace

std::uint64_t available_memory(std::uint64_t sharing) {
  const std::uint64_t shared = std::min(of_system(), of_control_group());
  const std::uint64_t least = std::min(shared == unknown ? unknown : shared / sharing, of_process());
  return least == unknown ? 0 : least;
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux gives the value in KiB
}

std::uint64_t used_memory() {
  // Not with a stream: streams allocate memory, and there may be none left.
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 128> text{};
  const ssize_t got = ::read(file, text.data(), text.size());
  ::close(file);
  const char* const end = text.data() + std::max<ssize_t>(got, 0);
  std::uint64_t address_space = 0, resident = 0;  // in pages: proc(5)
  const char* const blank = std::from_chars(text.data(), end, address_space).ptr;
  if (blank == end) return 0;
  std::from_chars(blank + 1, end, resident);
  return bytes_of(resident);
}

std::chrono::microseconds time_to_next_look(std::uint64_t used, std::uint64_t limit) {
  constexpr std::uint64_t most_bytes_per_microsecond = 10'000;
  const auto until_full = static_cast<std::int64_t>((limit - used) / most_bytes_per_microsecond);
  return std::max(std::chrono::microseconds(until_full), std::chrono::microseconds(1000));
}

}  // namespace pardel::cli
