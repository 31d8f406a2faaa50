#include "progress_bar.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace pardel::cli {
namespace {

using namespace std::chrono_literals;

constexpr int width = 32;
constexpr auto delay = 1s;
constexpr auto interval = 100ms;

/// For example "3.21 of about 10.01 million". If the estimate was too low, it is omitted.
std::string count(double triangles, double estimate) {
  const bool small = std::max(triangles, estimate) < 10'000;
  const auto number = [&](double n) { return small ? fmt::format("{:.0f}", n) : fmt::format("{:.2f}", n * 1e-6); };
  const std::string unit = small ? "" : " million";
  return number(triangles) + (estimate > triangles ? " of about " + number(estimate) : std::string()) + unit;
}

std::string bar(double fraction) {
  const int full = static_cast<int>(fraction * width);
  return fmt::format("[{:#<{}}{:-<{}}] {:3.0f} %", "", full, "", width - full, 100 * fraction);
}

}  // namespace

std::string progress_line(std::uint64_t triangles, double estimate, double seconds) {
  const double done = static_cast<double>(triangles);
  const std::string left = estimate > 0 ? bar(std::min(done / estimate, 0.99)) + "  " : std::string();
  return fmt::format("{}{} triangles  {:.0f} s", left, count(done, estimate), seconds);
}

ProgressBar::ProgressBar(ShowProgress show)
    : enabled_(show == ShowProgress::always || (show == ShowProgress::automatic && isatty(STDERR_FILENO) == 1)),
      next_(show == ShowProgress::always ? start_ : start_ + delay) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::update(std::uint64_t triangles, double estimate) {
  if (!enabled_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + interval;
  drawn_ = true;
  fmt::print(stderr, "\r\033[K{}",
             progress_line(triangles, estimate, std::chrono::duration<double>(now - start_).count()));
  std::fflush(stderr);
}

}  // namespace pardel::cli
