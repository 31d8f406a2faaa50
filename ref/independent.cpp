#include "independent.hpp"

#include <algorithm>

#include "insertion.hpp"

namespace pardel::ref {

PlainMesh insert_independently(const PlainMesh& mesh, const std::vector<ExactPoint>& points) {
  PlainMesh result{mesh.points, {}, mesh.constraints};
  result.points.insert(result.points.end(), points.begin(), points.end());

  const PlainMesh numbered{result.points, mesh.triangles, mesh.constraints};
  std::set<Index> deleted;
  std::vector<Corners> added;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<Index> hole = cavity(mesh, points[i]);
    const auto vertex = static_cast<Index>(mesh.points.size() + i);
    const auto fan = retriangulation(numbered, hole, vertex);
    if (const auto split = constraint_through(mesh, points[i])) split_constraint(result, *split, vertex);
    deleted.insert(hole.begin(), hole.end());
    added.insert(added.end(), fan.begin(), fan.end());
  }

  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (!deleted.contains(t)) result.triangles.push_back(mesh.triangles[t]);
  result.triangles.insert(result.triangles.end(), added.begin(), added.end());
  return result;
}

std::set<std::array<ExactPoint, 3>> triangles_as_points(const PlainMesh& mesh) {
  std::set<std::array<ExactPoint, 3>> triangles;
  for (const Corners& t : mesh.triangles) {
    std::array<ExactPoint, 3> corners = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.insert(corners);
  }
  return triangles;
}

bool closures_are_disjoint(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q) {
  const std::set<Index> of_p = closure(mesh, cavity(mesh, p)), of_q = closure(mesh, cavity(mesh, q));
  return std::none_of(of_p.begin(), of_p.end(), [&](Index v) { return of_q.contains(v); });
}

bool are_independent(const PlainMesh& mesh, const ExactPoint& p, const ExactPoint& q) {
  const std::vector<Index> of_p = cavity(mesh, p), of_q = cavity(mesh, q);
  if (std::ranges::any_of(of_p, [&](Index t) { return std::ranges::count(of_q, t) != 0; })) return false;

  const std::vector<Edge> around_q = boundary(mesh, of_q);
  return std::ranges::none_of(boundary(mesh, of_p), [&](const Edge& e) {
    const bool is_common = std::ranges::count(around_q, Edge{e[1], e[0]}) != 0;
    const bool is_wall = mesh.constraints.contains(edge(e[0], e[1]));
    if (!is_common || is_wall) return false;
    const ExactPoint &m = mesh.points[e[0]], &n = mesh.points[e[1]];
    // If q lies on the line mn, the fan of q has no triangle at mn.
    if (CGAL::collinear(q, m, n)) return false;
    return CGAL::side_of_bounded_circle(q, m, n, p) == CGAL::ON_BOUNDED_SIDE;
  });
}

}  // namespace pardel::ref
