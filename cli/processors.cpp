#include "processors.hpp"

#include <omp.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <string>

namespace pardel::cli {

std::optional<int> processors_granted(std::string_view cpu_max) {
  const char* const end = cpu_max.data() + cpu_max.size();
  std::uint64_t quota = 0, period = 0;  // in microseconds
  const auto [blank, fault] = std::from_chars(cpu_max.data(), end, quota);
  if (fault != std::errc() || blank == end) return std::nullopt;  // "max": no limit
  if (std::from_chars(blank + 1, end, period).ec != std::errc() || period == 0) return std::nullopt;
  const std::uint64_t processors = quota / period + (quota % period > 0 ? 1 : 0);
  constexpr std::uint64_t most = 1U << 20U;
  return static_cast<int>(std::clamp<std::uint64_t>(processors, 1, most));
}

void keep_to_processor_quota() {
  if (std::getenv("OMP_NUM_THREADS") != nullptr) return;
  std::string line;
  if (!std::getline(std::ifstream("/sys/fs/cgroup/cpu.max"), line)) return;
  if (const std::optional<int> granted = processors_granted(line); granted && *granted < omp_get_max_threads())
    omp_set_num_threads(*granted);
}

}  // namespace pardel::cli
