// Handling of SIGINT (Ctrl-C) and SIGTERM: they end the process at once, and it leaves nothing half done.
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace pardel::cli {

/// While an object of this class exists, SIGINT and SIGTERM end the process with end_process(). A thread waits for the
/// signals. So no part of the work has to ask for them, also not sorting, libraries, or the release of memory. main()
/// makes the object before there are other threads, because the signals must be blocked in all threads.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  void wait();

  sigset_t signals_{};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace pardel::cli
