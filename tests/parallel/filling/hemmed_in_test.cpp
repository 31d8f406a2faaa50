// Triangles that cannot be split because of a patch are found; all others are not.
#include "../../../parallel/filling/hemmed_in.hpp"

#include <gtest/gtest.h>

#include <array>

#include "../../../parallel/filling/filling.hpp"
#include "../../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../patches/domains_to_fill.hpp"

namespace pardel::engine {
namespace {

/// Refines the square around a patch. The bounds on areas and angles hold around it only.
std::vector<TriangleId> stuck_beside_patch(double edge, const Goal& goal, bool with_patch = true,
                                           double min_edge = 1e-9) {
  auto filling = Filling::make(domains::square(), false, coarse(domains::square()), std::array{edge}, {}, {}, {});
  EXPECT_TRUE(filling && *filling);
  DomainTriangulation domain = with_patch ? (*filling)->take_domain() : coarse(domains::square());
  const Criteria criteria(goal, Placement::off_centre, {});
  const Options options{.threads = 1, .min_edge = min_edge};
  ProgressMonitor progress(options);
  EXPECT_TRUE(refine_by_sweeps(domain.triangulation, domain.segments, criteria, options, progress));
  return hemmed_in(domain.triangulation, domain.segments, criteria, options);
}

TEST(HemmedIn, lists_the_triangles_that_a_patch_keeps_from_being_split) {
  EXPECT_FALSE(stuck_beside_patch(0.1, {.min_angle_deg = 20.7, .max_area = 0.001}).empty())
      << "the edges of the patch are too long for the bound on areas";
  EXPECT_TRUE(stuck_beside_patch(0.1, {.min_angle_deg = 20.7, .max_area = 0.0044}).empty());
}

TEST(HemmedIn, lists_nothing_where_there_is_no_patch) {
  EXPECT_TRUE(stuck_beside_patch(0.1, {.min_angle_deg = 33, .max_area = 0.001}, false).empty());
}

TEST(HemmedIn, lists_no_triangle_that_only_the_length_of_edges_keeps_from_being_split) {
  const Goal goal{.min_angle_deg = 25, .max_area = 0.001};
  EXPECT_TRUE(stuck_beside_patch(0.1, goal, false, 0.1).empty());
}

}  // namespace
}  // namespace pardel::engine
