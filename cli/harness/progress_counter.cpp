#include "progress_counter.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>

namespace pardel::harness {

ProgressCounter::ProgressCounter(std::size_t all) : all_(all), enabled_(isatty(STDERR_FILENO) == 1) {}

ProgressCounter::~ProgressCounter() {
  if (shown_ > 0) fmt::print(stderr, "\r\033[K");
}

void ProgressCounter::show(std::size_t done) {
  if (!enabled_) return;
  const std::lock_guard<std::mutex> lock(guard_);
  if (done <= shown_) return;  // another thread has shown a larger number
  shown_ = done;
  fmt::print(stderr, "\r\033[K{} of {} cases", done, all_);
  std::fflush(stderr);
}

}  // namespace pardel::harness
