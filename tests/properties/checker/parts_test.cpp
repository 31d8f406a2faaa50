// Parts of the checker alone: filters, measures, lengths that grow, lists of violations, fans, loops.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "../../../properties/checker/arithmetic/filter.hpp"
#include "../../../properties/checker/model/adjacency.hpp"
#include "../../../properties/checker/model/domain.hpp"
#include "../../../properties/checker/model/marked_edges.hpp"
#include "../../../properties/checker/model/measures.hpp"
#include "../../../properties/checker/model/scan.hpp"
#include "../../../properties/checker/model/segments_below.hpp"
#include "../../../properties/checker/model/wanted_size.hpp"
#include "../../../properties/checker/stages/findings.hpp"
#include "../../../properties/checker/tolerances.hpp"

namespace pardel::checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double below(double x) { return std::nextafter(x, -infinity); }

TEST(Shape, sums_the_squares_of_all_three_sides) {
  const filter::Shape shape({0, 0}, {4, 0}, {0, 3});
  EXPECT_EQ(shape.squared, (std::array<double, 3>{25, 9, 16}));
  EXPECT_EQ(shape.sum, 50);
  EXPECT_EQ(shape.error, 2.1 * filter::unit * 50);
}

/// The squares of the sides of a right triangle with two legs of length h sum to 4 h^2.
TEST(Shape, is_tame_if_the_squares_sum_to_a_number_between_two_bounds_or_to_one_of_them) {
  const auto is_tame = [](double h) { return filter::Shape({0, 0}, {h, 0}, {0, h}).is_tame(); };
  const double least = 0x1p-151, largest = 0x1p149;
  ASSERT_EQ(4 * least * least, filter::least_square);
  ASSERT_EQ(4 * largest * largest, filter::largest_square);
  EXPECT_TRUE(is_tame(1));
  EXPECT_TRUE(is_tame(least));
  EXPECT_FALSE(is_tame(below(least)));
  EXPECT_TRUE(is_tame(largest));
  EXPECT_FALSE(is_tame(std::nextafter(largest, infinity)));
}

/// A horizontal segment, and one that begins on it, to the right of its left end or there, and goes up or down. Both
/// orders, and all directions.
TEST(SegmentsBelow, find_the_nearer_one_of_two_segments_if_one_begins_on_the_other) {
  for (const double begin : {0.0, 1.0})
    for (const double slope : {1.0, -1.0})
      for (const int directions : {0, 1, 2, 3})
        for (const Index level : {0, 1}) {
          const std::vector<Point> points{{0, 0}, {4, 0}, {begin, 0}, {4, slope * (4 - begin)}};
          std::vector<Segment> segments(2);
          segments[level] = directions & 1 ? Segment{1, 0, 0} : Segment{0, 1, 0};
          segments[1 - level] = directions & 2 ? Segment{3, 2, 0} : Segment{2, 3, 0};
          const SegmentsBelow below(points, segments);
          const Index upper = slope > 0 ? 1 - level : level, lower = 1 - upper;
          const double middle = slope * (3 - begin) / 2;  // between the two, at x = 3
          EXPECT_EQ(below.directly_below({3, 9}), upper) << begin << ' ' << slope << ' ' << directions << ' ' << level;
          EXPECT_EQ(below.directly_below({3, middle}), lower);
          EXPECT_EQ(below.directly_below({3, -9}), no_index);
        }
}

TEST(Filter, gives_no_answer_for_a_point_at_distances_whose_squares_lose_digits) {
  const double h = 0x1p-151;
  const Point a{-h, 0}, b{h, 0}, c{0, 2 * h};
  const filter::Shape shape(a, b, c);
  ASSERT_TRUE(shape.is_tame());
  EXPECT_TRUE(filter::is_outside_circle(shape, 2, a, b, {0, -h})) << "the squares sum to least_square";
  EXPECT_FALSE(filter::is_outside_circle(shape, 2, a, b, {0, -below(h)}));
}

TEST(Filter, finds_that_a_right_triangle_meets_bounds_near_its_values) {
  const filter::Shape shape({0, 0}, {1, 0}, {0, 1});
  EXPECT_FALSE(filter::has_no_angle_below(shape, 1 + 36 * filter::unit));
  EXPECT_TRUE(filter::has_no_angle_below(shape, 1 + 40 * filter::unit));
  EXPECT_FALSE(filter::has_no_angle_below(shape, filter::cotangent_below(std::sqrt(0.5))));
  EXPECT_TRUE(filter::has_no_angle_below(shape, filter::cotangent_below(std::sqrt(0.5) + 0x1p-48)));
  EXPECT_FALSE(filter::is_not_larger(shape, (1 + 16 * filter::unit) / 2));
  EXPECT_TRUE(filter::is_not_larger(shape, (1 + 18 * filter::unit) / 2));
  EXPECT_FALSE(filter::is_not_longer(shape, std::sqrt(2.0)));
  EXPECT_TRUE(filter::is_not_longer(shape, std::sqrt(2.0) + 0x1p-48));
  EXPECT_FALSE(filter::has_no_larger_circumradius(shape, std::sqrt(0.5)));
  EXPECT_TRUE(filter::has_no_larger_circumradius(shape, std::sqrt(0.5) + 0x1p-48));
}

/// The scan of one triangle about as large as `size`, with weak bounds of all kinds.
Scan scan_of_one(double size) {
  const std::vector<Point> points{{0, 0}, {size, 0}, {size / 2, size}};
  const std::vector<Triangle> triangles{{{0, 1, 2}, {no_index, no_index, no_index}}};
  return scan(points, triangles, {.cosine = 0.9, .area = 10, .edge = 10, .circumradius = 10});
}

TEST(Scan, leaves_every_test_of_a_very_small_triangle_open) {
  EXPECT_TRUE(scan_of_one(1).open.empty());
  const Scan scanned = scan_of_one(0x1p-200);
  ASSERT_EQ(scanned.open.size(), 1U);
  EXPECT_EQ(scanned.open[0].tests, 1 + 2 + 4 + 8 + 16 + 32);
}

TEST(Measures, find_the_longest_edge_also_if_it_is_longer_by_a_trillionth) {
  const std::vector<std::array<Point, 3>> triangles{
      {{{0, 0}, {10, 0}, {5, 0.1}}},                // the extreme angles and the largest circumradius
      {{{0, 0}, {0.1, 0}, {0, 0.1}}},               // the shortest edges
      {{{0, 0}, {9.9, 0}, {4.95, 8}}},              // the largest area
      {{{0, 0}, {10 * (1 + 0x1p-40), 0}, {5, 4}}},  // the longest edge
      {{{0, 0}, {10 * (1 + 0x1p-40), 0}, {5, 4}}},
  };
  Measures measures;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    measures.add(t, triangles[t], filter::Shape(a, b, c));
  }
  Certificate found;
  measures.report(found);
  EXPECT_EQ(found.min_angle_deg.triangle, 0U);
  EXPECT_EQ(found.min_edge.triangle, 1U);
  EXPECT_EQ(found.max_area.triangle, 2U);
  EXPECT_EQ(found.max_edge.triangle, 3U);
  EXPECT_EQ(found.max_edge.value, 10 * (1 + 0x1p-40));
}

TEST(GrowingLengths, take_the_best_point_of_a_piece_along_which_the_length_changes) {
  // The length grows by a half along the piece, and by 1 away from it. So the way back to the best point of the piece
  // encloses an angle of 30 degrees with the perpendicular.
  const GrowingLengths rising({{{0, 0}, {1, 0}, 1, 1.5, 1}}), falling({{{0, 0}, {1, 0}, 1.5, 1, 1}});
  for (const double y : {0.1, -0.1}) {
    EXPECT_NEAR(rising.least({0.5, y}), 1.25 + 0.1 * std::sqrt(0.75), 1e-14);
    EXPECT_NEAR(falling.least({0.5, y}), 1.25 + 0.1 * std::sqrt(0.75), 1e-14);
  }
  EXPECT_DOUBLE_EQ(rising.least({0.5, 2}), 1 + std::hypot(0.5, 2.0)) << "the best point is an end";
  EXPECT_DOUBLE_EQ(falling.least({0.5, 2}), 1 + std::hypot(0.5, 2.0)) << "the best point is an end";
}

/// A point at this height above the middle part of a segment of length 1. The greatest ratio of the length that is
/// allowed below the point and the one of the definition, half the height, for many places of the point.
double greatest_excess_below_a_point(double height) {
  double greatest = 0;
  for (int k = 0; k < 64; ++k) {
    const double x = 0.3 + 0.0061 * k;
    Pslg pslg;
    pslg.points = {{0, 0}, {1, 0}, {x, height}};
    pslg.segments = {{0, 1}};
    const WantedSize wanted(pslg, {.grading = 1, .feature_edges = 2, .convex_hull = true});
    greatest = std::max(greatest, wanted.at({x, 0}) / (height / 2));
  }
  return greatest;
}

TEST(WantedSize, exceeds_the_definition_by_little_unless_a_place_is_much_narrower_than_its_segment) {
  EXPECT_LT(greatest_excess_below_a_point(0x1p-6), 1.135) << "looked at in steps of an eighth of the width";
  const double narrow = greatest_excess_below_a_point(0x1p-13);
  EXPECT_LT(narrow, 1.3) << "looked at in steps of 2^-14 of the segment, half of this width";
  EXPECT_GT(narrow, 1.25);
}

TEST(Findings, that_are_joined_keep_no_more_than_the_limit) {
  const auto with = [](std::vector<Index> ids) {
    Findings found(2);
    for (const Index id : ids) found.add(ViolationKind::overlap, {id}, {}, "");
    return found;
  };
  Findings found = with({1});
  found.append(with({2, 3}));
  found.append(with({4}));
  EXPECT_EQ(found.count(ViolationKind::overlap), 4U);
  std::vector<Index> kept;
  for (const Violation& violation : std::move(found).sorted()) kept.push_back(violation.ids[0]);
  EXPECT_EQ(kept, (std::vector<Index>{1, 2}));
}

TEST(Loop, makes_no_further_step_after_an_exception) {
  std::size_t steps = 0;
  const auto throw_at = [&](std::size_t first) {
    for_each_run(5000, nullptr, [&](std::size_t at, std::size_t, std::size_t) {
      ++steps;
      if (at == first) throw first;
    });
  };
  EXPECT_THROW(throw_at(1024), std::size_t);
  EXPECT_EQ(steps, 2U);
}

/// The triangles with these corners, their neighbours and their boundary.
Adjacency adjacency_of(const std::vector<std::array<Index, 3>>& corners, std::size_t points) {
  Array<Triangle> triangles;
  for (const auto& v : corners) triangles.push_back({v, {no_index, no_index, no_index}});
  std::vector<NonManifoldEdge> none;
  rebuild_neighbours(triangles.span(), none);
  Array<Index> start(points, no_index);
  std::vector<BoundaryEdge> boundary;
  for (Index t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& [v, n] = triangles[t];
      start[v[k]] = t;
      if (n[k] == no_index) boundary.push_back({v[next(k)], v[previous(k)], {t, k}});
    }
  sort_boundary(boundary);
  return {std::move(triangles), std::move(start), std::move(boundary)};
}

TEST(Fans, are_visited_until_the_visitor_answers_no) {
  const Adjacency adjacency = adjacency_of({{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 5, 6}}, 7);
  const auto visited = [&](std::size_t most) {
    std::vector<Index> triangles;
    const int fans = adjacency.visit_fans(0, [&](Index t, int corner) {
      EXPECT_EQ(corner, 0);
      triangles.push_back(t);
      return triangles.size() < most;
    });
    return std::pair(triangles, fans);
  };
  EXPECT_EQ(visited(1), std::pair(std::vector<Index>({0}), 0));
  EXPECT_EQ(visited(3), std::pair(std::vector<Index>({0, 1, 2}), 1));
  EXPECT_EQ(visited(5), std::pair(std::vector<Index>({0, 1, 2, 3}), 2));
}

TEST(Fans, of_an_irregular_vertex_are_visited_once_in_the_order_of_the_triangles) {
  Adjacency adjacency = adjacency_of({{0, 1, 2}, {0, 2, 3}, {3, 4, 5}, {0, 5, 6}, {0, 7, 8}, {0, 8, 9}, {0, 9, 7}}, 10);
  adjacency.count_corners();
  adjacency.index_irregular_vertices();
  std::vector<Index> triangles;
  EXPECT_EQ(adjacency.visit_fans(0, [&](Index t, int) { triangles.push_back(t); }), 1) << "all fans count as one";
  EXPECT_EQ(triangles, std::vector<Index>({0, 1, 3, 4, 5, 6}));
  triangles.clear();
  adjacency.visit_fans(0, [&](Index t, int) {
    triangles.push_back(t);
    return triangles.size() < 4;
  });
  EXPECT_EQ(triangles, std::vector<Index>({0, 1, 3, 4}));
}

TEST(Fans, of_two_vertices_are_compared_in_the_time_of_the_smaller_one) {
  // These comparisons take milliseconds. If each walked around the whole hub, they would exceed the time limit of
  // tests.
  constexpr Index spokes = 400'000;
  std::vector<std::array<Index, 3>> wheel;
  for (Index i = 0; i < spokes; ++i) wheel.push_back({0, 1 + i, 1 + (i + 1) % spokes});
  const Adjacency adjacency = adjacency_of(wheel, spokes + 1);
  for (Index i = 1; i <= spokes; ++i) {
    ASSERT_FALSE(adjacency.has_fewer_triangles(0, i));
    ASSERT_TRUE(adjacency.has_fewer_triangles(i, 0));
  }
}

/// The comparison goes around both vertices in steps of 16, 32, ... triangles.
TEST(Fans, of_two_vertices_are_compared_by_their_numbers_of_triangles) {
  const std::vector<Index> sizes{3, 15, 16, 17, 31, 32, 33, 48, 63, 64, 65, 200};
  std::vector<std::array<Index, 3>> wheels;
  std::vector<Index> hubs;
  Index points = 0;
  for (const Index spokes : sizes) {
    hubs.push_back(points);
    for (Index i = 0; i < spokes; ++i) wheels.push_back({points, points + 1 + i, points + 1 + (i + 1) % spokes});
    points += spokes + 1;
  }
  const Adjacency adjacency = adjacency_of(wheels, points);
  for (std::size_t a = 0; a < hubs.size(); ++a)
    for (std::size_t b = 0; b < hubs.size(); ++b)
      EXPECT_EQ(adjacency.has_fewer_triangles(hubs[a], hubs[b]), sizes[a] < sizes[b]) << sizes[a] << ' ' << sizes[b];
}

TEST(MarkedEdges, that_are_inferred_separate_triangles_that_turn_left) {
  const auto is_marked = [](double y) {
    Mesh mesh;
    mesh.points.append(std::vector<Point>{{0, 0}, {4, 0}, {2, 3}, {2, y}});
    const Adjacency adjacency = adjacency_of({{0, 1, 2}, {1, 0, 3}}, 4);
    const Scan scanned = scan(mesh.points.span(), adjacency.triangles(), {});
    return MarkedEdges(mesh, adjacency, scanned).contains(0, 1);
  };
  EXPECT_TRUE(is_marked(-1)) << "inside the circle";
  EXPECT_FALSE(is_marked(-2)) << "outside the circle";
  EXPECT_FALSE(is_marked(1)) << "inside the circle, but the second triangle turns right";
}

TEST(Domain, allows_each_segment_two_units_of_its_own_ends) {
  Pslg pslg;
  pslg.points = {{0.25, 3}, {-1, 0.5}, {1e20, 1e20}, {0x1p-138, 0x1p-139}};
  pslg.segments = {{0, 1}, {1, 2}, {3, 0}};
  const Domain domain(pslg, false);
  const auto expect = [&](Index segment, double x, double y) {
    EXPECT_EQ(domain.tolerance(segment).x, x);
    EXPECT_EQ(domain.tolerance(segment).y, y);
  };
  expect(0, 0x1p-51, 0x1p-50);
  expect(1, 0x1p15, 0x1p15);
  expect(2, 0x1p-53, 0x1p-50);
  pslg.points[0] = {0, 0};
  expect(2, 0x1p-189, 0x1p-190);
}

TEST(Domain, joins_faces_that_only_segments_outside_of_it_separate) {
  // A square with a square hole, which a segment and a smaller square in it divide.
  Pslg pslg;
  pslg.points = {{0, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 2}, {6, 2}, {6, 6}, {2, 6}, {3, 3}, {4, 3}, {4, 4}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {5, 7}, {8, 9}, {9, 10}, {10, 8}};
  pslg.holes = {{2.5, 2.25}, {5.5, 5.5}, {3.75, 3.5}};
  const Domain domain(pslg, false);
  const std::vector<Index> place = domain.places_of_faces();
  const auto of = [&](Point p) { return place[domain.faces().face_at(p)]; };
  EXPECT_EQ(of({2.5, 2.25}), of({5.5, 5.5}));
  EXPECT_EQ(of({2.5, 2.25}), of({3.75, 3.5}));
  EXPECT_NE(of({2.5, 2.25}), of({1, 1}));
  EXPECT_NE(of({2.5, 2.25}), of({9, 9}));
  EXPECT_EQ(of({9, 9}), PlanarFaces::exterior());
}

TEST(Domain, has_edges_of_the_hull_without_markers) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {0, 1}};
  pslg.segments = {{0, 1, 7}};
  const Domain domain(pslg, true);
  ASSERT_EQ(domain.segments().size(), 3U);
  EXPECT_EQ(domain.segments()[0].marker, 7);
  for (const Index piece : {1U, 2U}) {
    EXPECT_TRUE(domain.is_hull_piece(piece));
    EXPECT_EQ(domain.segments()[piece].marker, 0);
  }
}

}  // namespace
}  // namespace pardel::checker
