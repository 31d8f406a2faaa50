// Counters of this process: the cycles of the processor, where the kernel lets a process count them, and memory.
#pragma once

#include <cstdint>
#include <optional>

namespace pardel::workloads {

/// The cycles that this process and its later threads spend outside of the kernel. Many virtual machines and containers
/// have no such counter.
class CycleCounter {
 public:
  /// Opens the counter. Threads that exist already are not counted.
  CycleCounter();
  CycleCounter(const CycleCounter&) = delete;
  CycleCounter& operator=(const CycleCounter&) = delete;
  ~CycleCounter();
  void start();
  void stop();
  /// The cycles between start() and stop(); empty without a counter.
  [[nodiscard]] std::optional<std::uint64_t> cycles() const;

 private:
  int file_ = -1;
};

/// Makes peak_memory() forget the past. Returns false if the kernel does not let it.
bool reset_peak_memory();
/// The largest resident set since reset_peak_memory(), in bytes; 0 if /proc does not tell.
[[nodiscard]] std::uint64_t peak_memory();
/// The resident set, in bytes; 0 if /proc does not tell.
[[nodiscard]] std::uint64_t resident_memory();

}  // namespace pardel::workloads
