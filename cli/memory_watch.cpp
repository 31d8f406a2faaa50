#include "memory_watch.hpp"

#include <condition_variable>
#include <mutex>

#include "../core/support/amount_of_memory.hpp"
#include "end_process.hpp"
#include "memory.hpp"

namespace pardel::cli {

MemoryWatch::MemoryWatch(std::uint64_t limit) : limit_(limit) {
  if (limit > 0) thread_ = std::jthread([this](const std::stop_token& stop) { look_regularly(stop); });
}

void MemoryWatch::look_regularly(const std::stop_token& stop) const {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any stopped;
  while (!stop.stop_requested()) {
    const std::uint64_t used = used_memory();
    if (used > limit_) {
      end_process({ErrorKind::resources,
                   "the process has outgrown the available memory, " + amount_of_memory(static_cast<double>(limit_))});
    }
    stopped.wait_for(lock, stop, time_to_next_look(used, limit_), [] { return false; });
  }
}

}  // namespace pardel::cli
