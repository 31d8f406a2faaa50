#include "counters.hpp"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <string_view>

namespace pardel::workloads {
namespace {

/// A line of /proc/self/status in bytes; 0 if it is missing.
std::uint64_t status(std::string_view key) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return std::stoull(line.substr(key.size() + 1)) * 1024;
  return 0;
}

}  // namespace

CycleCounter::CycleCounter() {
  perf_event_attr attributes{};
  attributes.size = sizeof attributes;
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = PERF_COUNT_HW_CPU_CYCLES;
  attributes.disabled = 1;
  attributes.inherit = 1;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  file_ = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
}
CycleCounter::~CycleCounter() {
  if (file_ >= 0) close(file_);
}
void CycleCounter::start() {
  if (file_ >= 0) ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
}
void CycleCounter::stop() {
  if (file_ >= 0) ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
}
std::optional<std::uint64_t> CycleCounter::cycles() const {
  std::uint64_t count = 0;
  if (file_ < 0 || read(file_, &count, sizeof count) != static_cast<ssize_t>(sizeof count)) return std::nullopt;
  return count;
}

bool reset_peak_memory() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5";
  file.close();
  return !file.fail();
}
std::uint64_t peak_memory() { return status("VmHWM:"); }
std::uint64_t resident_memory() { return status("VmRSS:"); }

}  // namespace pardel::workloads
