// Prints "120 of 2000 cases" on stderr if stderr is a terminal.
#pragma once

#include <cstddef>
#include <mutex>

namespace pardel::harness {

/// The destructor clears the line. show() may be called from any thread.
class ProgressCounter {
 public:
  explicit ProgressCounter(std::size_t all);
  ~ProgressCounter();
  ProgressCounter(const ProgressCounter&) = delete;
  ProgressCounter& operator=(const ProgressCounter&) = delete;

  void show(std::size_t done);

 private:
  std::size_t all_;
  bool enabled_;
  std::mutex guard_;
  std::size_t shown_ = 0;  // guard_ protects it
};

}  // namespace pardel::harness
