// A line on stderr that shows the current step of the work and its progress.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

namespace pardel::cli {

enum class ShowProgress : std::uint8_t { automatic, always, never };

/// The number of characters of a line that may have any length.
inline constexpr std::size_t any_width = std::numeric_limits<std::size_t>::max();

/// The line of the refinement. `estimate`: the estimated final number of triangles, 0 if unknown. If the estimate was
/// too low, the bar stays at 99 %. A line longer than `width` gets a shorter bar, then no bar, and is then cut.
[[nodiscard]] std::string progress_line(std::uint64_t triangles, double estimate, double seconds,
                                        std::size_t width = any_width);

/// The line of any other step, for example "reading key.poly  4 s". A long name is shortened.
[[nodiscard]] std::string step_line(const std::string& step, double seconds, std::size_t width = any_width);

/// Redraws the line in place ten times a second, also while the work does not report, and erases it at the end. With
/// `automatic` the line appears only on a terminal, and only after one second. It is never wider than the terminal.
class ProgressBar {
 public:
  explicit ProgressBar(ShowProgress show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// A step of the work begins: "reading key.poly".
  void begin(std::string step);
  /// The refinement has made so many triangles. Frequent calls are cheap. `estimate`: as in progress_line().
  void update(std::uint64_t triangles, double estimate);
  /// Erases the line. It does not appear again.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void redraw_if_due();
  void redraw_regularly(const std::stop_token& stop);

  bool enabled_;
  const Clock::time_point start_ = Clock::now();
  const Clock::time_point appears_;
  std::mutex mutex_;               ///< protects all members below, except the thread
  std::string step_ = "starting";  ///< empty: the refinement
  std::uint64_t triangles_ = 0;
  double estimate_ = 0;
  bool drawn_ = false;
  Clock::time_point next_;
  std::condition_variable_any stopped_;
  std::jthread thread_;
};

}  // namespace pardel::cli
