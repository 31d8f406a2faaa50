#include "../../../parallel/divided_points/crossed_triangles.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>

#include "../../../parallel/conversion/domain_triangulation.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "triangulated_domain.hpp"

namespace pardel::engine {
namespace {

using properties::on_ranks;

/// A square with points in it, and two segments across it that meet in none of the points.
Pslg square_with_segments() {
  Pslg pslg = domains::random_points(400, 5);
  for (const Point p : {Point{-0.1, -0.1}, {1.1, -0.1}, {1.1, 1.1}, {-0.1, 1.1}, {0.5, 1.2}}) pslg.points.push_back(p);
  pslg.segments = {{400, 401}, {400, 402}, {403, 400}, {402, 403}, {404, 403}};
  return pslg;
}

TEST(CrossedTriangles, are_all_that_a_rank_needs_to_insert_segments) {
  const Pslg pslg = square_with_segments();
  const Result<DomainTriangulation> whole = triangulate_domain(pslg, true);
  ASSERT_TRUE(whole) << whole.error().message;
  std::set<Corners> expected;
  for (const Slot& slot : whole->triangulation.slots) expected.insert(corners_of(whole->triangulation, slot));
  for (const int count : {1, 2, 5}) {
    std::atomic<int> wrong = 0;
    on_ranks(count, [&](Ranks& ranks) {
      TriangulatedPart part(pslg, ranks);
      part.insert_segments(ranks);
      const LocalDelaunay& delaunay = part.points->delaunay;
      const Triangulation& t = delaunay.triangulation();
      for (TriangleId id = 0; id < t.slots.size(); ++id)
        if (!t.slots[id].is_ghost() && delaunay.has_own_corner(id) && !expected.contains(corners_of(t, t.slots[id])))
          ++wrong;
    });
    EXPECT_EQ(wrong, 0) << count << " ranks";
  }
}

TEST(CrossedTriangles, show_the_points_inside_segments_to_all_ranks) {
  Pslg pslg = square_with_segments();
  pslg.points.push_back({0.25, -0.1});
  pslg.points.push_back({0.75, -0.1});
  pslg.points.push_back({0.25, 0.25});  // inside the segment 1
  on_ranks(3, [&](Ranks& ranks) {
    TriangulatedPart part(pslg, ranks);
    LocalDelaunay& delaunay = part.points->delaunay;
    const std::vector<Problem> problems =
        learn_crossed_triangles(ordered_constraints(part.common, delaunay), delaunay, part.points->own, ranks, {});
    ASSERT_GE(problems.size(), 2U);
    for (const Problem& problem : problems) EXPECT_EQ(problem.kind, ProblemKind::point_on_segment);
    const Problem &first = problems.front(), &last = problems.back();
    EXPECT_TRUE(first.ids == (std::vector<Index>{405, 0}) || first.ids == (std::vector<Index>{406, 0}));
    EXPECT_TRUE(last.ids == (std::vector<Index>{407, 1}));
  });
}

}  // namespace
}  // namespace pardel::engine
