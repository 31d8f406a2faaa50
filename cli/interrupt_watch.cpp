#include "interrupt_watch.hpp"

#include <pthread.h>

#include "end_process.hpp"
#include "watch_thread.hpp"

namespace pardel::cli {
namespace {

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

InterruptWatch::InterruptWatch() {
  std::signal(SIGXFSZ, SIG_IGN);  // a write then fails with EFBIG
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) sigaddset(&signals_, signal);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = start_watch<std::thread>("signals", [this] { wait(); });
}

InterruptWatch::~InterruptWatch() {
  finished_ = true;
  pthread_kill(thread_.native_handle(), SIGHUP);  // wakes the thread, which then sees finished_
  thread_.join();
}

void InterruptWatch::wait() {
  int signal = 0;
  while (!finished_) {
    // sigwait also returns signals that are ignored, because they are blocked.
    if (sigwait(&signals_, &signal) != 0 || finished_ || is_ignored(signal)) continue;
    if (signal == SIGXCPU) end_process(ErrorKind::resources, "the process has reached the limit on its processor time");
    end_process(ErrorKind::cancelled, signal == SIGTERM && !reports_sigterm_ ? "" : "interrupted");
  }
}

}  // namespace pardel::cli
