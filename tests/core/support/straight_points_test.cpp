#include "../../../core/support/straight_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace pardel {
namespace {

/// Exact for small integers.
bool is_on_line(std::span<const Point> points, std::span<const Index> path) {
  const Point a = points[path.front()], b = points[path.back()];
  return std::ranges::all_of(
      path, [&](Index v) { return (b.x - a.x) * (points[v].y - a.y) == (b.y - a.y) * (points[v].x - a.x); });
}

std::vector<bool> straight(const std::vector<Point>& points, const std::vector<Segment>& segments) {
  return straight_points(points, segments, [&](std::span<const Index> path) { return is_on_line(points, path); });
}

TEST(StraightPoints, lie_on_a_line_with_both_neighbours) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {3, 1}, {4, 2}, {4, 3}};
  std::vector<Segment> segments;
  for (Index v = 0; v + 1 < points.size(); ++v) segments.push_back({v, v + 1});
  EXPECT_EQ(straight(points, segments), (std::vector<bool>{false, true, false, true, false, false}));
}

TEST(StraightPoints, have_exactly_two_segments) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {1, 1}};
  EXPECT_EQ(straight(points, {{0, 1}, {1, 2}}), (std::vector<bool>{false, true, false, false}));
  EXPECT_EQ(straight(points, {{0, 1}, {1, 2}, {1, 3}}), std::vector<bool>(4, false));
  EXPECT_EQ(straight(points, {{0, 1}, {1, 1}, {2, 1}}), (std::vector<bool>{false, true, false, false}))
      << "a segment without length does not count";
  EXPECT_EQ(straight(points, {{0, 1}, {1, 0}}), std::vector<bool>(4, false)) << "the same segment twice";
}

TEST(StraightPoints, of_a_ring_do_not_depend_on_numbers_and_directions) {
  std::vector<Point> ring;
  for (int i = 0; i < 4; ++i) ring.push_back({double(i), 0});
  for (int i = 0; i < 4; ++i) ring.push_back({4, double(i)});
  for (int i = 0; i < 4; ++i) ring.push_back({4.0 - i, 4.0 - i});
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    std::vector<Index> number(ring.size());
    for (Index i = 0; i < number.size(); ++i) number[i] = i;
    std::ranges::shuffle(number, random);
    std::vector<Point> points(ring.size());
    std::vector<Segment> segments;
    for (Index i = 0; i < ring.size(); ++i) {
      points[number[i]] = ring[i];
      const Index next = number[(i + 1) % ring.size()];
      segments.push_back(random() % 2 == 0 ? Segment{number[i], next} : Segment{next, number[i]});
    }
    std::ranges::shuffle(segments, random);
    const std::vector<bool> found = straight(points, segments);
    for (Index i = 0; i < ring.size(); ++i) EXPECT_EQ(found[number[i]], i % 4 != 0) << i;
  }
}

/// Divided point by point at the farthest one, such paths would take a time that grows with the square of their length.
TEST(StraightPoints, of_long_paths_are_found_fast) {
  constexpr int n = 200'000;
  for (const bool zigzags : {false, true}) {
    std::vector<Point> points;
    std::vector<Segment> segments;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      points.push_back(zigzags ? Point{double(i), (i % 2) * std::exp(-i * 1e-3)}
                               : Point{std::cos(angle), std::sin(angle)});
      if (i > 0) segments.push_back({static_cast<Index>(i - 1), static_cast<Index>(i)});
    }
    std::size_t visited = 0;
    const std::vector<bool> found = straight_points(points, segments, [&](std::span<const Index> path) {
      visited += path.size();
      return is_on_line(points, path);
    });
    EXPECT_LT(visited, std::size_t{80} * n);
  }
}

}  // namespace
}  // namespace pardel
