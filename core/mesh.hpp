// Mesh: triangles, their neighbours, and where every vertex, edge and triangle comes from.
#pragma once

#include <array>
#include <vector>

#include "array.hpp"
#include "pslg.hpp"

namespace pardel {

/// v: vertices, counter-clockwise. n: neighbours, n[i] shares the edge opposite v[i], that is
/// (v[(i+1)%3], v[(i+2)%3]); no_index where there is none.
struct Triangle {
  std::array<Index, 3> v{no_index, no_index, no_index};
  std::array<Index, 3> n{no_index, no_index, no_index};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// An edge of the mesh that may not be flipped: a piece of an input segment, or (segment == no_index) an
/// edge of the convex hull where the hull is the domain. The marker follows Triangle's rule: the
/// segment's own non-zero marker, else 1 on the boundary of the domain, else 0.
struct ConstrainedEdge {
  Index a = 0;
  Index b = 0;
  Index segment = no_index;
  int marker = 0;
  friend bool operator==(const ConstrainedEdge&, const ConstrainedEdge&) = default;
};

/// Provenance of a vertex, in Mesh::origin: one of these two, or the index of the segment it was put on.
/// (A vertex put on a hull edge that is no segment has origin `hull_vertex`.)
inline constexpr Index input_vertex = no_index;
inline constexpr Index interior_vertex = no_index - 1;
inline constexpr Index hull_vertex = no_index - 2;

struct Mesh {
  Array<Point> points;  ///< input points first, in their order, then Steiner points
  Array<Triangle> triangles;
  Array<Index> origin;  ///< one per point, or empty when unknown (a mesh read from a file)
  Array<Index> region;  ///< one per triangle, an index into region_attributes or no_index; or empty
  std::vector<double> region_attributes;
  std::vector<ConstrainedEdge> constrained_edges;
  std::size_t attributes_per_point = 0;
  Array<double> point_attributes;  ///< row by row
  Array<int> point_markers;        ///< empty, or one per point
  FirstId first_id{};              ///< of the file that the mesh was read from

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

}  // namespace pardel
