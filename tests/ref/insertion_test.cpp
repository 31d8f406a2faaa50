#include "../../ref/insertion.hpp"

#include <gtest/gtest.h>

namespace pardel::ref {
namespace {

TEST(Insertion, on_a_wall_splits_it_and_joins_both_sides) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, -3}, {2, 3}};
  mesh.triangles = {{0, 1, 3}, {1, 0, 2}};
  mesh.constraints = {edge(0, 1)};
  const Index v = insert(mesh, {1, 0});
  EXPECT_EQ(mesh.constraints, (std::set<Edge>{edge(0, v), edge(1, v)}));
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_TRUE(is_conformal(mesh));
}

TEST(Insertion, on_the_border_of_the_mesh_makes_no_flat_triangle) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, 3}};
  mesh.triangles = {{0, 1, 2}};
  mesh.constraints = {edge(0, 1)};
  const Index v = insert(mesh, {2, 0});
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.constraints, (std::set<Edge>{edge(0, v), edge(1, v)}));
  EXPECT_TRUE(is_conformal(mesh));
}

TEST(Insertion, the_boundary_of_a_cavity_is_directed_with_the_cavity_on_its_left) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(boundary(mesh, {0, 1}), (std::vector<Edge>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
  EXPECT_EQ(boundary(mesh, {1}), (std::vector<Edge>{{0, 2}, {2, 3}, {3, 0}}));
}

}  // namespace
}  // namespace pardel::ref
