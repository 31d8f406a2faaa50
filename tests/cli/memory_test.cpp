// How often the program looks at its memory.
#include "../../cli/memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "sanitized.hpp"

namespace pardel::cli {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

/// A process that grows at a constant rate until a look finds more than the limit.
struct Growth {
  std::uint64_t used = 0;
  std::size_t looks = 0;
};
Growth grow(std::uint64_t bytes_per_second, std::uint64_t limit) {
  Growth growth;
  for (; growth.used <= limit; ++growth.looks) {
    const auto pause = static_cast<std::uint64_t>(time_to_next_look(growth.used, limit).count());
    growth.used += bytes_per_second / 1000 * pause / 1000;
  }
  return growth;
}

TEST(Memory, is_found_to_exceed_the_limit_before_the_excess_is_5_percent) {
  for (const std::uint64_t limit : {200 * mebibyte, 512 * mebibyte, 1024 * mebibyte, 65536 * mebibyte})
    for (const std::uint64_t mebibytes_per_second : {100U, 400U, 1000U, 4000U, 9000U})
      EXPECT_LE(grow(mebibytes_per_second * mebibyte, limit).used, limit / 100 * 105);
}

TEST(Memory, is_looked_at_more_often_when_little_is_left_but_never_twice_in_a_millisecond) {
  const std::uint64_t limit = 1024 * mebibyte;
  EXPECT_GT(time_to_next_look(0, limit), time_to_next_look(limit / 2, limit));
  for (const std::uint64_t used : {limit - 1, limit}) EXPECT_EQ(time_to_next_look(used, limit).count(), 1000);
  // A process that fills a gibibyte in a second is looked at about 100 times, not 1000 times.
  EXPECT_LT(grow(1024 * mebibyte, limit).looks, 100U);
}

TEST(Memory, that_a_process_writes_to_is_used) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer gives memory back while others use some";
  const std::uint64_t before = used_memory();
  if (before == 0) GTEST_SKIP() << "there is no /proc";
  const std::vector<char> block(64 * mebibyte, 1);
  EXPECT_GE(used_memory(), before + block.size() / 2);
}

/// Processes share the memory of the system, but each has its own limit on its address space.
TEST(Memory, that_the_limit_of_a_process_allows_is_not_divided_among_processes) {
  const std::uint64_t of_system = available_memory();
  std::uint64_t pages = 0;
  if (!(std::ifstream("/proc/self/statm") >> pages)) GTEST_SKIP() << "there is no /proc";
  EXPECT_LT(available_memory(4), of_system / 3);
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const std::uint64_t allowed = 64 * mebibyte;
  const rlimit limit{pages * static_cast<std::uint64_t>(getpagesize()) + allowed, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &limit), 0);
  const std::uint64_t alone = available_memory(), shared = available_memory(4);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_LE(alone, allowed);
  EXPECT_GT(alone, allowed / 2);
  EXPECT_EQ(shared, alone);
}

}  // namespace
}  // namespace pardel::cli
