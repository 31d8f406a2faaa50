#include "../../ref/insertion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

namespace pardel::ref {
namespace {

/// Distinct points of a small lattice: many are collinear, many cocircular.
std::vector<Point> lattice_points() {
  const auto coordinates = *rc::gen::resize(40, rc::gen::unique<std::vector<std::pair<int, int>>>(
                                                    rc::gen::pair(rc::gen::inRange(0, 9), rc::gen::inRange(0, 9))));
  std::vector<Point> points;
  for (const auto& [x, y] : coordinates) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  return points;
}

/// The triangulation of lattice points with a wall of edges of it: every third one.
PlainMesh walled(const std::vector<Point>& points) {
  PlainMesh mesh = delaunay_in_far_box(points);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) mesh.constraints.insert(edge_of(mesh.triangles[t], 0));
  return mesh;
}

/// The cavity as every program finds it: from the triangles that hold p on, over edges that are no walls, as
/// long as the circumdisk contains p.
std::vector<Index> flooded_cavity(const PlainMesh& mesh, const ExactPoint& p) {
  std::map<Edge, std::vector<Index>> at;
  std::vector<Index> frontier;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) at[edge_of(c, i)].push_back(t);
    if (!Kernel::Triangle_2(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]).has_on_unbounded_side(p))
      frontier.push_back(t);
  }
  std::set<Index> reached;
  while (!frontier.empty()) {
    const Index t = frontier.back();
    frontier.pop_back();
    if (!circumdisk_contains(mesh, mesh.triangles[t], p) || !reached.insert(t).second) continue;
    for (int i = 0; i < 3; ++i)
      if (const Edge e = edge_of(mesh.triangles[t], i); !mesh.constraints.contains(e))
        frontier.insert(frontier.end(), at[e].begin(), at[e].end());
  }
  return {reached.begin(), reached.end()};
}

ExactPoint half_lattice_point() {
  return {*rc::gen::inRange(0, 17) / 2.0, *rc::gen::inRange(0, 17) / 2.0 + 0.25};  // never a lattice point
}

RC_GTEST_PROP(Insertion, of_point_after_point_makes_a_conformal_delaunay_mesh, ()) {
  const std::vector<Point> points = lattice_points();
  const PlainMesh mesh = delaunay_in_far_box(points);
  RC_ASSERT(is_delaunay(mesh));
  RC_ASSERT(is_conformal(mesh));
  // Euler: n points inside a quadrilateral make 2 n + 2 triangles.
  RC_ASSERT(mesh.triangles.size() == 2 * points.size() + 2);
}

RC_GTEST_PROP(Insertion, order_does_not_matter_where_no_four_points_are_cocircular, ()) {
  // A parabola and its lift: no four of these lie on a circle, since their abscissae are positive.
  auto abscissae = *rc::gen::resize(12, rc::gen::unique<std::vector<int>>(rc::gen::inRange(1, 40)));
  const auto triangulated = [&] {
    std::vector<Point> points;
    for (int x : abscissae) points.push_back({static_cast<double>(x), static_cast<double>(x) * x});
    const PlainMesh mesh = delaunay_in_far_box(points);
    std::set<std::set<ExactPoint>> triangles;
    for (const Corners& t : mesh.triangles) triangles.insert({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    return triangles;
  };
  const auto in_order = triangulated();
  std::ranges::sort(abscissae, std::greater<>());
  RC_ASSERT(triangulated() == in_order);
}

RC_GTEST_PROP(Insertion, a_walled_delaunay_mesh_has_the_cavity_that_a_flood_finds, ()) {
  const PlainMesh mesh = walled(lattice_points());
  const ExactPoint p = half_lattice_point();
  RC_ASSERT(cavity(mesh, p) == flooded_cavity(mesh, p));
}

RC_GTEST_PROP(Insertion, keeps_a_walled_mesh_constrained_delaunay_and_its_walls_whole, ()) {
  PlainMesh mesh = walled(lattice_points());
  Number walls_before = 0, walls_after = 0;
  const auto length = [&](const Edge& e) {
    // Walls are compared by their projections, which add up exactly.
    const Kernel::Vector_2 along = mesh.points[e[1]] - mesh.points[e[0]];
    return Number(CGAL::abs(along.x()) + CGAL::abs(along.y()));
  };
  for (const Edge& e : mesh.constraints) walls_before += length(e);
  const std::size_t pieces = mesh.constraints.size();
  for (int i = 0; i < 3; ++i) {
    const ExactPoint p = half_lattice_point();
    if (std::ranges::count(mesh.points, p) == 0) insert(mesh, p);
  }
  RC_CLASSIFY(mesh.constraints.size() > pieces, "a wall was split");
  for (const Edge& e : mesh.constraints) walls_after += length(e);
  RC_ASSERT(is_conformal(mesh));
  RC_ASSERT(is_constrained_delaunay(mesh));
  RC_ASSERT(walls_before == walls_after);
  std::set<Edge> edges;
  for (const Corners& t : mesh.triangles) edges.insert({edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)});
  RC_ASSERT(std::ranges::includes(edges, mesh.constraints));
}

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
