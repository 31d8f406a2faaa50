// The stopwatch measures elapsed time.
#include "../../../core/support/stopwatch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace pardel {
namespace {

TEST(Stopwatch, laps_follow_each_other_without_a_gap) {
  const Stopwatch total;
  Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double first = watch.lap();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double second = watch.lap();
  EXPECT_GE(first, 0.02);
  EXPECT_GE(second, 0.02);
  EXPECT_LE(first + second, total.seconds());
}

}  // namespace
}  // namespace pardel
