#include "../../../parallel/decomposition/bounding_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"

namespace pardel::engine {
namespace {

TEST(BoundingBox, is_the_smallest_box_around_all_points_on_any_number_of_threads) {
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
}

TEST(BoundingBox, of_no_points_is_the_empty_box) {
  const Box box = bounding_box(2, 0, [](std::size_t) { return Point{}; });
  EXPECT_EQ(box.min_x, empty_box.min_x);
  EXPECT_EQ(box.max_x, empty_box.max_x);
  EXPECT_EQ(box.min_y, empty_box.min_y);
  EXPECT_EQ(box.max_y, empty_box.max_y);
}

}  // namespace
}  // namespace pardel::engine
