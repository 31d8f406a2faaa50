#include "progress_bar.hpp"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "exit_code.hpp"

namespace pardel::cli {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t widest_bar = 32;
constexpr std::size_t narrowest_bar = 8;
constexpr auto delay = 1s;
constexpr auto interval = 100ms;

/// For example "3.21 of about 10.01 million". If the estimate was too low, it is omitted.
std::string count(double triangles, double estimate) {
  const bool small = std::max(triangles, estimate) < 10'000;
  const auto number = [&](double n) { return small ? fmt::format("{:.0f}", n) : fmt::format("{:.2f}", n * 1e-6); };
  const std::string unit = small ? "" : " million";
  return number(triangles) + (estimate > triangles ? " of about " + number(estimate) : std::string()) + unit;
}

std::string bar(double fraction, std::size_t width) {
  const auto full = static_cast<std::size_t>(fraction * static_cast<double>(width));
  return fmt::format("[{:#<{}}{:-<{}}]", "", full, "", width - full);
}

bool is_terminal() { return isatty(STDERR_FILENO) == 1; }

/// One column less than the terminal has, because some terminals wrap a line that fills the last column.
std::size_t columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return is_terminal() ? 79 : any_width;
  return size.ws_col - 1U;
}

/// The first `width` bytes, without the rest of a character that does not fit.
std::string cut(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  while (width > 0 && (static_cast<unsigned char>(text[width]) & 0xC0) == 0x80) --width;
  return text.substr(0, width);
}

}  // namespace

std::string progress_line(std::uint64_t triangles, double estimate, double seconds, std::size_t width) {
  const double done = static_cast<double>(triangles);
  std::string line = fmt::format("{} triangles  {:.0f} s", count(done, estimate), seconds);
  if (estimate > 0) {
    const double fraction = std::min(done / estimate, 0.99);
    line = fmt::format("{:3.0f} %  ", 100 * fraction) + line;
    const std::size_t used = line.size() + 3;  // the brackets and a space
    const std::size_t room = width > used ? std::min(width - used, widest_bar) : 0;
    if (room >= narrowest_bar) line = bar(fraction, room) + ' ' + line;
  }
  return cut(line, width);
}

std::string step_line(const std::string& step, double seconds, std::size_t width) {
  const std::string time = fmt::format("  {:.0f} s", seconds);
  if (width != any_width && step.size() + time.size() > width && width > time.size() + 3)
    return cut(step, width - time.size() - 3) + "..." + time;
  return cut(step + time, width);
}

ProgressBar::ProgressBar(ShowProgress show)
    : enabled_(show == ShowProgress::always || (show == ShowProgress::automatic && is_terminal())),
      appears_(show == ShowProgress::always ? start_ : start_ + delay),
      next_(appears_) {
  if (enabled_) thread_ = std::jthread([this](const std::stop_token& stop) { redraw_regularly(stop); });
}

ProgressBar::~ProgressBar() { finish(); }

void ProgressBar::finish() {
  if (!enabled_) return;
  enabled_ = false;
  thread_.request_stop();
  thread_.join();
  if (drawn_) print_on_stderr("\r\033[K");
  std::fflush(stderr);
}

void ProgressBar::begin(std::string step) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  step_ = std::move(step);
  next_ = appears_;  // the new step is shown at once
  redraw_if_due();
}

void ProgressBar::update(std::uint64_t triangles, double estimate) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  if (!step_.empty()) next_ = appears_;
  step_.clear();
  triangles_ = triangles;
  estimate_ = estimate;
  redraw_if_due();
}

void ProgressBar::redraw_regularly(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    redraw_if_due();
    stopped_.wait_for(lock, stop, interval, [] { return false; });
  }
}

/// The caller holds the mutex.
void ProgressBar::redraw_if_due() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + interval;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line =
      step_.empty() ? progress_line(triangles_, estimate_, seconds, columns()) : step_line(step_, seconds, columns());
  drawn_ = true;
  print_on_stderr(fmt::format("\r\033[K{}", line));
  std::fflush(stderr);
}

}  // namespace pardel::cli
