#include "../../../parallel/triangulation/locate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../parallel/construction/delaunay.hpp"
#include "../../../properties/checker/arithmetic/exact.hpp"
#include "../samples.hpp"

namespace pardel::engine {
namespace {

using samples::Random;

TEST(Locate, finds_a_triangle_that_contains_the_point_or_the_ghost_beyond_a_hull_edge) {
  Random random(7);
  for (const samples::Family& family : samples::families(300, 8)) {
    const Result<Delaunay> made = delaunay(family.points);
    ASSERT_TRUE(made) << family.name;
    const Triangulation& t = made->triangulation;
    TriangleId start = 0;
    while (t.slots[start].is_ghost()) ++start;
    const Point low = *std::min_element(family.points.begin(), family.points.end(),
                                        [](Point a, Point b) { return a.x + a.y < b.x + b.y; });
    const Point high = *std::max_element(family.points.begin(), family.points.end(),
                                         [](Point a, Point b) { return a.x + a.y < b.x + b.y; });
    for (int round = 0; round < 300; ++round) {
      const double f = random.uniform(-0.3, 1.3), g = random.uniform(-0.3, 1.3);
      const Point p = round % 3 == 0 ? family.points[random.below(family.points.size())]
                                     : Point{low.x + f * (high.x - low.x), low.y + g * (high.y - low.y)};
      const Slot& slot = t.slots[locate(t, p, start)];
      for (unsigned side = 0; side < 3; ++side) {
        if (slot.from(side) == ghost || slot.to(side) == ghost) continue;
        const int turn = checker::exactly::orientation(t.points[slot.from(side)], t.points[slot.to(side)], p);
        if (slot.is_ghost())
          EXPECT_GT(turn, 0) << family.name;
        else
          EXPECT_GE(turn, 0) << family.name;
      }
    }
  }
}

TEST(Locate, ends_before_the_first_triangle_that_it_may_not_enter) {
  const Triangulation t = samples::delaunay_of(samples::lattice_points(9));
  TriangleId start = 0;
  while (t.slots[start].is_ghost() || t.points[t.slots[start].v[0]].x > 2) ++start;
  const auto is_on_the_left = [&](VertexId v) { return v != ghost && t.points[v].x <= 4; };
  EXPECT_EQ(locate(t, {7.25, 3.5}, start, is_on_the_left), no_index);
  const TriangleId found = locate(t, {3.25, 6.5}, start, is_on_the_left);
  ASSERT_NE(found, no_index);
  for (const VertexId v : t.slots[found].v) EXPECT_TRUE(is_on_the_left(v));
}

}  // namespace
}  // namespace pardel::engine
