// Small changes to a mesh that keep everything else about it consistent: links, lists and per-triangle
// values follow. Seeded defects are made of them, so that a defect is the only thing wrong. Each costs
// time linear in the mesh.
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

/// +1 where a, b, c turn left, exactly.
[[nodiscard]] int orientation(const Mesh& mesh, Index a, Index b, Index c);
[[nodiscard]] double area(const Mesh& mesh, Index t);
[[nodiscard]] double length(const Mesh& mesh, Index a, Index b);
[[nodiscard]] Point centroid(const Mesh& mesh, Index t);
[[nodiscard]] Point between(Point a, Point b, double share = 0.5);
[[nodiscard]] double smallest_angle_deg(const Mesh& mesh, Index t);

/// The triangles at v, ascending.
[[nodiscard]] std::vector<Index> star(const Mesh& mesh, Index v);
[[nodiscard]] std::vector<Index> neighbour_vertices(const Mesh& mesh, Index v);
/// The constrained edges, lower end first.
[[nodiscard]] std::set<std::pair<Index, Index>> constrained(const Mesh& mesh);
[[nodiscard]] std::pair<Index, Index> ends(Index a, Index b);
/// For each triangle the number of its face: what can be reached without crossing a constrained edge.
[[nodiscard]] std::vector<Index> faces(const Mesh& mesh);

void relink(Mesh& mesh);
/// The triangles keep their order otherwise.
void erase_triangles(Mesh& mesh, const std::vector<Index>& ids);
/// Links are not rebuilt: relink() after the last one.
void append_triangle(Mesh& mesh, std::array<Index, 3> v, Index region = no_index);
[[nodiscard]] Index region_of(const Mesh& mesh, Index t);
/// With marker 0 and attributes 0.
Index append_point(Mesh& mesh, Point p, Index origin = interior_vertex);
/// v must be without triangles; the last point takes its number.
void erase_unused_point(Mesh& mesh, Index v);
/// Gives the points new numbers: point v becomes to[v], a permutation.
void renumber(Mesh& mesh, const std::vector<Index>& to);

/// Replaces the edge by the other diagonal. False, and nothing done, where the two triangles do not make a
/// strictly convex quadrilateral, or there is no neighbour.
bool flip(Mesh& mesh, Side s);
/// Puts a new vertex into the triangle, and edges to its corners; p must lie strictly inside.
Index split_triangle(Mesh& mesh, Index t, Point p);
/// Moves every edge at v (which is interior, on no constrained edge) to its neighbour `to`, so that v is left
/// without triangles; false, and nothing done, where that would turn a triangle over.
bool collapse(Mesh& mesh, Index v, Index to);

}  // namespace pardel::defects::edit
