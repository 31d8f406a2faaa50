#include "../../../parallel/concurrency/parallel_for.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pardel::engine {
namespace {

TEST(ParallelFor, calls_the_body_once_for_each_item) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> calls(1000, 0);
    parallel_for(threads, calls.size(), [&](std::size_t i, int thread) {
      ++calls[i];
      EXPECT_GE(thread, 0);
      EXPECT_LT(thread, threads);
    });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
  }
}

TEST(ParallelFor, throws_bad_alloc_if_a_body_does) {
  for (const int threads : {1, 2})
    EXPECT_THROW(parallel_for(threads, 10,
                              [](std::size_t i, int) {
                                if (i == 3) throw std::bad_alloc();
                              }),
                 std::bad_alloc);
}

TEST(ParallelBlocks, divide_the_items_into_consecutive_blocks) {
  const std::size_t n = 2 * items_in_block + 5;
  ASSERT_EQ(block_count(n), 3U);
  EXPECT_EQ(block_count(0), 0U);
  std::vector<std::size_t> first(3), last(3);
  parallel_blocks(2, n, [&](std::size_t from, std::size_t to, std::size_t block) {
    first[block] = from;
    last[block] = to;
  });
  EXPECT_EQ(first, (std::vector<std::size_t>{0, items_in_block, 2 * items_in_block}));
  EXPECT_EQ(last, (std::vector<std::size_t>{items_in_block, 2 * items_in_block, n}));
}

}  // namespace
}  // namespace pardel::engine
