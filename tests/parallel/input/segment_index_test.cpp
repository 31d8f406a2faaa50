// The segment index on small inputs.
#include "../../../parallel/input/segment_index.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::square;

TEST(SegmentIndex, finds_the_segment_through_a_point) {
  const Pslg pslg = square(2);
  const SegmentIndex index(pslg.points, pslg.segments);
  EXPECT_EQ(index.through({2, 1}), 1);
  EXPECT_EQ(index.through({1, 2}), 2);
  EXPECT_NE(index.through({2, 2}), no_index);
  EXPECT_EQ(index.through({1, 1}), no_index);
  EXPECT_EQ(index.through({2, 2.5}), no_index);
}

TEST(SegmentIndex, finds_the_highest_segment_below_including_right_ends_but_not_left_ends) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {0, 1}, {2, 2}, {4, 1}, {2, -1}};
  const std::vector<Segment> segments{{0, 1}, {2, 3}, {4, 3}, {3, 5}};
  const std::vector<Segment> without_vertical(segments.begin(), segments.begin() + 3);
  const SegmentIndex index(points, without_vertical);
  EXPECT_EQ(index.below({1, 3}), 1);
  EXPECT_EQ(index.below({3, 3}), 2);
  EXPECT_EQ(index.below({2, 3}), 1);  // segment 1 ends at x = 2, where segment 2 begins
  EXPECT_EQ(index.below({1, 1}), 0);
  EXPECT_EQ(index.below({1, -1}), no_index);
  EXPECT_EQ(index.below({0, 3}), no_index);
  EXPECT_EQ(index.below({4, 3}), 2);
}

TEST(SegmentIndex, visits_every_pair_of_near_segments_once) {
  Pslg pslg;
  for (int i = 0; i < 100; ++i) {
    pslg.points.insert(pslg.points.end(), {{1.0 * (i % 10), 1.0 * (i / 10)}, {i % 10 + 1.5, i / 10 + 0.5}});
    pslg.segments.push_back({static_cast<Index>(2 * i), static_cast<Index>(2 * i + 1)});
  }
  std::set<std::pair<Index, Index>> expected, visited;
  for (Index s = 0; s < 100; ++s)
    for (Index t = 0; t < s; ++t)
      if (Box::around(pslg.points[2 * s], pslg.points[2 * s + 1])
              .intersects_closed(Box::around(pslg.points[2 * t], pslg.points[2 * t + 1])))
        expected.insert({t, s});
  std::size_t visits = 0;
  SegmentIndex(pslg.points, pslg.segments).for_each_near_pair([&](Index s, Index t) {
    visited.insert(std::minmax(s, t));
    ++visits;
    return true;
  });
  EXPECT_EQ(visited, expected);
  EXPECT_EQ(visits, expected.size());
}

}  // namespace
}  // namespace pardel::engine
