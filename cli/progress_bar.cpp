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
constexpr auto patience = 1s;
constexpr auto pause = 100ms;

std::string count(std::uint64_t triangles) {
  return triangles < 10'000 ? fmt::format("{}", triangles)
                            : fmt::format("{:.2f} million", static_cast<double>(triangles) * 1e-6);
}

std::string bar(double fraction) {
  const int full = static_cast<int>(fraction * width);
  return fmt::format("[{:#<{}}{:-<{}}] {:3.0f} %", "", full, "", width - full, 100 * fraction);
}

}  // namespace

ProgressBar::ProgressBar(ShowProgress show)
    : enabled_(show == ShowProgress::always || (show == ShowProgress::automatic && isatty(STDERR_FILENO) == 1)),
      next_(show == ShowProgress::always ? start_ : start_ + patience) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::update(std::uint64_t triangles, double estimate) {
  if (!enabled_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + pause;
  drawn_ = true;
  // An estimate may fall short; the bar waits at 99 % then.
  const double done = static_cast<double>(triangles);
  const std::string left = estimate > 0 ? bar(std::min(done / estimate, 0.99)) + "  " : std::string();
  fmt::print(stderr, "\r\033[K{}{} triangles  {:.0f} s", left, count(triangles),
             std::chrono::duration<double>(now - start_).count());
  std::fflush(stderr);
}

}  // namespace pardel::cli
