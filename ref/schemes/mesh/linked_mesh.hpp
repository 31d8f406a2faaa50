// A constrained Delaunay mesh of a domain as plain values: triangles that know their neighbours. All schemes of this
// folder work on it. It serves the same definitions as ref::PlainMesh (../../definitions.hpp) in constant time per
// triangle, so a mesh may have a million of them.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "../../edge.hpp"

namespace pardel::schemes {

using ref::Corners;

/// Stands for "on no segment".
inline constexpr Index no_segment = no_index;

/// A triangle. Entry i of an array is about corner v[i], or about the side opposite to it, from v[i + 1] to v[i + 2].
struct Face {
  Corners v{no_index, no_index, no_index};               ///< counter-clockwise; no_index in a slot that is not in use
  std::array<Index, 3> n{no_index, no_index, no_index};  ///< neighbours; no_index on the border of the domain
  std::array<Index, 3> segment{no_segment, no_segment, no_segment};
  Index region = no_index;  ///< of the input
};

struct LinkedMesh {
  std::vector<Point> points;  ///< the input points, then the others in the order of their insertion
  /// The segment that each point splits; no_segment for input points and for points inside faces.
  std::vector<Index> segment_of;
  std::vector<Face> faces;
  /// The ends of all segments: those of the input or, of a domain without segments, the edges of its convex hull.
  std::vector<std::array<Index, 2>> segments;

  [[nodiscard]] bool in_use(Index t) const { return faces[t].v[0] != no_index; }
  [[nodiscard]] Point corner(Index t, int i) const { return points[faces[t].v[i]]; }
};

/// The side opposite to corner i of a triangle.
struct Side {
  Index triangle = no_index;
  int i = 0;
  friend bool operator==(const Side&, const Side&) = default;
};

/// The side from v[i + 1] to v[i + 2], with the triangle on its left.
[[nodiscard]] inline std::array<Index, 2> ends(const LinkedMesh& mesh, Side side) {
  const Corners& v = mesh.faces[side.triangle].v;
  return {v[(side.i + 1) % 3], v[(side.i + 2) % 3]};
}
[[nodiscard]] inline bool is_constrained(const LinkedMesh& mesh, Side side) {
  return mesh.faces[side.triangle].segment[side.i] != no_segment;
}
/// The same side as the neighbour sees it. Precondition: there is a neighbour.
[[nodiscard]] Side across(const LinkedMesh& mesh, Side side);

/// The triangles at a side: two inside the domain, one on its border.
[[nodiscard]] std::vector<Index> triangles_at(const LinkedMesh& mesh, Side side);

[[nodiscard]] bool circumdisk_contains(const LinkedMesh& mesh, Index t, Point p);

/// A set of triangles that are connected across sides, and the sides between them and the other triangles, each as the
/// triangle of the set sees it.
struct Cavity {
  std::vector<Index> triangles;
  std::vector<Side> boundary;
  /// Is t one of the triangles? Linear time: a cavity has few.
  [[nodiscard]] bool contains(Index t) const { return std::ranges::find(triangles, t) != triangles.end(); }
};

/// The sides between these triangles and others, and their constrained sides.
[[nodiscard]] std::vector<Side> boundary_of(const LinkedMesh& mesh, const std::vector<Index>& triangles);

/// The triangles that can be reached from `starts` across unconstrained sides, and whose open circumdisks contain p.
/// The starts belong to the set in any case. If some start's circumdisk contains p and p sees it, or if p splits a side
/// of the starts, this is C(p), the cavity of p [CC]. Linear time in its size.
[[nodiscard]] Cavity cavity_of(const LinkedMesh& mesh, Point p, const std::vector<Index>& starts);

/// Are the triangles positively oriented that join p to the boundary of the cavity? The side `split` has none.
[[nodiscard]] bool can_be_connected(const LinkedMesh& mesh, const Cavity& cavity, Point p, Side split = {});

/// Replaces the cavity by the triangles that join `vertex` to the sides of its boundary (Bowyer and Watson). If `split`
/// is a side of the cavity's boundary that the vertex divides, it gets no triangle; its halves are pieces of the same
/// segment. If it is inside the cavity, its halves become constrained edges between the new triangles. Returns the new
/// triangles. Precondition: can_be_connected().
std::vector<Index> replace(LinkedMesh& mesh, const Cavity& cavity, Index vertex, Side split = {});

/// Exchanges the diagonal of the two triangles at an unconstrained side. Precondition: their union is strictly convex.
void flip(LinkedMesh& mesh, Side side);

/// Puts all triangles in use at the front, in their order, and numbers them anew.
void compact(LinkedMesh& mesh);

}  // namespace pardel::schemes
