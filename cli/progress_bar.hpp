// A progress bar on stderr for work that lasts.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace pardel::cli {

enum class ShowProgress : std::uint8_t { automatic, always, never };

/// What the bar shows. An estimate may fall short; the bar waits at 99 % then. 0: unknown.
[[nodiscard]] std::string progress_line(std::uint64_t triangles, double estimate, double seconds);

/// Draws one line and redraws it in place; wipes it at the end. With `automatic` it appears only on a
/// terminal, and only once the work has lasted a second.
class ProgressBar {
 public:
  explicit ProgressBar(ShowProgress show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Cheap enough to call often: it redraws ten times a second at most. estimate: 0 while unknown.
  void update(std::uint64_t triangles, double estimate);

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace pardel::cli
