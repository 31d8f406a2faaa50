#include "../../ref/definitions.hpp"

#include <gtest/gtest.h>

namespace pardel::ref {
namespace {

/// Two triangles above and below the edge from (0, 0) to (4, 0), which joins vertices 0 and 1 and may be a wall.
PlainMesh two_triangles(bool wall) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, -3}, {2, 3}};
  mesh.triangles = {{0, 1, 3}, {1, 0, 2}};
  if (wall) mesh.constraints.insert(edge(0, 1));
  return mesh;
}

TEST(Definitions, an_open_circumdisk_does_not_contain_its_circle) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {0, 2}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(circumdisk_contains(mesh, mesh.triangles[0], {1, 1}));
  EXPECT_FALSE(circumdisk_contains(mesh, mesh.triangles[0], {2, 2}));
  EXPECT_TRUE(circumdisk_contains(mesh, mesh.triangles[0], {2 - 0x1p-50, 2 - 0x1p-50}));
  EXPECT_FALSE(circumdisk_contains(mesh, mesh.triangles[0], {2 + 0x1p-50, 2}));
}

TEST(Definitions, measures_of_a_right_triangle) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {0, 3}};
  const Corners t{0, 1, 2};
  EXPECT_EQ(squared_circumradius(mesh, t), Number(25) / 4);
  EXPECT_EQ(circumcentre(mesh, t), ExactPoint(2, 1.5));
  EXPECT_EQ(squared_shortest_edge(mesh, t), 9);
  EXPECT_EQ(area(mesh, t), 6);
}

TEST(Definitions, a_wall_blocks_sight_and_an_edge_does_not) {
  const ExactPoint above(2, 1);
  EXPECT_TRUE(sees(two_triangles(false), above, {1, 0, 2}));
  EXPECT_FALSE(sees(two_triangles(true), above, {1, 0, 2}));
  EXPECT_TRUE(sees(two_triangles(true), above, {0, 1, 3}));
}

TEST(Definitions, a_point_on_a_wall_sees_both_sides) {
  EXPECT_TRUE(sees(two_triangles(true), {1, 0}, {1, 0, 2}));
  EXPECT_TRUE(sees(two_triangles(true), {1, 0}, {0, 1, 3}));
}

TEST(Definitions, a_triangle_is_seen_past_the_end_of_a_wall) {
  // p lies below a wall of length 2 at y = 1. The wall hides triangles that lie behind it; p sees triangles that extend
  // to its left or right.
  PlainMesh mesh;
  mesh.points = {{-1, 1}, {1, 1}, {-9, 5}, {9, 5}, {0, 6}, {-0.5, 2}, {0.5, 2}, {0, 3}};
  mesh.constraints = {edge(0, 1)};
  const ExactPoint p(0, 0);
  EXPECT_TRUE(sees(mesh, p, {2, 3, 4}));   // wider than the shadow of the wall
  EXPECT_FALSE(sees(mesh, p, {5, 6, 7}));  // within the shadow
  // Now one corner of the triangle lies outside the shadow.
  mesh.points[6] = {3, 2};
  EXPECT_TRUE(sees(mesh, p, {5, 6, 7}));
}

TEST(Definitions, a_wall_seen_from_its_end_hides_nothing) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, -3}, {2, 3}, {-2, 0}};
  mesh.triangles = {{0, 1, 3}, {1, 0, 2}};
  mesh.constraints = {edge(0, 1)};
  EXPECT_TRUE(sees(mesh, mesh.points[4], {0, 1, 3}));
  EXPECT_TRUE(sees(mesh, mesh.points[4], {1, 0, 2}));
}

TEST(Definitions, two_triangles_over_a_square_are_delaunay_with_either_diagonal) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(is_delaunay(mesh));
  mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
  EXPECT_TRUE(is_delaunay(mesh));
  mesh.points[2] = {0.75, 0.75};
  EXPECT_FALSE(is_delaunay(mesh));
}

TEST(Definitions, a_wall_makes_a_mesh_constrained_delaunay_that_is_not_delaunay) {
  PlainMesh mesh = two_triangles(true);
  mesh.points[2] = {2, -1};
  mesh.points[3] = {2, 1};
  EXPECT_FALSE(is_delaunay(mesh));
  EXPECT_TRUE(is_constrained_delaunay(mesh));
  mesh.constraints.clear();
  EXPECT_FALSE(is_constrained_delaunay(mesh));
}

TEST(Definitions, conformal_triangles_meet_in_whole_edges_and_vertices_only) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, 3}, {2, -3}, {2, 0}, {9, 9}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  EXPECT_TRUE(is_conformal(mesh));
  mesh.triangles = {{0, 1, 2}, {4, 0, 3}};  // half an edge lies on a whole edge
  EXPECT_FALSE(is_conformal(mesh));
  mesh.triangles = {{0, 1, 2}, {0, 5, 2}};  // overlapping
  EXPECT_FALSE(is_conformal(mesh));
  mesh.triangles = {{0, 2, 1}};  // clockwise
  EXPECT_FALSE(is_conformal(mesh));
}

TEST(Definitions, a_cavity_stops_at_a_wall) {
  const ExactPoint p(2, 0.25);
  EXPECT_EQ(cavity(two_triangles(false), p), (std::vector<Index>{0, 1}));
  EXPECT_EQ(cavity(two_triangles(true), p), (std::vector<Index>{0}));
}

TEST(Definitions, the_closure_of_triangles_is_given_by_their_vertices) {
  EXPECT_EQ(closure(two_triangles(false), {0}), (std::set<Index>{0, 1, 3}));
  EXPECT_EQ(closure(two_triangles(false), {0, 1}), (std::set<Index>{0, 1, 2, 3}));
  EXPECT_EQ(closure(two_triangles(false), {}), std::set<Index>{});
}

TEST(Definitions, a_point_on_the_diametral_circle_encroaches_and_an_end_does_not) {
  const ExactPoint a(0, 0), b(2, 0);
  EXPECT_TRUE(encroaches({1, 1}, a, b));
  EXPECT_TRUE(encroaches({1, 0}, a, b));
  EXPECT_FALSE(encroaches({1, 1 + 0x1p-50}, a, b));
  EXPECT_FALSE(encroaches(a, a, b));
  EXPECT_FALSE(encroaches({3, 0}, a, b));
}

TEST(Definitions, encroachment_is_tested_for_every_constrained_edge) {
  const PlainMesh mesh = two_triangles(true);
  EXPECT_EQ(encroached_by(mesh, {2, 1}), std::vector<Edge>{edge(0, 1)});
  EXPECT_TRUE(encroached_by(mesh, {2, 2.5}).empty());
  EXPECT_FALSE(is_encroached(mesh, edge(0, 1)));
}

/// Two triangles with one common vertex, one inside the other; in both orders and with all numberings.
TEST(Conformal, meshes_have_no_triangle_inside_another_at_a_common_vertex) {
  const std::vector<ExactPoint> points{{0, 0}, {8, 0}, {0, 8}, {2, 1}, {1, 2}, {-2, -1}, {-1, -2}};
  for (unsigned first = 0; first < 3; ++first)
    for (unsigned second = 0; second < 3; ++second) {
      Corners large{0, 1, 2}, small{0, 3, 4}, opposite{0, 5, 6};
      for (Corners* t : {&small, &opposite}) std::rotate(t->begin(), t->begin() + second, t->end());
      std::rotate(large.begin(), large.begin() + first, large.end());
      EXPECT_FALSE(is_conformal({points, {large, small}, {}}));
      EXPECT_FALSE(is_conformal({points, {small, large}, {}}));
      EXPECT_TRUE(is_conformal({points, {opposite, large}, {}}));
      EXPECT_TRUE(is_conformal({points, {large, opposite}, {}}));
    }
}

}  // namespace
}  // namespace pardel::ref
