#include "../../../distributed/delaunay/local_delaunay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/samples.hpp"

namespace pardel::engine {
namespace {

/// The first half of the points is the rank's own.
struct Half {
  std::vector<Point> points = samples::uniform_points(400, 7);
  LocalDelaunay delaunay{Array<Point>(std::span(points).first(200)), 1'000};

  [[nodiscard]] Site other(std::size_t i) const { return {points[200 + i], 5'000 + i}; }
};

TEST(LocalDelaunay, knows_a_point_once) {
  Half half;
  ASSERT_TRUE(
      half.delaunay.triangulate(std::vector{half.other(0), half.other(1), half.other(0), {half.points[3], 1'003}}, {}));
  EXPECT_EQ(half.delaunay.triangulation().points.size(), 202U);
  EXPECT_EQ(half.delaunay.vertex({half.points[3], 1'003}), 3U);
  EXPECT_EQ(half.delaunay.vertex(half.other(1)), 201U);
  EXPECT_EQ(half.delaunay.vertex(half.other(2)), 202U);
  EXPECT_EQ(half.delaunay.vertex(half.other(2)), 202U);
  EXPECT_EQ(half.delaunay.site(202).position, 5'002U);
  EXPECT_EQ(samples::fault(half.delaunay.triangulation()), "");
}

TEST(LocalDelaunay, lists_the_triangles_around_new_points) {
  Half half;
  ASSERT_TRUE(half.delaunay.triangulate({}, {}));
  EXPECT_TRUE(half.delaunay.take_fresh().empty());
  const VertexId v = half.delaunay.vertex(half.other(0));
  const std::vector<TriangleId> fresh = half.delaunay.take_fresh();
  for (TriangleId id = 0; id < half.delaunay.triangulation().slots.size(); ++id)
    EXPECT_EQ(std::ranges::count(half.delaunay.triangulation().slots[id].v, v), std::ranges::count(fresh, id));
}

/// Of the vertices of a Delaunay triangulation, either none lies in the disk of a triangle, or a neighbour of a corner.
TEST(LocalDelaunay, finds_a_neighbour_in_each_disk_that_is_not_empty) {
  for (const samples::Family& family : samples::families(60, 8)) {
    LocalDelaunay delaunay(Array<Point>(std::span<const Point>(family.points)), 0);
    ASSERT_TRUE(delaunay.triangulate({}, {})) << family.name;
    const Triangulation& t = delaunay.triangulation();
    const auto n = static_cast<VertexId>(t.points.size());
    const InsertionOrder order(0, n);
    for (VertexId a = 0; a < n; a += 3)
      for (VertexId b = 0; b < n; b += 5)
        for (VertexId c = 0; c <= n; c += 7) {
          if (a == b || a == c || b == c) continue;
          const LocalDelaunay::Corners corners{a, b, c == n ? ghost : c};
          if (c < n && !(orient2d(t.points[a], t.points[b], t.points[c]) > 0)) continue;
          std::vector<VertexId> inside;
          for (VertexId v = 0; v < n; ++v)
            if (is_in_disk(t, Slot{corners, {}}, v, order)) inside.push_back(v);
          const std::vector<VertexId> found = delaunay.neighbours_in_disk(corners);
          EXPECT_EQ(found.empty(), inside.empty()) << family.name << ": " << a << ' ' << b << ' ' << c;
          EXPECT_TRUE(std::ranges::includes(inside, found));
        }
  }
}

}  // namespace
}  // namespace pardel::engine
