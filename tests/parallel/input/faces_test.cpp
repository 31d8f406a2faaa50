// Faces on small inputs.
#include "../../../parallel/input/faces.hpp"

#include <gtest/gtest.h>

#include <set>

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
  pslg.segments.push_back({5, 12});   // from a corner of the first island outwards
  pslg.segments.push_back({13, 14});  // both ends are free
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

TEST(Faces, on_both_sides_of_a_touching_point_are_distinguished) {
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

}  // namespace
}  // namespace pardel::engine
