#include "../../../distributed/cdt/common_segments.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>

#include "../../../parallel/construction/domain_triangulation.hpp"
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

TEST(CommonSegments, are_all_that_a_rank_needs_to_get_its_triangles) {
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

TEST(CommonSegments, that_pass_a_point_are_noticed_by_all_ranks) {
  Pslg pslg = square_with_segments();
  pslg.points.push_back({0.25, 0.25});  // inside the segment 1
  on_ranks(3, [&](Ranks& ranks) {
    TriangulatedPart part(pslg, ranks);
    part.divide(ranks);
    EXPECT_TRUE(part.segments.pass_points);
  });
}

/// A coast of 300 points in a square. All segments are edges of the Delaunay triangulation; those of the square are on
/// the convex hull.
TEST(CommonSegments, are_few_where_points_are_dense_on_segments) {
  Pslg pslg = domains::coast(300, 7);
  for (const Point p : {Point{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}) pslg.points.push_back(p);
  for (Index i = 0; i < 4; ++i) pslg.segments.push_back({300 + i, 300 + (i + 1) % 4});
  std::atomic<std::size_t> own = 0;
  on_ranks(3, [&](Ranks& ranks) {
    TriangulatedPart part(pslg, ranks);
    part.divide(ranks);
    ASSERT_EQ(part.segments.common.size(), 4U);
    for (const GivenSegment& s : part.segments.common) EXPECT_GE(s.number, 300U);
    own += part.segments.own.size();
    for (const GivenSegment& s : part.segments.own)
      EXPECT_TRUE(part.points->own.owner(s.a.position) == ranks.rank() ||
                  part.points->own.owner(s.b.position) == ranks.rank());
  });
  EXPECT_GE(own, 300U);
  EXPECT_LT(own, 400U);
}

}  // namespace
}  // namespace pardel::engine
