// Arrays that are built in parallel do not depend on the number of threads.
#include "../../../parallel/threads/parallel_arrays.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

TEST(AppendBlocks, keeps_the_order_of_the_blocks) {
  Random random(1);
  std::vector<std::vector<int>> blocks(50);
  std::vector<int> expected;
  for (auto& block : blocks)
    for (std::size_t n = random.below(4); n > 0; --n) {
      block.push_back(static_cast<int>(expected.size()));
      expected.push_back(block.back());
    }
  for (const int threads : {1, 2, 7}) {
    Array<int> all(1, -1);
    append_blocks(threads, blocks, all);
    ASSERT_EQ(all.size(), expected.size() + 1);
    EXPECT_EQ(all[0], -1);
    EXPECT_TRUE(std::equal(all.begin() + 1, all.end(), expected.begin()));
  }
}

TEST(IndicesWhere, lists_indices_in_ascending_order) {
  constexpr std::size_t n = 40'000;
  const auto wanted = [](std::size_t i) { return i % 3 == 0 || (i > 16'000 && i < 17'000); };
  std::vector<Index> expected;
  for (std::size_t i = 0; i < n; ++i)
    if (wanted(i)) expected.push_back(static_cast<Index>(i));
  for (const int threads : {0, 1, 2, 7})
    EXPECT_TRUE(std::ranges::equal(indices_where(threads, n, wanted), expected)) << threads << " threads";
  EXPECT_TRUE(indices_where(2, 0, wanted).empty());
}

TEST(MakeArray, makes_each_element_from_its_index) {
  for (const int threads : {0, 1, 2, 7}) {
    const Array<double> halves =
        make_array(threads, 40'000, [](std::size_t i) { return 0.5 * static_cast<double>(i); });
    ASSERT_EQ(halves.size(), 40'000U);
    for (std::size_t i = 0; i < halves.size(); ++i) ASSERT_EQ(halves[i], 0.5 * static_cast<double>(i));
  }
}

TEST(VisitByCell, visits_each_cell_in_ascending_order_on_any_number_of_threads) {
  constexpr std::size_t cells = 5, n = 40'000;
  Random random(2);
  std::vector<Index> cell_of(n);
  for (Index& cell : cell_of) cell = random.below(6) < 5 ? static_cast<Index>(random.below(cells)) : no_index;
  std::vector<std::vector<std::size_t>> expected(cells);
  for (std::size_t i = 0; i < n; ++i)
    if (cell_of[i] != no_index) expected[cell_of[i]].push_back(i);
  for (const int threads : {1, 2, 3, 8}) {
    std::vector<std::vector<std::size_t>> visited(cells);
    visit_by_cell(
        threads, n, cells, [&](std::size_t i) { return cell_of[i]; },
        [&](Index cell, std::size_t i) { visited[cell].push_back(i); });
    EXPECT_EQ(visited, expected) << threads << " threads";
  }
}

}  // namespace
}  // namespace pardel::engine
