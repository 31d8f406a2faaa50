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
  /// `reports_sigterm`: false if SIGTERM ends the process without a message. Throws std::system_error if the thread
  /// cannot be started.
  explicit InterruptWatch(bool reports_sigterm = true);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  void wait();

  bool reports_sigterm_;
  sigset_t signals_{};
  std::atomic<bool> finished_{false};
  std::thread thread_;
};

}  // namespace pardel::cli
