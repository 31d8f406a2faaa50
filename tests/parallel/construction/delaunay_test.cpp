// Compares the triangulation of points with the definition: no point lies strictly inside the circumcircle of a
// triangle.
#include "../../../parallel/construction/delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

/// The corners of a triangle in counter-clockwise order, starting with the lexicographically least corner. They do not
/// depend on the numbering of vertices.
using Corners = std::array<std::pair<double, double>, 3>;

std::vector<Corners> triangles_of(const Triangulation& t) {
  std::vector<Corners> result;
  for (const Slot& slot : t.slots) {
    if (slot.is_ghost()) continue;
    Corners c;
    for (unsigned i = 0; i < 3; ++i) c[i] = {t.points[slot.v[i]].x, t.points[slot.v[i]].y};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    result.push_back(c);
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_empty_circles(const Triangulation& t) {
  for (const Slot& slot : t.slots) {
    if (slot.is_ghost()) continue;
    for (const Point p : t.points)
      ASSERT_LE(checker::exactly::in_circle(t.points[slot.v[0]], t.points[slot.v[1]], t.points[slot.v[2]], p), 0);
  }
}

/// All points lie on the inner side of every hull edge, and none in the interior of a hull edge.
void expect_convex_hull(const Triangulation& t) {
  for (const Slot& slot : t.slots) {
    if (!slot.is_ghost()) continue;
    const unsigned corner = slot.corner_of(ghost);
    const Point a = t.points[slot.from(corner)], b = t.points[slot.to(corner)];
    for (const Point p : t.points) {
      const int side = checker::exactly::orientation(a, b, p);
      ASSERT_LE(side, 0);
      const bool between = checker::exactly::progress(a, p, a, b) > 0 && checker::exactly::progress(p, b, a, b) > 0;
      ASSERT_FALSE(side == 0 && between);
    }
  }
}

void expect_delaunay(const std::vector<Point>& points, int threads = 1, std::size_t per_tile = points_per_tile) {
  const Result<Delaunay> made = delaunay(points, threads, per_tile);
  ASSERT_TRUE(made) << made.error().message;
  const Triangulation& t = made->triangulation;
  ASSERT_EQ(samples::fault(t), "");
  // Euler's formula on the sphere, where the vertex at infinity counts as a vertex: F = 2 V - 4.
  EXPECT_EQ(t.slots.size(), 2 * (points.size() + 1) - 4);
  ASSERT_EQ(t.points.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v) EXPECT_EQ(t.points[v], points[made->input_of_vertex[v]]);
  expect_empty_circles(t);
  expect_convex_hull(t);
}

TEST(Delaunay, satisfies_the_definition_for_points_in_any_position) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const samples::Family& family : samples::families(120, seed)) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      expect_delaunay(family.points);
    }
}

TEST(Delaunay, satisfies_the_definition_when_tiles_are_triangulated_concurrently) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const samples::Family& family : samples::families(200, seed))
      for (const std::size_t per_tile : {1U, 5U, 20U}) {
        SCOPED_TRACE(family.name + ", seed " + std::to_string(seed) + ", per tile " + std::to_string(per_tile));
        expect_delaunay(family.points, 3, per_tile);
      }
}

TEST(Delaunay, gives_the_same_numbering_on_any_number_of_threads) {
  for (const samples::Family& family : samples::families(20'000, 10)) {
    const Result<Delaunay> expected = delaunay(family.points, 1, 300);
    ASSERT_TRUE(expected) << family.name;
    for (const int threads : {2, 3, 8}) {
      const Result<Delaunay> made = delaunay(family.points, threads, 300);
      ASSERT_TRUE(made) << family.name;
      EXPECT_EQ(made->input_of_vertex, expected->input_of_vertex) << family.name;
      const auto& slots = made->triangulation.slots;
      EXPECT_TRUE(std::equal(slots.begin(), slots.end(), expected->triangulation.slots.begin(),
                             [](const Slot& a, const Slot& b) { return a.v == b.v && a.n == b.n; }))
          << family.name << ", " << threads << " threads";
    }
  }
}

TEST(Delaunay, satisfies_the_definition_for_three_to_ten_points) {
  Random random(4);
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Point> points = samples::lattice_points(4);
    random.shuffle(points);
    points.resize(3 + random.below(8));
    const bool flat = std::all_of(points.begin(), points.end(),
                                  [&](Point p) { return checker::exactly::orientation(points[0], points[1], p) == 0; });
    if (!flat) expect_delaunay(points);
  }
}

TEST(Delaunay, is_locally_delaunay_everywhere_for_many_points) {
  for (const samples::Family& family : samples::families(20'000, 9)) {
    const Result<Delaunay> made = delaunay(family.points);
    ASSERT_TRUE(made) << family.name << ": " << made.error().message;
    EXPECT_EQ(samples::fault(made->triangulation), "") << family.name;
    EXPECT_EQ(made->triangulation.slots.size(), 2 * family.points.size() - 2) << family.name;
  }
}

/// Tiles change the sequence of the insertions, and cocircular points have several Delaunay triangulations.
TEST(Delaunay, does_not_depend_on_the_tiles) {
  for (const samples::Family& family : samples::families(3'000, 12)) {
    const Result<Delaunay> one_tile = delaunay(family.points, 1, 1'000'000);
    ASSERT_TRUE(one_tile) << family.name;
    for (const std::size_t per_tile : {1U, 7U, 100U}) {
      const Result<Delaunay> tiles = delaunay(family.points, 2, per_tile);
      ASSERT_TRUE(tiles) << family.name;
      EXPECT_EQ(triangles_of(one_tile->triangulation), triangles_of(tiles->triangulation)) << family.name << per_tile;
    }
  }
}

/// The points include cocircular points, which have several Delaunay triangulations. The order of insertion depends
/// only on coordinates.
TEST(Delaunay, does_not_depend_on_the_order_of_the_points) {
  Random random(5);
  for (const samples::Family& family : samples::families(500, 6)) {
    const Result<Delaunay> first = delaunay(family.points);
    ASSERT_TRUE(first) << family.name;
    std::vector<Point> points = family.points;
    for (int i = 0; i < 3; ++i) {
      random.shuffle(points);
      const Result<Delaunay> second = delaunay(points);
      ASSERT_TRUE(second) << family.name;
      EXPECT_EQ(triangles_of(first->triangulation), triangles_of(second->triangulation)) << family.name;
    }
  }
}

TEST(Delaunay, rejects_points_that_span_no_triangle) {
  const std::vector<std::vector<Point>> hopeless{
      {}, {{0, 0}}, {{0, 0}, {1, 0}}, {{0, 0}, {1, 1}, {2, 2}, {5, 5}}, {{0, 0}, {0, 0}, {1, 0}, {0, 1}},
  };
  for (const std::vector<Point>& points : hopeless) {
    const Result<Delaunay> made = delaunay(points);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().kind, ErrorKind::invalid_input);
  }
}

TEST(Delaunay, rejects_more_points_than_it_can_number_before_it_looks_at_them) {
  const Point only{};
  const Result<engine::Delaunay> result = delaunay(std::span(&only, max_engine_triangles / 2 - 1), 1);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ErrorKind::resources);
}

TEST(Delaunay, rejects_equal_points) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Point> points = samples::uniform_points(50, seed);
    points.push_back(points[seed]);
    for (const std::size_t per_tile : {points_per_tile, std::size_t{4}}) {
      const Result<Delaunay> made = delaunay(points, 2, per_tile);
      ASSERT_FALSE(made);
      EXPECT_EQ(made.error().kind, ErrorKind::invalid_input);
    }
  }
}

/// The text of the coordinates identifies the point, even if the coordinates are tiny.
TEST(Delaunay, prints_coordinates_with_all_their_digits) {
  for (const std::size_t copies : {1U, 50U}) {
    std::vector<Point> points(1 + copies, Point{1e-9, 2e-9});
    points.insert(points.end(), {{0, 0}, {1, 0}, {0, 1}});
    const Result<Delaunay> made = delaunay(points);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().message, "two points share the coordinates (1e-09, 2e-09)");
  }
}

}  // namespace
}  // namespace pardel::engine
