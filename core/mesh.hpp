// Mesh: triangles, their neighbours, and the part of the input from which each vertex, edge and triangle comes.
#pragma once

#include <array>
#include <vector>

#include "array.hpp"
#include "pslg.hpp"

namespace pardel {

/// v: the corners, counter-clockwise. n: the neighbours; n[i] is the triangle beyond the edge opposite v[i], that is
/// the edge from v[(i+1)%3] to v[(i+2)%3], or no_index if there is none.
struct Triangle {
  std::array<Index, 3> v{no_index, no_index, no_index};
  std::array<Index, 3> n{no_index, no_index, no_index};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// An edge of the mesh that may not be flipped. It is a piece of an input segment, or an edge of the convex hull if the
/// hull is the domain; then segment == no_index. The marker follows Triangle's rule: it is the segment's own marker if
/// that is not zero, else 1 on the boundary of the domain, else 0.
struct ConstrainedEdge {
  Index a = 0;
  Index b = 0;
  Index segment = no_index;
  int marker = 0;
  friend bool operator==(const ConstrainedEdge&, const ConstrainedEdge&) = default;
};

/// The origin of a vertex, in Mesh::origin: an input point, a point inserted inside a face, a point inserted on an edge
/// of the convex hull that is no segment, or, any smaller value, the index of the segment on which it was inserted.
inline constexpr Index input_vertex = no_index;
inline constexpr Index interior_vertex = no_index - 1;
inline constexpr Index hull_vertex = no_index - 2;

struct Mesh {
  Array<Point> points;  ///< input points first, in their order, then Steiner points
  Array<Triangle> triangles;
  Array<Index> origin;  ///< one per point; empty if unknown, as in a mesh read from a file
  Array<Index> region;  ///< one per triangle: an index into region_attributes, or no_index; or empty
  std::vector<double> region_attributes;
  std::vector<ConstrainedEdge> constrained_edges;
  std::size_t attributes_per_point = 0;
  Array<double> point_attributes;  ///< row by row
  Array<int> point_markers;        ///< empty, or one per point
  FirstId first_id{};              ///< of the file that the mesh was read from

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace pardel
