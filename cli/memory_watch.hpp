// The limit on the memory of the process.
#pragma once

#include <cstdint>
#include <thread>

namespace pardel::cli {

/// While an object of this class exists, the process ends with end_process() and a `resources` error if it uses more
/// physical memory than the limit. A thread looks at the memory again and again, the more often the less is left. So
/// the limit holds for all of the work: reading, validation, meshing, checking and writing.
class MemoryWatch {
 public:
  /// limit: in bytes; 0: no limit.
  explicit MemoryWatch(std::uint64_t limit);

 private:
  void look_regularly(const std::stop_token& stop) const;

  std::uint64_t limit_;
  std::jthread thread_;
};

}  // namespace pardel::cli
