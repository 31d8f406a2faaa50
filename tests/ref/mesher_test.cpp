// Compares the meshes of the mesher with the definitions themselves, without local criteria or lemmas.
#include "../../parallel/mesher.hpp"

#include <gtest/gtest.h>

#include "../../properties/domains/domains.hpp"
#include "../../ref/definitions.hpp"
#include "../../ref/ruppert.hpp"

namespace pardel::ref {
namespace {

Goal goal_of(double max_area, bool conforming) {
  Goal goal;
  goal.min_angle_deg = 20.7;
  goal.max_area = max_area;
  goal.conforming = conforming;
  return goal;
}

const std::vector<Pslg>& small_domains() {
  static const std::vector<Pslg> all = {domains::square(),       domains::touching_holes(),     domains::cracks(),
                                        domains::star(5, 5),     domains::comb(3, 0.03125),     domains::grid(3),
                                        domains::grid_points(4), domains::random_points(40, 2), domains::wedge(12, 6)};
  return all;
}

TEST(TheMesher, triangulates_constrained_delaunay_by_definition) {
  for (const Pslg& pslg : small_domains()) {
    const auto meshed = triangulate(pslg);
    ASSERT_TRUE(meshed.ok()) << meshed.error().message;
    EXPECT_TRUE(is_constrained_delaunay(to_plain_mesh(meshed->mesh)));
    EXPECT_TRUE(is_conformal(to_plain_mesh(meshed->mesh)));
  }
}

TEST(TheMesher, refines_to_constrained_delaunay_by_definition) {
  for (const Pslg& pslg : small_domains()) {
    const auto meshed = mesh(pslg, goal_of(1, false));
    ASSERT_TRUE(meshed.ok()) << meshed.error().message;
    EXPECT_TRUE(is_constrained_delaunay(to_plain_mesh(meshed->mesh)));
  }
}

TEST(TheMesher, refines_to_delaunay_by_definition_where_the_goal_is_conforming) {
  for (const Pslg& pslg : {domains::square(), domains::grid(3), domains::grid_points(4), domains::regions()}) {
    const auto meshed = mesh(pslg, goal_of(0.05, true));
    ASSERT_TRUE(meshed.ok()) << meshed.error().message;
    EXPECT_TRUE(is_delaunay(to_plain_mesh(meshed->mesh)));
  }
}

TEST(TheMesher, needs_at_most_a_quarter_more_triangles_than_ruppert) {
  for (const Pslg& pslg : {domains::square(), domains::touching_holes(), domains::regions()}) {
    const Goal goal = goal_of(0.01, true);
    const auto ours = mesh(pslg, goal);
    const auto theirs = ruppert(pslg, goal);
    ASSERT_TRUE(ours.ok() && theirs.ok());
    EXPECT_LE(ours->mesh.triangles.size(), theirs->triangles.size() * 5 / 4);
  }
}

}  // namespace
}  // namespace pardel::ref
