#include "interrupt_watch.hpp"

#include <pthread.h>

#include "end_process.hpp"

namespace pardel::cli {

InterruptWatch::InterruptWatch() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = std::thread([this] { wait(); });
}

InterruptWatch::~InterruptWatch() {
  finished_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);  // wakes the thread
  thread_.join();
}

void InterruptWatch::wait() {
  int signal = 0;
  while (sigwait(&signals_, &signal) != 0) continue;
  if (!finished_) end_process({ErrorKind::cancelled, "interrupted"});
}

}  // namespace pardel::cli
