#include "definitions.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::fuzz {

using ref::Corners;
using ref::Edge;
using ref::Number;

namespace {

Number squared_length(const ExactMesh& mesh, const Edge& e) {
  return CGAL::squared_distance(mesh.plain.points[e[0]], mesh.plain.points[e[1]]);
}

bool has_edge_longer_than(const ExactMesh& mesh, const Corners& c, const Number& length) {
  for (int i = 0; i < 3; ++i)
    if (squared_length(mesh, ref::edge_of(c, i)) > length * length) return true;
  return false;
}

}  // namespace

Triangles not_counter_clockwise(const ExactMesh& mesh) {
  return triangles_that(mesh, [&](Index, const Corners& c) {
    const auto& p = mesh.plain.points;
    return CGAL::orientation(p[c[0]], p[c[1]], p[c[2]]) != CGAL::LEFT_TURN;
  });
}

Triangles with_equal_twins(const ExactMesh& mesh) {
  const auto sorted = [](Corners c) {
    std::ranges::sort(c);
    return c;
  };
  std::map<Corners, int> count;
  for (const Corners& c : mesh.plain.triangles) ++count[sorted(c)];
  return triangles_that(mesh, [&](Index, const Corners& c) { return count[sorted(c)] > 1; });
}

Triangles at_edges_with_too_many(const ExactMesh& mesh) {
  Triangles found;
  for (const auto& [e, at] : mesh.triangles_at) {
    const auto left = std::ranges::count_if(
        at, [&, &ends = e](Index t) { return is_left_of(mesh.plain.triangles[t], ends[0], ends[1]); });
    if (left > 1 || static_cast<std::size_t>(left) + 1 < at.size()) found.insert(at.begin(), at.end());
  }
  return found;
}

Edges with_wrong_neighbours(const ExactMesh& mesh) {
  Edges found;
  for (Index t = 0; t < mesh.plain.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Edge e = ref::edge_of(mesh.plain.triangles[t], i);
      Index across = no_index;
      for (const Index other : mesh.triangles_at.at(e))
        if (other != t) across = other;
      if (mesh.given.triangles[t].n[i] != across) found.insert(e);
    }
  return found;
}

Triangles larger_than(const ExactMesh& mesh, double max_area) {
  if (!std::isfinite(max_area)) return {};
  return triangles_that(mesh, [&](Index, const Corners& c) { return ref::area(mesh.plain, c) > max_area; });
}

Triangles with_larger_circumradius_than(const ExactMesh& mesh, double radius) {
  if (!(radius > 0) || !std::isfinite(radius)) return {};
  return triangles_that(mesh, [&](Index, const Corners& c) {
    return ref::squared_circumradius(mesh.plain, c) > Number(radius) * radius;
  });
}

Triangles longer_than_sizes(const ExactMesh& mesh, const std::function<double(Point)>& size) {
  if (!size) return {};
  return triangles_that(mesh, [&](Index t, const Corners& c) {
    // The centroid is rounded as check.hpp says.
    const auto& v = mesh.given.triangles[t].v;
    const Point a = mesh.given.points[v[0]], b = mesh.given.points[v[1]], d = mesh.given.points[v[2]];
    const double allowed = size({(a.x + b.x + d.x) / 3, (a.y + b.y + d.y) / 3});
    return !(allowed > 0) || has_edge_longer_than(mesh, c, allowed);
  });
}

Edges longer_than(const ExactMesh& mesh, double max_edge) {
  Edges found;
  for (const auto& [e, at] : mesh.triangles_at)
    if (std::isfinite(max_edge) && squared_length(mesh, e) > Number(max_edge) * max_edge) found.insert(e);
  return found;
}

Edges not_locally_delaunay(const ExactMesh& mesh) {
  Edges found;
  for (const auto& [e, at] : mesh.triangles_at) {
    if (at.size() != 2) continue;
    const Corners& other = mesh.plain.triangles[at[1]];
    const Index apex = *std::ranges::find_if(other, [&ends = e](Index v) { return v != ends[0] && v != ends[1]; });
    if (ref::circumdisk_contains(mesh.plain, mesh.plain.triangles[at[0]], mesh.plain.points[apex])) found.insert(e);
  }
  return found;
}

std::set<Index> missing_inputs(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  std::set<Index> found;
  for (Index i = 0; i < pslg.points.size(); ++i) {
    const bool is_vertex = i < mesh.given.points.size();
    const bool was_moved = is_vertex && mesh.given.points[i] != pslg.points[i];
    const bool is_used = is_vertex && mesh.has_triangle[i];
    if (was_moved || (!is_used && faces.contains(ref::exact(pslg.points[i])))) found.insert(i);
  }
  return found;
}

std::set<Index> unused_points(const ExactMesh& mesh, const Pslg& pslg) {
  std::set<Index> found;
  for (std::size_t v = pslg.points.size(); v < mesh.given.points.size(); ++v)
    if (!mesh.has_triangle[v]) found.insert(static_cast<Index>(v));
  return found;
}

namespace {

Number area(const ExactMesh& mesh) {
  Number sum = 0;
  for (const Corners& c : mesh.plain.triangles) sum += ref::area(mesh.plain, c);
  return sum;
}

}  // namespace

bool covers_domain(const ExactMesh& mesh, const InputFaces& faces) {
  const auto& p = mesh.plain.points;
  return area(mesh) == faces.area() && std::ranges::all_of(mesh.plain.triangles, [&](const Corners& c) {
           return faces.is_inside(faces.face_at(CGAL::centroid(p[c[0]], p[c[1]], p[c[2]])));
         });
}

std::set<Index> with_another_border(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  std::vector<std::size_t> of_mesh(mesh.given.points.size()), of_domain(pslg.points.size());
  for (const auto& [e, at] : mesh.triangles_at)
    if (at.size() == 1)
      for (const Index end : e) ++of_mesh[end];
  for (const Wall& wall : faces.walls())
    if (wall.sides_inside() == 1)
      for (const Index end : {wall.a, wall.b}) ++of_domain[end];
  std::set<Index> found;
  for (Index v = 0; v < of_mesh.size(); ++v) {
    const bool is_right = v < of_domain.size() ? of_mesh[v] == of_domain[v] : of_mesh[v] == 0 || of_mesh[v] == 2;
    if (!is_right) found.insert(v);
  }
  return found;
}

}  // namespace pardel::fuzz
