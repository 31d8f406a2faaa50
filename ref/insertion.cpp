#include "insertion.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::ref {

std::vector<Edge> boundary(const PlainMesh& mesh, const std::vector<Index>& triangles) {
  std::set<Edge> directed;
  for (Index t : triangles)
    for (int i = 0; i < 3; ++i) directed.insert({mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]});
  std::vector<Edge> edges;
  for (const Edge& e : directed)
    if (!directed.contains({e[1], e[0]})) edges.push_back(e);
  return edges;
}

std::vector<Corners> retriangulation(const PlainMesh& mesh, const std::vector<Index>& cavity, Index vertex) {
  std::vector<Corners> fan;
  for (const Edge& e : boundary(mesh, cavity))
    if (!CGAL::collinear(mesh.points[e[0]], mesh.points[e[1]], mesh.points[vertex]))
      fan.push_back({e[0], e[1], vertex});
  return fan;
}

std::optional<Edge> constraint_through(const PlainMesh& mesh, const ExactPoint& p) {
  for (const Edge& e : mesh.constraints)
    if (CGAL::are_strictly_ordered_along_line(mesh.points[e[0]], p, mesh.points[e[1]])) return e;
  return std::nullopt;
}

void split_constraint(PlainMesh& mesh, const Edge& e, Index vertex) {
  mesh.constraints.insert({edge(e[0], vertex), edge(e[1], vertex)});
  mesh.constraints.erase(Edge(e));
}

Index insert(PlainMesh& mesh, const ExactPoint& p) {
  const std::vector<Index> hole = cavity(mesh, p);
  const auto vertex = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(p);
  const std::vector<Corners> fan = retriangulation(mesh, hole, vertex);

  for (auto t = hole.rbegin(); t != hole.rend(); ++t) mesh.triangles.erase(mesh.triangles.begin() + *t);
  mesh.triangles.insert(mesh.triangles.end(), fan.begin(), fan.end());

  if (const auto split = constraint_through(mesh, p)) split_constraint(mesh, *split, vertex);
  return vertex;
}

PlainMesh delaunay_in_box(const std::vector<Point>& points, double half_width) {
  PlainMesh mesh;
  mesh.points = {
      {-half_width, -half_width}, {half_width, -half_width}, {half_width, half_width}, {-half_width, half_width}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const Point& p : points) insert(mesh, exact(p));

  // Renumber, so that the corners of the box come last.
  const auto n = static_cast<Index>(points.size());
  std::rotate(mesh.points.begin(), mesh.points.begin() + 4, mesh.points.end());
  for (Corners& t : mesh.triangles)
    for (Index& v : t) v = v < 4 ? n + v : v - 4;
  return mesh;
}

PlainMesh delaunay_in_far_box(const std::vector<Point>& points) {
  double extent = 1;
  for (const Point& p : points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  return delaunay_in_box(points, 16 * extent);
}

}  // namespace pardel::ref
