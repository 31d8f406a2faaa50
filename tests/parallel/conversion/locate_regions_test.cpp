// Regions that no constrained edge separates.
#include "../../../parallel/conversion/locate_regions.hpp"

#include <gtest/gtest.h>

#include "../../../parallel/mesher.hpp"
#include "../shapes.hpp"

namespace pardel::engine {
namespace {

/// A square of side 4 with the regions 0 (below the diagonal) and 1. `wall`: the diagonal is a segment.
Mesh halves(bool wall) {
  Pslg pslg = testing::square(4);
  pslg.segments.push_back({0, 2, 0});
  pslg.regions = {{{3, 1}, 5}, {{1, 3}, 8}};
  Mesh mesh = std::move(pardel::mesh(pslg, {.max_area = 0.5}).value().mesh);
  if (!wall) std::erase_if(mesh.constrained_edges, [](const ConstrainedEdge& e) { return e.segment == 4; });
  return mesh;
}

TEST(RegionsMix, if_an_edge_between_them_is_not_constrained) {
  EXPECT_FALSE(regions_mix(halves(true)));
  EXPECT_TRUE(regions_mix(halves(false)));
  Mesh without = halves(false);
  without.region.clear();
  EXPECT_FALSE(regions_mix(without));
}

TEST(LocateRegions, gives_each_triangle_the_region_at_its_centroid) {
  const Mesh coarse = halves(false);
  Mesh fine = coarse;
  for (Index& region : fine.region) region = no_index;
  locate_regions(coarse, fine);
  EXPECT_EQ(fine.region, coarse.region);
}

}  // namespace
}  // namespace pardel::engine
