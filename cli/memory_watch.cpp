#include "memory_watch.hpp"

#include "../core/support/amount_of_memory.hpp"
#include "end_process.hpp"
#include "memory.hpp"
#include "watch_thread.hpp"

namespace pardel::cli {

MemoryWatch::MemoryWatch(std::uint64_t limit)
    : limit_(limit),
      outgrown_("the process has outgrown the memory that it may use, " +
                amount_of_memory(static_cast<double>(limit))) {
  if (limit == 0) return;
  thread_ = start_watch<std::jthread>("the memory", [this](const std::stop_token& stop) { look_regularly(stop); });
}

void MemoryWatch::look_regularly(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const std::uint64_t used = used_memory();
    if (used > limit_) end_process(ErrorKind::resources, outgrown_);
    stopped_.wait_for(lock, stop, time_to_next_look(used, limit_), [] { return false; });
  }
}

}  // namespace pardel::cli
