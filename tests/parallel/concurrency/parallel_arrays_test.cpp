// What many threads list at once comes in one order, whatever their number.
#include "../../../parallel/concurrency/parallel_arrays.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/concurrency/bounding_box.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

TEST(InOrder, blocks_are_joined_one_after_another) {
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

TEST(InOrder, what_satisfies_is_listed_in_ascending_order) {
  constexpr std::size_t n = 40'000;
  const auto wanted = [](std::size_t i) { return i % 3 == 0 || (i > 16'000 && i < 17'000); };
  std::vector<Index> expected;
  for (std::size_t i = 0; i < n; ++i)
    if (wanted(i)) expected.push_back(static_cast<Index>(i));
  for (const int threads : {0, 1, 2, 7})
    EXPECT_TRUE(std::ranges::equal(indices_where(threads, n, wanted), expected)) << threads << " threads";
  EXPECT_TRUE(indices_where(2, 0, wanted).empty());
}

TEST(InOrder, an_array_is_made_element_by_element) {
  for (const int threads : {0, 1, 2, 7}) {
    const Array<double> halves =
        make_array(threads, 40'000, [](std::size_t i) { return 0.5 * static_cast<double>(i); });
    ASSERT_EQ(halves.size(), 40'000U);
    for (std::size_t i = 0; i < halves.size(); ++i) ASSERT_EQ(halves[i], 0.5 * static_cast<double>(i));
  }
}

TEST(InOrder, each_cell_gets_its_own_in_ascending_order_on_any_number_of_threads) {
  constexpr std::size_t cells = 5, n = 40'000;
  Random random(2);
  std::vector<Index> cell_of(n);
  for (Index& cell : cell_of) cell = random.below(6) < 5 ? static_cast<Index>(random.below(cells)) : no_index;
  std::vector<std::vector<std::size_t>> expected(cells);
  for (std::size_t i = 0; i < n; ++i)
    if (cell_of[i] != no_index) expected[cell_of[i]].push_back(i);
  for (const int threads : {1, 2, 3, 8}) {
    std::vector<std::vector<std::size_t>> filed(cells);
    visit_by_cell(
        threads, n, cells, [&](std::size_t i) { return cell_of[i]; },
        [&](Index cell, std::size_t i) { filed[cell].push_back(i); });
    EXPECT_EQ(filed, expected) << threads << " threads";
  }
}

TEST(Bounds, are_the_least_box_around_all_points_on_any_number_of_threads) {
  const std::vector<Point> points = samples::uniform_points(40'000, 3);
  const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(points, {}, &Point::y);
  for (const int threads : {0, 1, 2, 7}) {
    const Box box = bounding_box(threads, points.size(), [&](std::size_t i) { return points[i]; });
    EXPECT_EQ(box.min_x, left.x);
    EXPECT_EQ(box.max_x, right.x);
    EXPECT_EQ(box.min_y, low.y);
    EXPECT_EQ(box.max_y, high.y);
  }
  EXPECT_EQ(bounding_box(2, 0, [](std::size_t) { return Point{}; }).min_x, INFINITY);
}

}  // namespace
}  // namespace pardel::engine
