#include "../../ref/ruppert.hpp"

#include <gtest/gtest.h>

#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../ref/definitions.hpp"

namespace pardel::ref {
namespace {

Goal goal_of(double max_area, double max_edge = std::numeric_limits<double>::infinity()) {
  Goal goal;
  goal.min_angle_deg = 20.7;
  goal.max_area = max_area;
  goal.region_caps = true;
  goal.max_edge = max_edge;
  goal.conforming = true;
  return goal;
}

/// Expects that the checker certifies the mesh without exempt triangles. If `by_definition`, the mesh is also compared
/// with the definition of a Delaunay mesh.
void expect_certified(const Pslg& pslg, const Goal& goal, bool by_definition = true) {
  const auto mesh = ruppert(pslg, goal);
  ASSERT_TRUE(mesh.ok()) << mesh.error().message;
  ASSERT_FALSE(mesh->triangles.empty());
  const Certificate certificate = check(pslg, *mesh, goal);
  EXPECT_TRUE(certificate.valid) << (certificate.violations.empty() ? "" : certificate.violations[0].message());
  EXPECT_TRUE(certificate.justified.empty());
  if (by_definition) {
    EXPECT_TRUE(is_delaunay(to_plain_mesh(*mesh)));
  }
}

TEST(Ruppert, meshes_the_square) { expect_certified(domains::square(), goal_of(0.01)); }

TEST(Ruppert, meshes_holes_that_touch) { expect_certified(domains::touching_holes(), goal_of(0.05)); }

TEST(Ruppert, meshes_regions_with_their_caps) { expect_certified(domains::regions(), goal_of(1)); }

TEST(Ruppert, meshes_the_pipe) { expect_certified(domains::pipe(), goal_of(0.02), false); }

TEST(Ruppert, honours_a_bound_on_edges_and_a_sizing_function) {
  Goal goal = goal_of(1, 0.25);
  goal.size = [](Point p) { return 0.05 + p.x / 4; };
  expect_certified(domains::square(), goal);
}

TEST(Ruppert, meshes_a_crack_and_isolated_points) {
  Pslg pslg = domains::square();
  pslg.points.insert(pslg.points.end(), {{0.25, 0.5}, {0.625, 0.5}, {0.75, 0.75}, {0.75, 0.765625}});
  pslg.segments.push_back({4, 5, 7});
  pslg.has_segment_markers = true;
  expect_certified(pslg, goal_of(1));
}

TEST(Ruppert, leaves_no_subsegment_encroached) {
  const auto mesh = ruppert(domains::touching_holes(), goal_of(0.1));
  ASSERT_TRUE(mesh.ok());
  const PlainMesh result = to_plain_mesh(*mesh);
  for (const Edge& e : result.constraints) EXPECT_FALSE(is_encroached(result, e));
}

TEST(Ruppert, refuses_what_its_proof_does_not_cover) {
  Goal too_steep = goal_of(1);
  too_steep.min_angle_deg = 21;
  Goal hull = goal_of(1);
  hull.convex_hull = true;
  for (const auto& refused : {ruppert(domains::star(5, 5), goal_of(1)), ruppert(domains::square(), too_steep),
                              ruppert(domains::square(), hull), ruppert(domains::random_points(10, 1), goal_of(1))}) {
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, ErrorKind::usage);
  }
}

TEST(Ruppert, refuses_to_move_a_segment_by_rounding_its_midpoint) {
  Pslg pslg = domains::square();
  pslg.points[2] = {1 + 0x1p-52, 1};  // the midpoints to (0, 1) and to (1, 0) are not representable
  const auto mesh = ruppert(pslg, goal_of(0.01));
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().kind, ErrorKind::invalid_input);
}

}  // namespace
}  // namespace pardel::ref
