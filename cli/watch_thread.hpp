// Starts the threads that watch the process.
#pragma once

#include <string>
#include <system_error>
#include <utility>

namespace pardel::cli {

/// Starts a thread. Throws std::system_error with a message that names the thing `watched` if the system has no thread
/// left, or no memory for its stack.
template <class Thread, class Work>
[[nodiscard]] Thread start_watch(const char* watched, Work&& work) {
  try {
    return Thread(std::forward<Work>(work));
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(), std::string("the thread that watches ") + watched + " cannot be started");
  }
}

}  // namespace pardel::cli
