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

}  // namespace
}  // namespace pardel::engine
