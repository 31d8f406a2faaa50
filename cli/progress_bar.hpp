// A progress bar on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace pardel::cli {

enum class ShowProgress : std::uint8_t { automatic, always, never };

/// The text of the bar. `estimate`: the estimated final number of triangles, 0 if unknown. If the estimate was too low,
/// the bar stays at 99 %.
[[nodiscard]] std::string progress_line(std::uint64_t triangles, double estimate, double seconds);

/// Draws one line, redraws it in place and erases it at the end. With `automatic` the line appears only on a terminal,
/// and only after one second.
class ProgressBar {
 public:
  explicit ProgressBar(ShowProgress show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Redraws at most ten times a second, so frequent calls are cheap. `estimate`: as in progress_line().
  void update(std::uint64_t triangles, double estimate);

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_;
};

}  // namespace pardel::cli
