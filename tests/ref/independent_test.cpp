// Independent insertion of two points.
#include "../../ref/independent.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../../properties/domains/domains.hpp"
#include "../../ref/insertion.hpp"
#include "../../ref/ruppert.hpp"

namespace pardel::ref {
namespace {

/// A Delaunay mesh of the unit square, so fine that points can be several circumradii apart.
const PlainMesh& square_mesh() {
  static const PlainMesh result = [] {
    Goal goal;
    goal.max_area = 0.002;
    goal.conforming = true;
    const auto mesh = ruppert(domains::square(), goal);
    return mesh ? to_plain_mesh(*mesh) : PlainMesh{};
  }();
  return result;
}

/// True if |pq| >= factor * r̄, in exact arithmetic. r̄ is an upper bound on all circumradii.
bool apart(const ExactPoint& p, const ExactPoint& q, int factor) {
  static const Number squared_bound = squared_circumradius_bound(square_mesh());
  return CGAL::squared_distance(p, q) >= factor * factor * squared_bound;
}

/// True if p is not a vertex and does not encroach upon a segment.
bool is_insertable(const ExactPoint& p) {
  return encroached_by(square_mesh(), p).empty() && std::ranges::count(square_mesh().points, p) == 0;
}

PlainMesh inserted(PlainMesh mesh, const ExactPoint& first, const ExactPoint& second) {
  insert(mesh, first);
  insert(mesh, second);
  return mesh;
}

bool gives_the_sequential_mesh(const ExactPoint& p, const ExactPoint& q) {
  const auto independent = triangles_as_points(insert_independently(square_mesh(), {p, q}));
  return independent == triangles_as_points(inserted(square_mesh(), p, q)) &&
         independent == triangles_as_points(inserted(square_mesh(), q, p));
}

TEST(Independence, fails_for_two_points_in_one_triangle) {
  const PlainMesh& mesh = square_mesh();
  ASSERT_FALSE(mesh.triangles.empty());
  const Corners& t = mesh.triangles[mesh.triangles.size() / 2];
  const ExactPoint centre = CGAL::centroid(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  const ExactPoint p = CGAL::midpoint(centre, mesh.points[t[0]]), q = CGAL::midpoint(centre, mesh.points[t[1]]);
  EXPECT_FALSE(closures_are_disjoint(mesh, p, q));
  EXPECT_FALSE(is_conformal(insert_independently(mesh, {p, q})));
  EXPECT_FALSE(gives_the_sequential_mesh(p, q));
}

TEST(Independence, of_two_distant_points_gives_a_delaunay_mesh_by_definition) {
  const ExactPoint p(0.25, 0.25), q(0.75, 0.8125);
  ASSERT_TRUE(is_insertable(p) && is_insertable(q) && apart(p, q, 4));
  EXPECT_TRUE(is_delaunay(insert_independently(square_mesh(), {p, q})));
}

/// Two triangles above and below the edge from (0, 0) to (4, 0), which may be a wall. The other corner of each triangle
/// is so far away that the triangle alone is the cavity of points near this corner.
PlainMesh two_tall_triangles(bool wall) {
  PlainMesh mesh;
  mesh.points = {{0, 0}, {4, 0}, {2, -8}, {2, 8}};
  mesh.triangles = {{0, 1, 3}, {1, 0, 2}};
  if (wall) mesh.constraints.insert(edge(0, 1));
  return mesh;
}

TEST(Independence, of_points_with_a_common_boundary_edge_is_decided_by_one_circle) {
  // The circle through (0, 0), (4, 0) and (2, 2) has its centre on the edge and the radius 2.
  EXPECT_TRUE(are_independent(two_tall_triangles(false), {2, 2}, {2, -3}));
  EXPECT_TRUE(are_independent(two_tall_triangles(false), {2, 2}, {2, -2}));  // cocircular: not inside
  EXPECT_FALSE(are_independent(two_tall_triangles(false), {2, 2}, {2, -1.75}));
  EXPECT_FALSE(closures_are_disjoint(two_tall_triangles(false), {2, 2}, {2, -3}));
}

TEST(Independence, holds_for_two_points_on_both_sides_of_a_wall) {
  EXPECT_TRUE(are_independent(two_tall_triangles(true), {2, 2}, {2, -1.75}));
}

TEST(Independence, fails_for_two_points_with_a_common_cavity_triangle) {
  EXPECT_FALSE(are_independent(two_tall_triangles(true), {2, 2}, {2, 3}));
  EXPECT_FALSE(
      are_independent(two_tall_triangles(true), {2, 2}, {2, 0}));  // on the wall: its cavity has both triangles
}

TEST(Independence, of_one_point_is_sequential_insertion) {
  PlainMesh mesh = square_mesh();
  const ExactPoint p(0.3125, 0.40625);
  const auto alone = triangles_as_points(insert_independently(mesh, {p}));
  insert(mesh, p);
  EXPECT_EQ(alone, triangles_as_points(mesh));
}

}  // namespace
}  // namespace pardel::ref
