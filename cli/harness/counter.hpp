// "120 of 2000" on stderr, where that is a terminal.
#pragma once

#include <cstddef>
#include <mutex>

namespace pardel::harness {

/// Wipes its line at the end. show() may be called from any thread.
class Counter {
 public:
  explicit Counter(std::size_t all);
  ~Counter();
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  void show(std::size_t done);

 private:
  std::size_t all_;
  bool enabled_;
  std::mutex guard_;
  std::size_t shown_ = 0;  // under guard_
};

}  // namespace pardel::harness
