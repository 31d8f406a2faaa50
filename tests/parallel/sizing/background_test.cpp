#include "../../../parallel/sizing/background.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../../../parallel/arithmetic/distance.hpp"
#include "../../../parallel/arithmetic/predicates.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

Background background_of(const samples::Sample& sample) {
  std::vector<std::array<Index, 3>> triangles;
  for (const Slot& slot : sample.triangulation.slots) triangles.push_back(slot.v);
  return {sample.triangulation.points.span(), std::move(triangles)};
}

TEST(Background, interpolates_a_linear_function_exactly_up_to_rounding) {
  const samples::Sample sample = samples::triangulated(samples::lattice_points(9));
  const Background background = background_of(sample);
  std::vector<double> value;
  for (const Point p : sample.triangulation.points) value.push_back(5 * p.x - 3 * p.y + 1);
  samples::Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Point p{random.uniform(0, 8), random.uniform(0, 8)};
    EXPECT_NEAR(background.interpolate(p, value), 5 * p.x - 3 * p.y + 1, 1e-12);
  }
}

/// Corners of very different magnitudes, and points in a triangle up to rounding.
TEST(Background, interpolates_between_the_values_at_the_corners_however_far_they_are) {
  samples::Random random(4);
  const auto corner = [&] {
    return Point{std::ldexp(random.uniform(-1, 1), random.between(0, 60)),
                 std::ldexp(random.uniform(-1, 1), random.between(0, 60))};
  };
  int triangles = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::array<Point, 3> c{corner(), corner(), corner()};
    if (orient2d(c[0], c[1], c[2]) <= 0) continue;
    ++triangles;
    const Background background(c, {{0, 1, 2}});
    const double f = random.uniform(0, 1), g = random.uniform(0, 1 - f), h = 1 - f - g;
    const Point p{f * c[0].x + g * c[1].x + h * c[2].x, f * c[0].y + g * c[1].y + h * c[2].y};
    const std::array<double, 3> ones{1, 1, 1};
    EXPECT_NEAR(background.interpolate(p, ones), 1, 1e-11);
  }
  EXPECT_GT(triangles, 2000);
}

/// Their area is 0 in doubles, or nearly.
TEST(Background, interpolates_in_flat_triangles) {
  samples::Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const double x = random.uniform(1, 2), y = random.uniform(1, 2);
    const std::array<Point, 3> c{Point{0, 0}, {x, y}, {x / 2, std::nextafter(y / 2, 2)}};
    const Background background(c, {{0, 1, 2}});
    const std::array<double, 3> ones{1, 1, 1};
    for (const double share : {0.25, 0.3, 0.5, 0.75})
      EXPECT_NEAR(background.interpolate({share * x, share * y}, ones), 1, 1e-11);
  }
}

TEST(Background, knows_how_fast_a_field_changes) {
  const samples::Sample sample = samples::triangulated(samples::uniform_points(300, 9));
  const Background background = background_of(sample);
  const Triangulation& t = sample.triangulation;
  samples::Random random(10);
  std::vector<double> value(t.points.size());
  for (double& v : value) v = random.uniform(1, 2);
  const auto [slope, blur] = background.steepness(value);
  for (const Slot& slot : t.slots)
    for (int i = 0; i < 50; ++i) {
      const auto inside = [&] {
        const double f = random.uniform(0, 0.5), g = random.uniform(0, 0.5);
        const Point a = t.points[slot.v[0]], b = t.points[slot.v[1]], c = t.points[slot.v[2]];
        return Point{a.x + f * (b.x - a.x) + g * (c.x - a.x), a.y + f * (b.y - a.y) + g * (c.y - a.y)};
      };
      const Point p = inside(), q = inside();
      const double change = std::abs(background.interpolate(p, value) - background.interpolate(q, value));
      ASSERT_LE(change, slope * distance(p, q) + blur);
    }
  for (Index v = 0; v < value.size(); ++v) value[v] = 3 * t.points[v].x + 4 * t.points[v].y;
  EXPECT_NEAR(background.steepness(value).slope, 5, 0.01);
}

/// Two squares on a bar, with a slot between them: the nearest point jumps from one side of the slot to the other.
TEST(Background, knows_how_fast_a_field_changes_only_if_it_is_convex) {
  std::vector<Point> points;
  for (int k = 0; k < 12; ++k) points.push_back({double(k % 4), double(k / 4)});
  std::vector<std::array<Index, 3>> triangles;
  for (const Index low : {0U, 1U, 2U, 4U, 6U}) {
    triangles.push_back({low, low + 1, low + 5});
    triangles.push_back({low, low + 5, low + 4});
  }
  const std::vector<double> values(points.size(), 1);
  EXPECT_EQ(Background(points, triangles).steepness(values).slope, INFINITY);
  triangles.push_back({5, 6, 10});
  EXPECT_EQ(Background(points, triangles).steepness(values).slope, INFINITY);
  triangles.push_back({5, 10, 9});
  EXPECT_EQ(Background(points, triangles).steepness(values).slope, 0) << "the slot is filled";
  triangles.erase(triangles.begin() + 2, triangles.begin() + 4);
  EXPECT_EQ(Background(points, triangles).steepness(values).slope, INFINITY) << "a notch in the border";
}

TEST(Background, does_not_know_how_fast_a_field_changes_in_a_flat_triangle) {
  const Background background(std::vector<Point>{{0, 0}, {1, 0}, {0.5, 1e-11}, {0.5, 1}},
                              {{{0, 1, 2}}, {{1, 3, 2}}, {{3, 0, 2}}});
  EXPECT_EQ(background.steepness(std::vector<double>{1, 1, 1, 1}).slope, INFINITY);
}

TEST(Background, gives_the_value_of_a_vertex_at_the_vertex) {
  const samples::Sample sample = samples::triangulated(samples::uniform_points(300, 2));
  const Background background = background_of(sample);
  std::vector<double> value(300);
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = static_cast<double>(i);
  for (std::size_t i = 0; i < value.size(); ++i)
    EXPECT_NEAR(background.interpolate(sample.triangulation.points[i], value), value[i], 1e-6);
}

TEST(Background, finds_a_triangle_that_contains_the_point) {
  const samples::Sample sample = samples::triangulated(samples::uniform_points(500, 3));
  const Background background = background_of(sample);
  const Triangulation& t = sample.triangulation;
  samples::Random random(4);
  for (int i = 0; i < 5000; ++i) {
    const auto& v = t.slots[random.below(t.slots.size())].v;
    const double f = random.uniform(0, 0.5), g = random.uniform(0, 0.5);
    const Point a = t.points[v[0]], b = t.points[v[1]], c = t.points[v[2]];
    const Point p{a.x + f * (b.x - a.x) + g * (c.x - a.x), a.y + f * (b.y - a.y) + g * (c.y - a.y)};
    const Located at = background.locate(p);
    EXPECT_EQ(at.v, t.slots[at.triangle].v) << "triangles keep their numbers";
    Point q{0, 0};
    double sum = 0;
    for (unsigned k = 0; k < 3; ++k) {
      EXPECT_GE(at.weight[k], 0);
      sum += at.weight[k];
      q.x += at.weight[k] * t.points[at.v[k]].x;
      q.y += at.weight[k] * t.points[at.v[k]].y;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_NEAR(q.x, p.x, 1e-12);
    EXPECT_NEAR(q.y, p.y, 1e-12);
  }
}

TEST(Background, uses_the_nearest_point_of_the_triangulation_for_a_point_outside_it) {
  const samples::Sample sample = samples::triangulated({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Background background = background_of(sample);
  const std::vector<double> x{0, 4, 4, 0}, y{0, 0, 4, 4};
  EXPECT_EQ(background.interpolate({3, -1}, x), 3);
  EXPECT_EQ(background.interpolate({3, -1}, y), 0);
  EXPECT_EQ(background.interpolate({9, 9}, x), 4);
  EXPECT_EQ(background.interpolate({9, 9}, y), 4);
  EXPECT_EQ(background.interpolate({-5, 1}, x), 0);
  EXPECT_EQ(background.interpolate({-5, 1}, y), 1);
}

TEST(Background, of_slivers_interpolates_within_the_values_of_their_corners) {
  const samples::Family nearly_collinear = samples::families(60, 5)[4];
  const samples::Sample sample = samples::triangulated(nearly_collinear.points);
  const Background background = background_of(sample);
  std::vector<double> value;
  for (const Point p : sample.triangulation.points) value.push_back(p.x);
  samples::Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const double v = background.interpolate({random.uniform(-1, 2), random.uniform(-1, 8)}, value);
    EXPECT_TRUE(v >= -1e-12 && v <= 1 + 1e-12) << v;
  }
}

/// Bit for bit.
bool same_place(const Located& a, const Located& b) {
  return a.triangle == b.triangle && a.v == b.v && a.weight == b.weight;
}

/// Points in triangles, exactly on edges and corners, and outside.
TEST(Background, gives_the_same_answer_for_every_hint) {
  for (const bool lattice : {true, false}) {
    const samples::Sample sample =
        samples::triangulated(lattice ? samples::lattice_points(9) : samples::uniform_points(200, 7));
    const Background background = background_of(sample);
    const auto triangles = static_cast<Index>(sample.triangulation.slots.size());
    samples::Random random(8);
    for (int i = 0; i < 300; ++i) {
      Point p{random.uniform(-1, 9), random.uniform(-1, 9)};
      if (i % 3 == 0) p = {std::round(p.x), p.y};
      if (i % 3 == 1) p = {std::round(2 * p.x) / 2, std::round(2 * p.y) / 2};
      const Located expected = background.locate(p);
      for (Index leaf = 0; leaf < triangles; leaf += 5) {
        LocationHint hint{leaf};
        EXPECT_TRUE(same_place(background.locate(p, hint), expected)) << p.x << ' ' << p.y << " from " << leaf;
        EXPECT_TRUE(same_place(background.locate(p, hint), expected)) << "from the last answer";
      }
    }
  }
}

/// The walk cannot cross a hole. Then the hierarchy finds the triangle.
TEST(Background, finds_points_beyond_a_hole) {
  // The ring between the squares of sides 3 and 1.
  const std::vector<Point> points{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  const Background background(points,
                              {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6}, {3, 7, 6}, {3, 0, 7}, {0, 4, 7}});
  LocationHint hint;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(background.locate({0.5, 1.5}, hint).triangle, 6U);
    EXPECT_EQ(background.locate({2.5, 1.4}, hint).triangle, 2U);
    EXPECT_EQ(background.locate({1.4, 0.5}, hint).triangle, 0U);
    EXPECT_EQ(background.locate({1.6, 2.5}, hint).triangle, 4U);
  }
}

TEST(Background, of_one_triangle_works) {
  const Background background(std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  EXPECT_EQ(background.locate({0.25, 0.25}).triangle, 0U);
  EXPECT_EQ(background.locate({7, 7}).triangle, 0U);
}

/// Twice the area is exactly 1e-10 of the squared longest side.
TEST(Background, does_not_know_how_fast_a_field_changes_in_a_triangle_that_is_just_too_thin) {
  const std::vector<std::array<Index, 3>> triangle{{0, 1, 2}};
  const std::vector<double> values{1, 1, 1};
  EXPECT_EQ(Background(std::vector<Point>{{0, 0}, {1, 0}, {0.5, 1e-10}}, triangle).steepness(values).slope, INFINITY);
  EXPECT_EQ(Background(std::vector<Point>{{0, 0}, {1, 0}, {0.5, 1.01e-10}}, triangle).steepness(values).slope, 0);
}

/// Twice the area is positive, but rounded to 0, by which no weight may be divided.
TEST(Background, interpolates_in_a_triangle_whose_area_is_rounded_to_zero) {
  const std::vector<Point> points{{0, 0}, {1.5, 2}, {4.1999999999999993, 5.5999999999999996}};
  const Point inside{1.5029999999999999, 2.004};
  const Background background(points, {{0, 1, 2}});
  const Located at = background.locate(inside);
  EXPECT_EQ(at.triangle, 0U);
  for (const double weight : at.weight) EXPECT_TRUE(weight >= 0 && weight <= 1) << weight;
  EXPECT_NEAR(background.interpolate(inside, std::vector<double>{0, 1.5, 4.1999999999999993}), inside.x, 1e-12);
}

TEST(Background, begins_a_search_beside_the_point_if_the_hint_is_beyond_a_gap) {
  for (const Point to : {Point{5, 0}, Point{0, 5}, Point{5, -5}}) {
    const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, to, {to.x + 1, to.y}, {to.x, to.y + 1}};
    const Background background(points, {{0, 1, 2}, {3, 4, 5}});
    for (const Point p : {Point{0.25, 0.25}, Point{to.x + 0.25, to.y + 0.25}}) {
      LocationHint first{0}, second{1};
      EXPECT_TRUE(same_place(background.locate(p, first), background.locate(p, second)));
      EXPECT_EQ(first.leaf, second.leaf) << "the hint is then the triangle of the point";
    }
  }
}

TEST(Background, prefers_the_lesser_corners_of_two_triangles_at_the_same_distance) {
  const std::vector<Point> points{{-2, 0}, {-1, -1}, {-1, 1}, {2, 0}, {1, 1}, {1, -1}};
  const Located left = Background(points, {{0, 1, 2}, {3, 4, 5}}).locate({0, 0});
  EXPECT_EQ(left.v, (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(left.weight, (std::array<double, 3>{0, 0.5, 0.5}));
  EXPECT_EQ(Background(points, {{3, 4, 5}, {0, 1, 2}}).locate({0, 0}).v, left.v);
}

struct DividedSquares {
  [[nodiscard]] std::array<Point, 3> corners_at(Point p) const {
    const Located at = background.locate(p);
    return {points[at.v[0]], points[at.v[1]], points[at.v[2]]};
  }
  std::vector<Point> points;
  Background background;
};

/// The unit squares in a rectangle, each divided into two triangles.
DividedSquares divided_squares(int left, int low, int right, int high) {
  std::vector<Point> points;
  for (int y = low; y <= high; ++y)
    for (int x = left; x <= right; ++x) points.push_back({1.0 * x, 1.0 * y});
  std::vector<std::array<Index, 3>> triangles;
  const auto columns = static_cast<Index>(right - left + 1);
  for (Index v = 0; v + columns < points.size(); ++v) {
    if (v % columns == columns - 1) continue;
    triangles.push_back({v, v + 1, v + columns + 1});
    triangles.push_back({v, v + columns + 1, v + columns});
  }
  return {points, Background(points, std::move(triangles))};
}

/// The order of the triangles along the curve changes with the rectangle.
TEST(Background, prefers_the_same_triangle_whatever_lies_farther_away) {
  const DividedSquares few = divided_squares(0, 0, 4, 4);
  for (const DividedSquares& many : {divided_squares(-9, 0, 4, 13), divided_squares(0, -5, 9, 4)})
    for (int y = 1; y < 16; ++y)
      for (int x = 1; x < 16; ++x) {
        const Point p{0.25 * x, 0.25 * y};
        EXPECT_EQ(few.corners_at(p), many.corners_at(p)) << p.x << ' ' << p.y;
      }
}

TEST(Background, interpolates_in_flat_triangles_along_the_first_of_the_nearest_sides) {
  const std::array<double, 3> weight =
      Background(std::vector<Point>{{0, 0}, {2, 0}, {1, 0}}, {{0, 1, 2}}).locate({0.5, 1}).weight;
  EXPECT_EQ(weight, (std::array{0.75, 0.25, 0.0}));
  for (const std::array<Index, 3> corners : {std::array<Index, 3>{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}) {
    const Background doubled(std::vector<Point>{{0, 0}, {0, 0}, {2, 0}}, {corners});
    EXPECT_EQ(doubled.interpolate({0.5, 1}, std::vector<double>{0, 0, 2}), 0.5);
  }
}

/// The sides have the lengths 3, 4 and 5.
TEST(Background, knows_if_a_point_is_near) {
  const Background background(std::vector<Point>{{0, 0}, {3, 0}, {0, 4}}, {{0, 1, 2}});
  const auto is_near = [&](Point p) { return background.is_near(background.locate(p), p); };
  EXPECT_TRUE(is_near({1, 1}));
  for (const auto& [near, far] : {std::pair(Point{-5, 2}, Point{std::nextafter(-5.0, -6.0), 2}),
                                  {Point{1, -5}, Point{1, std::nextafter(-5.0, -6.0)}},
                                  {Point{-3, -4}, Point{-3.001, -4}},
                                  {Point{5.49, 4.99}, Point{5.51, 5.01}}}) {
    EXPECT_TRUE(is_near(near)) << near.x << ' ' << near.y;
    EXPECT_FALSE(is_near(far)) << far.x << ' ' << far.y;
  }
}

}  // namespace
}  // namespace pardel::engine
