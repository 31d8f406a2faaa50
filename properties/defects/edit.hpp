// Edits: small changes to a mesh after which neighbours, lists and per-triangle values are still consistent. Seeded
// defects are combinations of edits, so that the defect is the only error. Every function takes time linear in the size
// of the mesh.
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "../../core/mesh.hpp"

namespace pardel::defects::edit {

/// A side of a triangle: the edge opposite corner i of triangle t.
struct Side {
  Index t = no_index;
  int i = 0;
};
[[nodiscard]] inline Index tail(const Mesh& mesh, Side s) { return mesh.triangles[s.t].v[(s.i + 1) % 3]; }
[[nodiscard]] inline Index head(const Mesh& mesh, Side s) { return mesh.triangles[s.t].v[(s.i + 2) % 3]; }
[[nodiscard]] inline Index apex(const Mesh& mesh, Side s) { return mesh.triangles[s.t].v[s.i]; }
[[nodiscard]] inline Index across(const Mesh& mesh, Side s) { return mesh.triangles[s.t].n[s.i]; }
/// The side of the neighbour at the same edge. Precondition: the neighbour exists.
[[nodiscard]] Side opposite(const Mesh& mesh, Side s);

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear. Exact.
[[nodiscard]] int orientation(const Mesh& mesh, Index a, Index b, Index c);
[[nodiscard]] double area(const Mesh& mesh, Index t);
[[nodiscard]] double length(const Mesh& mesh, Index a, Index b);
[[nodiscard]] Point centroid(const Mesh& mesh, Index t);
/// The point a + share * (b - a).
[[nodiscard]] Point between(Point a, Point b, double share = 0.5);
[[nodiscard]] double smallest_angle_deg(const Mesh& mesh, Index t);

/// The triangles at v, ascending.
[[nodiscard]] std::vector<Index> star(const Mesh& mesh, Index v);
[[nodiscard]] std::vector<Index> neighbour_vertices(const Mesh& mesh, Index v);
/// The ends of the constrained edges, lower end first.
[[nodiscard]] std::set<std::pair<Index, Index>> constrained(const Mesh& mesh);
[[nodiscard]] std::pair<Index, Index> ends(Index a, Index b);
/// A number for each triangle. Two triangles have the same number if no constrained edge separates them.
[[nodiscard]] std::vector<Index> faces(const Mesh& mesh);

/// Computes all neighbours from the corners of the triangles.
void relink(Mesh& mesh);
/// Removes triangles; the others keep their order.
void erase_triangles(Mesh& mesh, const std::vector<Index>& ids);
/// Appends a triangle without neighbours; call relink() when the last triangle was appended.
void append_triangle(Mesh& mesh, std::array<Index, 3> v, Index region = no_index);
[[nodiscard]] Index region_of(const Mesh& mesh, Index t);
/// A number that differs from this one, however large it is.
[[nodiscard]] inline double another_number(double x) { return x + 1 != x ? x + 1 : -x; }
/// Appends a point with marker 0 and attributes 0, and returns its index.
Index append_point(Mesh& mesh, Point p, Index origin = interior_vertex);
/// Moves a vertex. If suits() is false afterwards, moves the vertex back and returns false.
template <class Suits>
bool move(Mesh& mesh, Index v, Point to, const Suits& suits) {
  const Point from = std::exchange(mesh.points[v], to);
  if (suits()) return true;
  mesh.points[v] = from;
  return false;
}
/// Removes point v; the last point gets the number v. Precondition: v has no triangles.
void erase_unused_point(Mesh& mesh, Index v);
/// Point v gets the number to[v]. Precondition: `to` is a permutation.
void renumber(Mesh& mesh, const std::vector<Index>& to);

/// Replaces the edge by the other diagonal of its two triangles. Changes nothing and returns false if the edge is on
/// the boundary or the two triangles do not form a strictly convex quadrilateral.
bool flip(Mesh& mesh, Side s);
/// Inserts a vertex at p, with edges to the three corners of t, and returns it. Precondition: p is strictly inside t.
Index split_triangle(Mesh& mesh, Index t, Point p);
/// Replaces v by its neighbour `to` in all triangles; the triangles with both corners disappear. Changes nothing and
/// returns false if a triangle would not be counter-clockwise. Precondition: v is interior and on no constrained edge.
bool collapse(Mesh& mesh, Index v, Index to);

}  // namespace pardel::defects::edit
