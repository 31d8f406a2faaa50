// Edits: small changes to a mesh after which neighbours, lists and per-triangle values are still consistent. Seeded
// defects are made of them, so that the defect is the only error. Every function takes time linear in the mesh.
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
/// The same edge seen from the neighbour, which must exist.
[[nodiscard]] Side opposite(const Mesh& mesh, Side s);

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are collinear. Exact.
[[nodiscard]] int orientation(const Mesh& mesh, Index a, Index b, Index c);
[[nodiscard]] double area(const Mesh& mesh, Index t);
[[nodiscard]] double length(const Mesh& mesh, Index a, Index b);
[[nodiscard]] Point centroid(const Mesh& mesh, Index t);
/// The point at this share of the way from a to b.
[[nodiscard]] Point between(Point a, Point b, double share = 0.5);
[[nodiscard]] double smallest_angle_deg(const Mesh& mesh, Index t);

/// The triangles at v, ascending.
[[nodiscard]] std::vector<Index> star(const Mesh& mesh, Index v);
[[nodiscard]] std::vector<Index> neighbour_vertices(const Mesh& mesh, Index v);
/// The ends of the constrained edges, lower end first.
[[nodiscard]] std::set<std::pair<Index, Index>> constrained(const Mesh& mesh);
[[nodiscard]] std::pair<Index, Index> ends(Index a, Index b);
/// A number for each triangle. Two triangles have the same number where no constrained edge separates them.
[[nodiscard]] std::vector<Index> faces(const Mesh& mesh);

/// Sets all neighbours from the corners.
void relink(Mesh& mesh);
/// Removes triangles; the others keep their order.
void erase_triangles(Mesh& mesh, const std::vector<Index>& ids);
/// Without neighbours: call relink() after the last one.
void append_triangle(Mesh& mesh, std::array<Index, 3> v, Index region = no_index);
[[nodiscard]] Index region_of(const Mesh& mesh, Index t);
/// Appends a point with marker 0 and attributes 0, and returns its index.
Index append_point(Mesh& mesh, Point p, Index origin = interior_vertex);
/// The last point takes the number v. Precondition: v has no triangles.
void erase_unused_point(Mesh& mesh, Index v);
/// Point v gets the number to[v]. Precondition: `to` is a permutation.
void renumber(Mesh& mesh, const std::vector<Index>& to);

/// Replaces the edge by the other diagonal of its two triangles. False, and nothing is changed, at the boundary and
/// where the two triangles do not form a strictly convex quadrilateral.
bool flip(Mesh& mesh, Side s);
/// Puts a new vertex at p, with edges to the three corners, and returns it. Precondition: p is strictly inside.
Index split_triangle(Mesh& mesh, Index t, Point p);
/// Moves every edge at v to its neighbour `to`, after which v has no triangles. False, and nothing is changed, where a
/// triangle would not be counter-clockwise afterwards. Precondition: v is interior, on no constrained edge.
bool collapse(Mesh& mesh, Index v, Index to);

}  // namespace pardel::defects::edit
