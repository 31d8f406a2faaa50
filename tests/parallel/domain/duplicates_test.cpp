// Equal and close points.
#include "../../../parallel/domain/duplicates.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

TEST(Duplicates, name_the_first_of_equal_points) {
  const std::vector<Point> points{{1, 2}, {0.0, 3}, {1, 2}, {-0.0, 3}, {2, 1}, {1, 2}};
  EXPECT_EQ(find_duplicates(points), (std::vector<Duplicate>{{0, 2}, {1, 3}, {0, 5}}));
  EXPECT_TRUE(find_duplicates({}).empty());
}

TEST(Duplicates, are_found_among_many_points) {
  std::vector<Point> points;
  for (int i = 0; i < 100000; ++i) points.push_back({0.1 * (i % 300), 0.1 * (i / 300)});
  EXPECT_TRUE(find_duplicates(points).empty());
  points.push_back(points[77777]);
  for (const int threads : {0, 1, 2, 7})
    EXPECT_EQ(find_duplicates(points, threads), (std::vector<Duplicate>{{77777, 100000}})) << threads;
  EXPECT_EQ(find_duplicates(std::vector<Point>(50000)).size(), 49999);
}

TEST(Duplicates, include_points_closer_than_a_distance_across_cells) {
  const std::vector<Point> points{{0.99, 0}, {1.01, 0}, {2.02, 0}, {0, 0}, {1.5, 0}};
  const auto closer_than = [&](double distance) { return find_close(points, Reach(distance, points, {})); };
  EXPECT_EQ(closer_than(1), (std::vector<Duplicate>{{0, 1}, {0, 3}, {0, 4}}));
  EXPECT_TRUE(closer_than(1e-300).empty());
}

TEST(Duplicates, are_closer_than_a_share_of_the_smaller_of_both_scales) {
  const std::vector<Point> points{{0, 0}, {0x1p60, 0}, {0x1p60, 0x1p29}, {0, 0x1p20}, {-1, 0}, {-1, 0x1p-31}, {2, 0}};
  const std::vector<Segment> segments{{0, 1}, {3, 2}, {4, 6}, {5, 6}, {3, 4}};
  const Reach reach(Snapping::share_of_scale(0x1p-30), points, segments);
  EXPECT_EQ(find_close(points, reach), (std::vector<Duplicate>{{1, 2}, {4, 5}}));
}

TEST(Duplicates, of_segments_are_found_in_the_order_of_all_ends) {
  const std::vector<Segment> segments{{0, 3}, {2, 0}, {0, 1}, {2, 1}, {3, 1}, {1, 2}, {3, 2}};
  std::vector<std::array<Index, 3>> found;
  for (const Ends& e : sorted_ends(segments, 4)) found.push_back({e.low, e.high, e.segment});
  EXPECT_EQ(found, (std::vector<std::array<Index, 3>>{
                       {0, 1, 2}, {0, 2, 1}, {0, 3, 0}, {1, 2, 3}, {1, 2, 5}, {1, 3, 4}, {2, 3, 6}}));
}

TEST(Duplicates, among_many_points_are_in_ascending_order) {
  std::vector<Point> points;
  for (int i = 0; i < 4096; ++i) points.push_back({0.5 * (i % 64), 0.25 * (i / 64)});
  std::vector<Duplicate> expected;
  for (Index i = 0; i < 100; ++i) {
    expected.push_back({40 * i, static_cast<Index>(points.size())});
    points.push_back(points[40 * i]);
  }
  EXPECT_EQ(find_duplicates(points), expected);
}

}  // namespace
}  // namespace pardel::engine
