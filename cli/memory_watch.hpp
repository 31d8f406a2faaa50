// The limit on the memory of the process.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace pardel::cli {

/// While an object of this class exists, the process ends with end_process() and a `resources` error if it uses more
/// physical memory than the limit. A thread looks at the memory again and again, the more often the less is left. So
/// the limit holds for all of the work: reading, validation, meshing, checking and writing.
class MemoryWatch {
 public:
  /// limit: in bytes; 0: no limit. Throws std::system_error if the thread cannot be started.
  explicit MemoryWatch(std::uint64_t limit);

 private:
  void look_regularly(const std::stop_token& stop);

  std::uint64_t limit_;
  // The thread allocates no memory, because there may be none left. So all that it needs exists before it starts.
  std::string outgrown_;
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  ///< the last member: the thread ends before the others are destroyed
};

}  // namespace pardel::cli
