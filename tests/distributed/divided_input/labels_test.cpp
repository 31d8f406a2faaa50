#include "../../../distributed/divided_input/labels.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <set>
#include <string>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../cdt/triangulated_domain.hpp"

namespace pardel::engine {
namespace {

using properties::on_ranks;

/// Ranks label their triangles. They have to get the domain and the regions of one process.
void expect_the_domain_of_one_process(const Pslg& pslg, bool convex_hull, const std::string& name) {
  SCOPED_TRACE(name);
  const Result<DomainTriangulation> whole = triangulate_domain(pslg, convex_hull);
  ASSERT_TRUE(whole) << whole.error().message;
  const Triangulation& all = whole->triangulation;
  std::map<Corners, Index> expected;
  for (TriangleId id = 0; id < all.slots.size(); ++id)
    expected[corners_of(all, all.slots[id])] = all.region.empty() ? no_index : all.region[id];
  DomainRules rules{convex_hull, pslg.holes, {}};
  for (const Region& region : pslg.regions) rules.region_seeds.push_back(region.seed);
  for (const int count : {1, 2, 4, 7}) {
    std::atomic<int> wrong = 0, wrong_beyond = 0;
    on_ranks(count, [&](Ranks& ranks) {
      TriangulatedPart part(pslg, ranks);
      part.insert_segments(ranks);
      const LocalDelaunay& delaunay = part.points->delaunay;
      const Labels labels(delaunay, part.points->own, part.hull, rules, ranks, {});
      EXPECT_TRUE(labels.are_certainly_valid());
      const Triangulation& t = delaunay.triangulation();
      for (TriangleId id = 0; id < t.slots.size(); ++id) {
        const Slot& slot = t.slots[id];
        if (slot.is_ghost() || !delaunay.has_own_corner(id)) continue;
        const auto found = expected.find(corners_of(t, slot));
        const bool is_inside = found != expected.end();
        wrong += is_inside != labels.is_in_domain(id) || (is_inside && found->second != labels.region(id)) ? 1 : 0;
        for (unsigned side = 0; side < 3; ++side) {
          const Slot& across = t.slot(slot.n[side]);
          if (!slot.n[side].constrained() || across.is_ghost()) continue;
          wrong_beyond += expected.contains(corners_of(t, across)) != labels.is_in_domain_beyond(slot, side) ? 1 : 0;
        }
      }
    });
    EXPECT_EQ(wrong, 0) << count << " ranks";
    EXPECT_EQ(wrong_beyond, 0) << count << " ranks";
  }
}

Pslg with_points_in_it(Pslg pslg) {
  for (const Point p : domains::random_points(600, 9).points) pslg.points.push_back({6 * p.x - 1, 6 * p.y - 1});
  return pslg;
}

TEST(Labels, are_those_of_one_process) {
  for (const bool convex_hull : {false, true}) {
    expect_the_domain_of_one_process(with_points_in_it(domains::regions()), convex_hull, "regions");
    expect_the_domain_of_one_process(with_points_in_it(domains::touching_holes()), convex_hull, "touching holes");
    expect_the_domain_of_one_process(with_points_in_it(domains::cracks()), convex_hull, "cracks");
    expect_the_domain_of_one_process(with_points_in_it(domains::comb(4, 0.1)), convex_hull, "comb");
    expect_the_domain_of_one_process(domains::pipe(), convex_hull, "pipe");
  }
}

}  // namespace
}  // namespace pardel::engine
