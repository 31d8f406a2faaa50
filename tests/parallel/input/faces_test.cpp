// Faces, hulls, duplicates and the segment index on small inputs whose answers are plain.
#include "../../../parallel/input/faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../../../parallel/input/convex_hull.hpp"
#include "../../../parallel/input/duplicates.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_square;
using testing::square;

TEST(Faces, of_a_square_are_its_inside_and_the_exterior) {
  const Pslg pslg = square(2);
  const SegmentIndex index(pslg.points, pslg.segments);
  const Faces faces(pslg.points, pslg.segments, index);
  EXPECT_EQ(faces.count(), 2);
  for (Index s = 0; s < 4; ++s) {
    EXPECT_EQ(faces.left_of(s), 1);
    EXPECT_EQ(faces.right_of(s), Faces::exterior);
  }
  EXPECT_EQ(faces.containing({1, 1}), 1);
  for (const Point p : {Point{3, 1}, {-1, 1}, {1, 3}, {1, -1}, {2, 3}, {0, 3}, {0, -1}, {-1, 0}, {3, 2}})
    EXPECT_EQ(faces.containing(p), Faces::exterior) << p.x << " " << p.y;
}

TEST(Faces, reach_around_islands_and_dangling_ends) {
  Pslg pslg = square(8);
  add_square(pslg, 2, {2, 3});
  add_square(pslg, 1, {5, 3});
  pslg.points.insert(pslg.points.end(), {{4.5, 2.5}, {4, 7}, {7, 7}});
  pslg.segments.push_back({5, 12});   // corner of the first island, outwards
  pslg.segments.push_back({13, 14});  // free
  const SegmentIndex index(pslg.points, pslg.segments);
  const Faces faces(pslg.points, pslg.segments, index);
  EXPECT_EQ(faces.count(), 4);
  const Index around = faces.containing({1, 1});
  EXPECT_EQ(around, faces.left_of(0));
  EXPECT_EQ(faces.containing({4.5, 3.5}), around);
  for (const Index s : {4, 5, 6, 7, 8, 9, 10, 11}) EXPECT_EQ(faces.right_of(s), around);
  for (const Index s : {12, 13}) {
    EXPECT_EQ(faces.left_of(s), around);
    EXPECT_EQ(faces.right_of(s), around);
  }
  EXPECT_NE(faces.containing({3, 4}), around);
  EXPECT_NE(faces.containing({3, 4}), faces.containing({5.5, 3.5}));
}

TEST(Faces, on_both_sides_of_a_touching_point_are_told_apart) {
  Pslg pslg = square(4);  // a bow tie inside: two triangles that share point 4
  pslg.points.insert(pslg.points.end(), {{2, 2}, {1, 1}, {1, 3}, {3, 1}, {3, 3}});
  pslg.segments.insert(pslg.segments.end(), {{4, 5}, {5, 6}, {6, 4}, {4, 7}, {7, 8}, {8, 4}});
  const SegmentIndex index(pslg.points, pslg.segments);
  const Faces faces(pslg.points, pslg.segments, index);
  EXPECT_EQ(faces.count(), 4);
  const std::set<Index> distinct{faces.containing({1.25, 2}), faces.containing({2.75, 2}), faces.containing({2, 1})};
  EXPECT_EQ(distinct.size(), 3);
  EXPECT_EQ(faces.containing({2, 1}), faces.containing({2, 3}));
}

TEST(Faces, without_segments_is_the_exterior_alone) {
  const std::vector<Point> points{{0, 0}, {1, 1}};
  const std::vector<Segment> none;
  const SegmentIndex index(points, none);
  const Faces faces(points, none, index);
  EXPECT_EQ(faces.count(), 1);
  EXPECT_EQ(faces.containing({0.5, 0.5}), Faces::exterior);
}

TEST(Faces, of_thousands_of_islands_and_nested_squares_are_all_found) {
  Pslg pslg = square(1000);
  constexpr int n = 60;
  for (int i = 0; i < n * n; ++i) add_square(pslg, 1, {10.0 + 10 * (i % n), 10.0 + 10 * (i / n)});
  for (int i = 0; i < 100; ++i) add_square(pslg, 300 - 2 * i, {650.0 + i, 650.0 + i});
  const SegmentIndex index(pslg.points, pslg.segments);
  const Faces faces(pslg.points, pslg.segments, index);
  EXPECT_EQ(faces.count(), 2 + n * n + 100);
  const Index around = faces.left_of(0);
  for (Index s = 4; s < 4 + 4 * n * n; ++s) EXPECT_EQ(faces.right_of(s), around);
  for (int i = 1; i < 100; ++i) {
    const Index outer = 4 + 4 * n * n + 4 * (i - 1);
    EXPECT_EQ(faces.right_of(outer + 4), faces.left_of(outer));
  }
}

TEST(SegmentIndex, finds_the_segment_through_a_point) {
  const Pslg pslg = square(2);
  const SegmentIndex index(pslg.points, pslg.segments);
  EXPECT_EQ(index.through({2, 1}), 1);
  EXPECT_EQ(index.through({1, 2}), 2);
  EXPECT_NE(index.through({2, 2}), no_index);
  EXPECT_EQ(index.through({1, 1}), no_index);
  EXPECT_EQ(index.through({2, 2.5}), no_index);
}

TEST(SegmentIndex, sees_the_highest_segment_below_and_ends_but_not_beginnings) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {0, 1}, {2, 2}, {4, 1}, {2, -1}};
  const std::vector<Segment> segments{{0, 1}, {2, 3}, {4, 3}, {3, 5}};
  const std::vector<Segment> without_vertical(segments.begin(), segments.begin() + 3);
  const SegmentIndex index(points, without_vertical);
  EXPECT_EQ(index.below({1, 3}), 1);
  EXPECT_EQ(index.below({3, 3}), 2);
  EXPECT_EQ(index.below({2, 3}), 1);  // ends there; segment 2 begins
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

TEST(Duplicates, are_also_what_is_closer_than_a_distance_across_cells) {
  const std::vector<Point> points{{0.99, 0}, {1.01, 0}, {2.02, 0}, {0, 0}, {1.5, 0}};
  EXPECT_EQ(find_close(points, 1), (std::vector<Duplicate>{{0, 1}, {0, 3}, {0, 4}}));
  EXPECT_TRUE(find_close(points, 1e-300).empty());
}

TEST(Hull, holds_the_points_on_its_sides_too) {
  const std::vector<Point> points{{2, 2}, {4, 0}, {0, 0}, {2, 0}, {4, 4}, {0, 4}, {4, 2}, {0, 1}, {4, 4}, {1, 2}};
  EXPECT_EQ(convex_hull(points), (std::vector<Index>{2, 3, 1, 6, 4, 5, 7}));
}

TEST(Hull, is_exact_where_rounding_would_lose_a_corner) {
  const double y = std::nextafter(0.3, 0.0);
  const std::vector<Point> points{{0.1, 0.1}, {0.3, y}, {0.7, 0.7}, {0, 1}};
  EXPECT_EQ(convex_hull(points), (std::vector<Index>{3, 0, 1, 2}));
}

TEST(Hull, knows_when_all_points_are_on_one_line) {
  EXPECT_TRUE(all_collinear({}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{1, 1}, {1, 1}, {2, 3}}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}}));
  EXPECT_FALSE(all_collinear(std::vector<Point>{{0.1, 0.1}, {0.3, std::nextafter(0.3, 1.0)}, {0.7, 0.7}}));
}

}  // namespace
}  // namespace pardel::engine
