#include "edit.hpp"

#include <algorithm>

#include "../../core/neighbours.hpp"
#include "../checker/arithmetic/exact.hpp"
#include "../checker/arithmetic/measure.hpp"

namespace pardel::defects::edit {

Side opposite(const Mesh& mesh, Side s) {
  const Triangle& other = mesh.triangles[across(mesh, s)];
  for (int i = 0; i < 3; ++i)
    if (other.v[(i + 1) % 3] == head(mesh, s) && other.v[(i + 2) % 3] == tail(mesh, s)) return {across(mesh, s), i};
  return {};
}

int orientation(const Mesh& mesh, Index a, Index b, Index c) {
  return checker::exactly::orientation(mesh.points[a], mesh.points[b], mesh.points[c]);
}

double area(const Mesh& mesh, Index t) {
  const auto& v = mesh.triangles[t].v;
  return checker::doubled_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]) / 2;
}

double length(const Mesh& mesh, Index a, Index b) { return checker::distance(mesh.points[a], mesh.points[b]); }

Point centroid(const Mesh& mesh, Index t) {
  const auto& v = mesh.triangles[t].v;
  const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
}

Point between(Point a, Point b, double share) { return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share}; }

double smallest_angle_deg(const Mesh& mesh, Index t) {
  const auto& v = mesh.triangles[t].v;
  double smallest = 180;
  for (int i = 0; i < 3; ++i)
    smallest = std::min(
        smallest, checker::angle_deg(mesh.points[v[i]], mesh.points[v[(i + 1) % 3]], mesh.points[v[(i + 2) % 3]]));
  return smallest;
}

std::vector<Index> star(const Mesh& mesh, Index v) {
  std::vector<Index> ids;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    if (std::ranges::count(mesh.triangles[t].v, v) != 0) ids.push_back(t);
  return ids;
}

std::vector<Index> neighbour_vertices(const Mesh& mesh, Index v) {
  std::set<Index> found;
  for (Index t : star(mesh, v)) found.insert(mesh.triangles[t].v.begin(), mesh.triangles[t].v.end());
  found.erase(v);
  return {found.begin(), found.end()};
}

std::pair<Index, Index> ends(Index a, Index b) { return std::minmax(a, b); }

std::set<std::pair<Index, Index>> constrained(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const ConstrainedEdge& e : mesh.constrained_edges) edges.insert(ends(e.a, e.b));
  return edges;
}

std::vector<Index> faces(const Mesh& mesh) {
  const auto walls = constrained(mesh);
  std::vector<Index> face(mesh.triangles.size(), no_index);
  for (Index start = 0; start < face.size(); ++start) {
    std::vector<Index> frontier = {start};
    while (!frontier.empty()) {
      const Index t = frontier.back();
      frontier.pop_back();
      if (face[t] != no_index) continue;
      face[t] = start;
      for (int i = 0; i < 3; ++i) {
        const Side s{t, i};
        if (across(mesh, s) != no_index && !walls.contains(ends(tail(mesh, s), head(mesh, s))))
          frontier.push_back(across(mesh, s));
      }
    }
  }
  return face;
}

void relink(Mesh& mesh) { rebuild_neighbours(mesh.triangles, mesh.points.size()); }

void erase_triangles(Mesh& mesh, const std::vector<Index>& ids) {
  const std::set<Index> gone(ids.begin(), ids.end());
  Array<Triangle> triangles;
  Array<Index> regions;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    if (gone.contains(t)) continue;
    triangles.push_back(mesh.triangles[t]);
    if (!mesh.region.empty()) regions.push_back(mesh.region[t]);
  }
  mesh.triangles = std::move(triangles);
  mesh.region = std::move(regions);
  relink(mesh);
}

void append_triangle(Mesh& mesh, std::array<Index, 3> v, Index region) {
  if (!mesh.region.empty()) mesh.region.push_back(region);
  mesh.triangles.push_back({v, {no_index, no_index, no_index}});
}

Index region_of(const Mesh& mesh, Index t) { return mesh.region.empty() ? no_index : mesh.region[t]; }

Index append_point(Mesh& mesh, Point p, Index origin) {
  mesh.points.push_back(p);
  if (!mesh.origin.empty()) mesh.origin.push_back(origin);
  if (!mesh.point_markers.empty()) mesh.point_markers.push_back(0);
  mesh.point_attributes.resize(mesh.points.size() * mesh.attributes_per_point, 0);
  return static_cast<Index>(mesh.points.size() - 1);
}

void renumber(Mesh& mesh, const std::vector<Index>& to) {
  const Mesh old = mesh;
  for (Index v = 0; v < to.size(); ++v) {
    mesh.points[to[v]] = old.points[v];
    if (!old.origin.empty()) mesh.origin[to[v]] = old.origin[v];
    if (!old.point_markers.empty()) mesh.point_markers[to[v]] = old.point_markers[v];
    for (std::size_t k = 0; k < old.attributes_per_point; ++k)
      mesh.point_attributes[to[v] * old.attributes_per_point + k] =
          old.point_attributes[v * old.attributes_per_point + k];
  }
  for (Triangle& t : mesh.triangles)
    for (Index& v : t.v) v = to[v];
  for (ConstrainedEdge& e : mesh.constrained_edges) e = {to[e.a], to[e.b], e.segment, e.marker};
}

void erase_unused_point(Mesh& mesh, Index v) {
  const auto last = static_cast<Index>(mesh.points.size() - 1);
  std::vector<Index> to(mesh.points.size());
  for (Index u = 0; u < to.size(); ++u) to[u] = u == v ? last : u == last ? v : u;
  renumber(mesh, to);
  mesh.points.pop_back();
  if (!mesh.origin.empty()) mesh.origin.pop_back();
  if (!mesh.point_markers.empty()) mesh.point_markers.pop_back();
  for (std::size_t k = 0; k < mesh.attributes_per_point; ++k) mesh.point_attributes.pop_back();
}

bool flip(Mesh& mesh, Side s) {
  if (across(mesh, s) == no_index) return false;
  const Side o = opposite(mesh, s);
  if (o.t == no_index) return false;
  const Index a = tail(mesh, s), b = head(mesh, s), c = apex(mesh, s), d = apex(mesh, o);
  if (orientation(mesh, c, d, b) <= 0 || orientation(mesh, d, c, a) <= 0) return false;
  mesh.triangles[s.t].v = {c, d, b};
  mesh.triangles[o.t].v = {d, c, a};
  relink(mesh);
  return true;
}

Index split_triangle(Mesh& mesh, Index t, Point p) {
  const auto v = mesh.triangles[t].v;
  const Index region = region_of(mesh, t);
  const Index m = append_point(mesh, p);
  mesh.triangles[t].v = {v[0], v[1], m};
  append_triangle(mesh, {v[1], v[2], m}, region);
  append_triangle(mesh, {v[2], v[0], m}, region);
  relink(mesh);
  return m;
}

bool collapse(Mesh& mesh, Index v, Index to) {
  std::vector<Index> dying;
  Mesh changed = mesh;
  for (Index t : star(mesh, v)) {
    Triangle& triangle = changed.triangles[t];
    if (std::ranges::count(triangle.v, to) != 0) {
      dying.push_back(t);
      continue;
    }
    std::ranges::replace(triangle.v, v, to);
    if (orientation(changed, triangle.v[0], triangle.v[1], triangle.v[2]) <= 0) return false;
  }
  if (dying.size() != 2) return false;
  erase_triangles(changed, dying);
  mesh = std::move(changed);
  return true;
}

}  // namespace pardel::defects::edit
