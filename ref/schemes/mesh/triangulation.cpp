#include "triangulation.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "../../../core/support/point_order.hpp"
#include "extent.hpp"
#include "forced_segments.hpp"
#include "predicates.hpp"
#include "triangle.hpp"

namespace pardel::schemes {
namespace {

/// The place of p on a curve that fills the extent (Morton's), so that points with close places are close.
std::uint64_t place_on_curve(Point p, const Extent& extent) {
  const auto spread = [](double share) {
    auto bits = static_cast<std::uint64_t>(share * 0x1p31);
    std::uint64_t result = 0;
    for (unsigned k = 0; k < 32; ++k) result |= (bits >> k & 1U) << 2 * k;
    return result;
  };
  const double width = extent.side() > 0 ? extent.side() : 1;
  return spread((p.x - extent.low.x) / width) | spread((p.y - extent.low.y) / width) << 1U;
}

/// Two triangles that cover a square around all points. Its corners are the last four points.
LinkedMesh box_around(const std::vector<Point>& points) {
  const Extent e = extent_of(points);
  const double reach = std::max({e.side(), 0x1p-20 * std::abs(e.low.x), 0x1p-20 * std::abs(e.low.y)}) * 16;
  const auto first = static_cast<Index>(points.size());
  LinkedMesh mesh{points, std::vector<Index>(points.size(), no_segment), {}, {}};
  const double left = e.low.x - reach, right = e.high.x + reach, low = e.low.y - reach, high = e.high.y + reach;
  for (const Point corner : {Point{left, low}, Point{right, low}, Point{right, high}, Point{left, high}})
    mesh.points.push_back(corner);
  mesh.faces.push_back({{first, first + 1, first + 2}, {no_index, 1, no_index}});
  mesh.faces.push_back({{first, first + 2, first + 3}, {no_index, no_index, 0}});
  return mesh;
}

/// Inserts the vertex v of a triangulation without constraints. `last`: a triangle near it; becomes one at v.
void insert_vertex(Triangulated& t, Index v, Index& last) {
  LinkedMesh& mesh = t.mesh;
  const Index at = locate(mesh, mesh.points[v], last, t.work);
  std::vector<Index> starts = {at};
  // A point on a side lies on the border of the open circumdisks, but the neighbour is part of its cavity.
  for (int i = 0; i < 3; ++i) {
    const auto [a, b] = ends(mesh, {at, i});
    if (mesh.faces[at].n[i] != no_index && orientation(mesh.points[a], mesh.points[b], mesh.points[v]) == 0)
      starts.push_back(mesh.faces[at].n[i]);
  }
  const Cavity cavity = cavity_of(mesh, mesh.points[v], starts);
  t.work += cavity.triangles.size() + cavity.boundary.size();
  last = replace(mesh, cavity, v).front();
}

Triangulated delaunay_in_box(const std::vector<Point>& points) {
  Triangulated t{box_around(points), 0};
  const Extent extent = extent_of(points);
  std::vector<std::pair<std::uint64_t, Index>> order;
  for (Index v = 0; v < points.size(); ++v) order.emplace_back(place_on_curve(points[v], extent), v);
  std::ranges::sort(order);
  Index last = 0;
  for (const auto& [place, v] : order) insert_vertex(t, v, last);
  return t;
}

/// Marks the triangles that can be reached from `start` without crossing a constrained side.
void spread(const LinkedMesh& mesh, Index start, Index value, std::vector<Index>& values) {
  std::vector<Index> frontier = {start};
  while (!frontier.empty()) {
    const Index t = frontier.back();
    frontier.pop_back();
    if (values[t] == value) continue;
    values[t] = value;
    for (int i = 0; i < 3; ++i)
      if (const Index other = mesh.faces[t].n[i]; other != no_index && !is_constrained(mesh, {t, i}))
        frontier.push_back(other);
  }
}

/// Removes the outside and the holes, and the corners of the box; gives triangles their regions.
void carve(LinkedMesh& mesh, const Pslg& pslg) {
  std::vector<Index> values(mesh.faces.size(), no_index);
  const auto corner = static_cast<Index>(pslg.points.size());
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (std::ranges::any_of(mesh.faces[t].v, [&](Index v) { return v >= corner; }))
      spread(mesh, t, removed_face, values);
  for (const Point hole : pslg.holes)
    if (const Index t = triangle_around(mesh, hole); t != no_index) spread(mesh, t, removed_face, values);
  for (Index r = 0; r < pslg.regions.size(); ++r)
    if (const Index t = triangle_around(mesh, pslg.regions[r].seed); t != no_index && values[t] != removed_face)
      spread(mesh, t, r + 1, values);
  mesh.points.resize(pslg.points.size());
  keep_faces(mesh, values);
}

}  // namespace

std::vector<std::array<Index, 2>> hull_of(const std::vector<Point>& points) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, [&](Index v, Index w) { return lexicographically_less(points[v], points[w]); });
  std::vector<std::array<Index, 2>> edges;
  for (int half = 0; half < 2; ++half) {
    std::vector<Index> chain;
    for (const Index v : order) {
      while (chain.size() >= 2 && orientation(points[chain[chain.size() - 2]], points[chain.back()], points[v]) < 0)
        chain.pop_back();
      chain.push_back(v);
    }
    for (std::size_t k = 1; k < chain.size(); ++k) edges.push_back({chain[k - 1], chain[k]});
    std::ranges::reverse(order);
  }
  return edges;
}

Index triangle_around(const LinkedMesh& mesh, Point p) {
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t) && covers(mesh, t, p)) return t;
  return no_index;
}

void keep_faces(LinkedMesh& mesh, const std::vector<Index>& values) {
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    Face& face = mesh.faces[t];
    if (values[t] != no_index && values[t] != removed_face) face.region = values[t] - 1;
    for (Index& n : face.n)
      if (n != no_index && values[n] == removed_face) n = no_index;
  }
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (values[t] == removed_face) mesh.faces[t] = {};
  compact(mesh);
}

Index locate(const LinkedMesh& mesh, Point p, Index from, std::uint64_t& work) {
  for (Index t = from;; ++work) {
    int leave = -1;
    for (int i = 0; i < 3 && leave < 0; ++i) {
      const auto [a, b] = ends(mesh, {t, i});
      if (orientation(mesh.points[a], mesh.points[b], p) < 0) leave = i;
    }
    if (leave < 0) return t;
    t = mesh.faces[t].n[leave];
    if (t == no_index) return no_index;
  }
}

Result<Triangulated> triangulation_of(const Pslg& pslg) {
  const Error empty{ErrorKind::invalid_input, "The domain has no triangle."};
  if (pslg.points.size() < 3) return empty;
  Triangulated result = delaunay_in_box(pslg.points);
  LinkedMesh& mesh = result.mesh;
  TriangleAt at(mesh);
  if (pslg.segments.empty()) mesh.segments = hull_of(pslg.points);
  for (const Segment& s : pslg.segments) mesh.segments.push_back({s.a, s.b});
  for (Index s = 0; s < mesh.segments.size(); ++s)
    result.work += force(mesh, at, mesh.segments[s][0], mesh.segments[s][1], s);
  carve(mesh, pslg);
  if (mesh.faces.empty()) return empty;
  return result;
}

}  // namespace pardel::schemes
