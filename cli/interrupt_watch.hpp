// Handling of signals that ask the program to end: it ends at once and leaves nothing half done.
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace pardel::cli {

/// While an object of this class exists, SIGINT (Ctrl-C), SIGTERM, SIGHUP (the terminal was closed) and SIGXCPU (the
/// limit on processor time) end the process with end_process(). A thread waits for the signals. So no part of the work
/// has to ask for them, also not sorting, libraries, or the release of memory. A signal that the process ignores stays
/// ignored: nohup ignores SIGHUP, and shells start background processes that ignore SIGINT. A file that exceeds the
/// limit on its size (SIGXFSZ) is an error of writing. main() makes the object before there are other threads, because
/// the signals must be blocked in all threads.
class InterruptWatch {
 public:
  /// Throws std::system_error if the thread cannot be started.
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// From now on, SIGTERM ends the process without a message. Thread-safe.
  void end_silently_on_sigterm() { reports_sigterm_ = false; }

 private:
  void wait();

  std::atomic<bool> reports_sigterm_{true};
  sigset_t signals_{};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace pardel::cli
