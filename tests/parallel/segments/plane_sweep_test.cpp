// The sweep of the plane on small inputs, and its work on families of inputs in which the boxes around most pairs of
// segments overlap.
#include "../../../parallel/segments/plane_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "../shapes.hpp"

namespace pardel::engine {
namespace {

using testing::add_polygon;
using testing::add_square;
using testing::square;

Swept swept(const Pslg& pslg, const std::vector<Point>& queries = {}) {
  return sweep_plane({.points = pslg.points, .segments = pslg.segments, .queries = queries});
}

TEST(PlaneSweep, finds_the_segment_through_a_place) {
  const std::vector<Index> through = swept(square(2), {{2, 1}, {1, 2}, {1, 1}, {2, 2.5}, {2, 2}, {0, 0}}).through;
  EXPECT_EQ(through[0], 1);
  EXPECT_EQ(through[1], 2);
  EXPECT_EQ(through[2], no_index);
  EXPECT_EQ(through[3], no_index);
  EXPECT_NE(through[4], no_index);  // two segments end there
  EXPECT_NE(through[5], no_index);  // two segments begin there
}

TEST(PlaneSweep, finds_the_highest_segment_below_including_left_ends_but_not_right_ends) {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {0, 1}, {2, 2}, {4, 1}};
  pslg.segments = {{0, 1}, {2, 3}, {4, 3}};
  const std::vector<Point> places{{1, 3}, {3, 3}, {2, 3}, {1, 1}, {1, -1}, {0, 3}, {4, 3}, {5, 3}};
  const std::vector<Index> below = swept(pslg, places).below;
  EXPECT_EQ(std::vector<Index>(below.begin() + 5, below.end()),
            (std::vector<Index>{1, 2, 2, 0, no_index, 1, no_index, no_index}));
  EXPECT_EQ(below[3], 0);  // point 3
}

TEST(PlaneSweep, locates_places_above_and_left_of_vertical_segments) {
  Pslg pslg;
  pslg.points = {{1, 3}, {1, 0}, {1, 5}};
  pslg.segments = {{0, 1}};
  const std::vector<Index> below = swept(pslg, {{1, 4}, {1, -1}, {0.5, 2}, {1.5, 2}}).below;
  EXPECT_EQ(std::vector<Index>(below.begin() + 3, below.end()), std::vector<Index>(4, no_index));
}

TEST(PlaneSweep, ends_when_it_has_found_enough) {
  Pslg pslg;
  for (int i = 0; i < 10; ++i) {
    add_polygon(pslg, {{0.0, i + 0.1}, {10.0, i + 0.2}, {10.0, i + 0.3}});
    add_polygon(pslg, {{i + 0.1, 0.0}, {i + 0.2, 10.0}, {i + 0.3, 10.0}});
  }
  EXPECT_EQ(sweep_plane({.points = pslg.points, .segments = pslg.segments, .most = 7}).conflicts.size(), 7);
  EXPECT_GT(swept(pslg).conflicts.size(), 300);
}

TEST(PlaneSweep, finds_crossings_at_one_place_whether_or_not_a_point_lies_there) {
  for (const bool with_query : {false, true}) {
    Pslg pslg;
    for (int i = 0; i < 8; ++i) {
      pslg.points.insert(pslg.points.end(), {{-8, 1.0 * i - 4}, {8, 4 - 1.0 * i}});
      pslg.segments.push_back({static_cast<Index>(2 * i), static_cast<Index>(2 * i + 1)});
    }
    const std::vector<Point> at_crossing = with_query ? std::vector<Point>{{0, 0}} : std::vector<Point>{};
    EXPECT_EQ(swept(pslg, at_crossing).conflicts.size(), 8 * 7 / 2);
  }
}

/// The places are 0.95 times the reach away from a segment at 45 degrees.
TEST(PlaneSweep, finds_the_places_near_a_segment_in_any_unit_of_length) {
  for (const double unit : {0x1p-30, 0.01, 1.0, 100.0, 0x1p40}) {
    Pslg pslg;
    pslg.points = {{-8 * unit, -8 * unit}, {8 * unit, 8 * unit}};
    pslg.segments = {{0, 1}};
    const Reach reach(std::sqrt(2.0) * unit, pslg.points, pslg.segments);
    const std::vector<Point> places{
        {-0.95 * unit, 0.95 * unit}, {0.95 * unit, -0.95 * unit}, {-1.05 * unit, 1.05 * unit}};
    const SweepInput input{.points = pslg.points, .segments = pslg.segments, .queries = places, .reach = &reach};
    EXPECT_EQ(sweep_plane(input).near, (std::vector<NearPoint>{{2, 0}, {3, 0}})) << unit;
  }
}

/// The directions to the ends are (0, -1) and (c, d) with c^2 = 3 d^2 + 1. So the angle between them, whose cosine is
/// -d / sqrt(c^2 + d^2), is less than 120 degrees, by so little that rounding hides it.
TEST(PlaneSweep, finds_places_that_see_a_segment_at_more_than_120_degrees_only) {
  constexpr double c = 189750626, d = 109552575;
  for (const bool turned : {false, true}) {
    const auto placed = [&](double x, double y) { return turned ? Point{-x, -y} : Point{x, y}; };
    const std::vector<Point> points{placed(0, -1), placed(c, d)};
    const std::vector<Segment> segments{{0, 1}};
    const auto is_near = [&](double y) {
      const std::vector<Point> places{placed(0, y)};
      const Reach reach(2, points, segments);
      return !sweep_plane({.points = points, .segments = segments, .queries = places, .reach = &reach}).near.empty();
    };
    EXPECT_FALSE(is_near(0));
    EXPECT_FALSE(is_near(0.5)) << "a smaller angle";
    EXPECT_TRUE(is_near(-0.5)) << "a larger angle";
  }
}

TEST(PlaneSweep, locates_a_place_straight_above_a_crossing_on_an_axis) {
  Pslg pslg;
  pslg.points = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};
  pslg.segments = {{0, 1}, {2, 3}};
  const Swept found = swept(pslg, {{0, 0.5}, {0, -0.5}});
  EXPECT_EQ(found.below[4], 0U) << "the segment that is higher on the right of the crossing";
  EXPECT_EQ(found.below[5], no_index);
  EXPECT_EQ(found.conflicts.size(), 1U);
}

Point on_circle(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Pslg spokes(int n) {
  Pslg pslg;
  pslg.points.push_back({0, 0});
  for (int i = 0; i < n; ++i) {
    pslg.points.push_back(on_circle(1, 1.0 * i / n));
    pslg.segments.push_back({0, static_cast<Index>(i + 1)});
  }
  return pslg;
}

Pslg star(int n) {
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) corners.push_back(on_circle(i % 2 == 0 ? 1 : 0.25, 1.0 * i / n));
  Pslg pslg;
  add_polygon(pslg, corners);
  return pslg;
}

Pslg nested_outlines(int n) {
  Pslg pslg;
  for (int k = 0; k < n / 4; ++k) {
    std::vector<Point> corners;
    for (int i = 0; i < 4; ++i) corners.push_back(on_circle(1 + 4.0 * k / n, 0.05 + 0.25 * i));
    add_polygon(pslg, corners);
  }
  return pslg;
}

Pslg long_slanted_segments(int n) {
  Pslg pslg;
  for (int i = 0; i < n; ++i) {
    pslg.points.insert(pslg.points.end(), {{0, 1.0 * i / n}, {1, 1 + 1.0 * i / n}});
    pslg.segments.push_back({static_cast<Index>(2 * i), static_cast<Index>(2 * i + 1)});
  }
  return pslg;
}

/// A rotated grid in which most lines end in the interior of others: about n conflicts.
Pslg rotated_t_junctions(int n) {
  const auto side = static_cast<int>(std::sqrt(n));
  const auto rotated = [](double x, double y) { return Point{3 * x - 4 * y, 4 * x + 3 * y}; };
  Pslg pslg;
  const auto add = [&](Point a, Point b) {
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {a, b});
    pslg.segments.push_back({first, first + 1});
  };
  for (int i = 0; i < side; ++i) {
    add(rotated(0, i), rotated(side, i));
    for (int j = 0; j < side; ++j) add(rotated(j + 0.5, i), rotated(j + 0.5, i + 0.75));
  }
  return pslg;
}

/// Chords of a circle between random points: about m^2 / 6 = n crossings for m chords.
Pslg crossing_chords(int n) {
  std::mt19937 random(7);
  const auto anywhere = [&] { return on_circle(1, static_cast<double>(random()) * 0x1p-32); };
  Pslg pslg;
  for (Index i = 0; i * i / 6.0 < n; ++i) {
    pslg.points.insert(pslg.points.end(), {anywhere(), anywhere()});
    pslg.segments.push_back({2 * i, 2 * i + 1});
  }
  return pslg;
}

/// The sweep ends at the first point, because two segments overlap there. Until then it has only put the segments at
/// this point into their order.
TEST(WorkOfThePlaneSweep, includes_the_comparisons_of_segments_at_one_point) {
  for (const Index n : {2U, 3U, 8U, 50U}) {
    Pslg pslg;
    pslg.points = {{0, 0}};
    for (Index i = 0; i < n; ++i) {
      pslg.points.push_back({1, static_cast<double>(i)});
      pslg.segments.push_back({0, i + 1});
    }
    pslg.points.push_back({2, 2});
    pslg.segments.push_back({0, n + 1});
    const Swept found = sweep_plane({.points = pslg.points, .segments = pslg.segments, .most = 1});
    EXPECT_EQ(found.conflicts.size(), 1U);
    EXPECT_GE(found.orientations, n) << "no order of n + 1 segments takes fewer";
  }
}

/// n: segments or crossings. `per_item`: the orientations that one of them may take.
void expect_nearly_linear_work(Pslg (*family)(int), double per_item) {
  constexpr int n = 4000;
  const auto small = static_cast<double>(swept(family(n)).orientations);
  const auto large = static_cast<double>(swept(family(4 * n)).orientations);
  EXPECT_LT(small, per_item * n);
  EXPECT_LT(large, 1.3 * 4 * small);  // n log n grows by a factor of 4.7
}

TEST(WorkOfThePlaneSweep, is_nearly_linear_for_spokes_at_one_vertex) { expect_nearly_linear_work(spokes, 60); }
TEST(WorkOfThePlaneSweep, is_nearly_linear_for_a_star) { expect_nearly_linear_work(star, 60); }
TEST(WorkOfThePlaneSweep, is_nearly_linear_for_nested_outlines) { expect_nearly_linear_work(nested_outlines, 60); }
TEST(WorkOfThePlaneSweep, is_nearly_linear_for_long_slanted_segments) {
  expect_nearly_linear_work(long_slanted_segments, 60);
}
TEST(WorkOfThePlaneSweep, is_nearly_linear_for_t_junctions_in_a_rotated_grid) {
  expect_nearly_linear_work(rotated_t_junctions, 60);
}
TEST(WorkOfThePlaneSweep, is_nearly_linear_in_the_number_of_crossings) {
  expect_nearly_linear_work(crossing_chords, 20);
  EXPECT_GT(swept(crossing_chords(4000)).conflicts.size(), 3000);
}

}  // namespace
}  // namespace pardel::engine
