#include "constrained.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "insertion.hpp"

namespace pardel::ref {
namespace {

/// The two triangles at the edge ab. `left` contains it in the direction a to b, `right` in the direction b to a; c and
/// d are their apexes.
struct Quadrilateral {
  Index left, right;
  Index a, b, c, d;
};

std::optional<Quadrilateral> around(const PlainMesh& mesh, const Edge& e) {
  Quadrilateral q{no_index, no_index, e[0], e[1], no_index, no_index};
  for (Index t = 0; t < mesh.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const Corners& v = mesh.triangles[t];
      const Index from = v[(i + 1) % 3], to = v[(i + 2) % 3];
      if (from == e[0] && to == e[1]) q.left = t, q.c = v[i];
      if (from == e[1] && to == e[0]) q.right = t, q.d = v[i];
    }
  if (q.left == no_index || q.right == no_index) return std::nullopt;  // on the hull
  return q;
}

bool are_counterclockwise(const PlainMesh& mesh, Index a, Index b, Index c) {
  return CGAL::left_turn(mesh.points[a], mesh.points[b], mesh.points[c]);
}

bool is_strictly_convex(const PlainMesh& mesh, const Quadrilateral& q) {
  return are_counterclockwise(mesh, q.d, q.b, q.c) && are_counterclockwise(mesh, q.c, q.a, q.d);
}

void flip(PlainMesh& mesh, const Quadrilateral& q) {
  mesh.triangles[q.left] = {q.d, q.b, q.c};
  mesh.triangles[q.right] = {q.c, q.a, q.d};
}

bool is_locally_delaunay(const PlainMesh& mesh, const Quadrilateral& q) {
  return !circumdisk_contains(mesh, mesh.triangles[q.left], mesh.points[q.d]);
}

std::set<Edge> edges(const PlainMesh& mesh) {
  std::set<Edge> all;
  for (const Corners& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) all.insert(edge_of(t, i));
  return all;
}

/// Do the open segments cross: are the ends of each strictly on different sides of the other?
bool cross(const PlainMesh& mesh, const Edge& e, const Edge& f) {
  const auto side = [&](const Edge& of, Index v) {
    return CGAL::orientation(mesh.points[of[0]], mesh.points[of[1]], mesh.points[v]);
  };
  return side(e, f[0]) * side(e, f[1]) == CGAL::NEGATIVE && side(f, e[0]) * side(f, e[1]) == CGAL::NEGATIVE;
}

}  // namespace

PlainMesh delaunay(const std::vector<Point>& points) {
  // On a lattice of spacing u and extent E, three points that are not collinear have a circumradius below E³ / u². So
  // no circumdisk of three points contains a corner of a box of this half-width.
  constexpr double half_width = 0x1p202;
  PlainMesh mesh = delaunay_in_box(points, half_width);
  std::erase_if(mesh.triangles, [&](const Corners& t) { return *std::ranges::max_element(t) >= points.size(); });
  mesh.points.resize(points.size());
  return mesh;
}

void force_edge(PlainMesh& mesh, Index a, Index b) {
  const Edge wanted = edge(a, b);
  std::deque<Edge> crossing;
  for (const Edge& e : edges(mesh))
    if (cross(mesh, wanted, e)) crossing.push_back(e);
  while (!crossing.empty()) {
    const Edge e = crossing.front();
    crossing.pop_front();
    const Quadrilateral q = *around(mesh, e);
    if (!is_strictly_convex(mesh, q)) {
      crossing.push_back(e);  // retry after a neighbour was flipped
      continue;
    }
    flip(mesh, q);
    if (cross(mesh, wanted, edge(q.c, q.d))) crossing.push_back(edge(q.c, q.d));
  }
  mesh.constraints.insert(wanted);
}

void flip_to_delaunay(PlainMesh& mesh) {
  const std::set<Edge> all = edges(mesh);
  std::deque<Edge> suspects(all.begin(), all.end());
  while (!suspects.empty()) {
    const Edge e = suspects.front();
    suspects.pop_front();
    if (mesh.constraints.contains(e)) continue;
    const auto q = around(mesh, e);
    if (!q || is_locally_delaunay(mesh, *q)) continue;
    flip(mesh, *q);
    for (const Edge& side : {edge(q->a, q->c), edge(q->c, q->b), edge(q->b, q->d), edge(q->d, q->a)})
      suspects.push_back(side);
  }
}

PlainMesh constrained_delaunay(const std::vector<Point>& points, const std::vector<Edge>& walls) {
  PlainMesh mesh = delaunay(points);
  for (const Edge& wall : walls) force_edge(mesh, wall[0], wall[1]);
  flip_to_delaunay(mesh);
  return mesh;
}

}  // namespace pardel::ref
