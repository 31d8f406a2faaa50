#include "../../ref/ruppert.hpp"

#include <gtest/gtest.h>

#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../ref/decomposition/cell_refiner.hpp"
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

TEST(Ruppert, accepts_angles_up_to_what_its_proof_covers) {
  EXPECT_FALSE(unsupported(domains::square(), {.min_angle_deg = 20.704}).has_value());
  EXPECT_TRUE(unsupported(domains::square(), {.min_angle_deg = 20.706}).has_value());
}

TEST(Ruppert, refuses_a_sharp_angle_whatever_the_directions_of_its_segments) {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {4, 1}};
  for (const auto& [a, b] : {std::pair<Index, Index>{0, 1}, {1, 0}})
    for (const auto& [c, d] : {std::pair<Index, Index>{0, 2}, {2, 0}}) {
      pslg.segments = {{a, b}, {c, d}};
      EXPECT_TRUE(unsupported(pslg, {}).has_value()) << a << b << c << d;
    }
}

TEST(Ruppert, refuses_to_move_a_segment_by_rounding_its_midpoint) {
  Pslg pslg = domains::square();
  pslg.points[2] = {1 + 0x1p-52, 1};  // the midpoints to (0, 1) and to (1, 0) are not representable
  const auto mesh = ruppert(pslg, goal_of(0.01));
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().kind, ErrorKind::invalid_input);
  EXPECT_EQ(mesh.error().message, "The midpoint of a subsegment is not representable.");
}

/// A square of which each side has two units in the last place, so that its centre has no coordinates in doubles.
TEST(Ruppert, refuses_to_move_a_circumcentre_to_a_vertex_by_rounding_it) {
  constexpr double far = 0x1p53;
  Pslg pslg;
  pslg.points = {{far, far}, {far + 2, far}, {far + 2, far + 2}, {far, far + 2}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const Goal coarse, fine{.max_area = 1};
  ASSERT_TRUE(ruppert(pslg, coarse).ok());
  const auto sequentially = ruppert(pslg, fine);
  const auto on_a_lattice = refine_on_lattice(pslg, fine, coarse);
  const auto on_a_quadtree = refine_on_quadtree(pslg, fine, coarse);
  ASSERT_FALSE(sequentially.ok());
  ASSERT_FALSE(on_a_lattice.ok());
  ASSERT_FALSE(on_a_quadtree.ok());
  for (const Error& error : {sequentially.error(), on_a_lattice.error(), on_a_quadtree.error()})
    EXPECT_EQ(error.message, "A circumcentre is not representable inside the domain.");
}

}  // namespace
}  // namespace pardel::ref
