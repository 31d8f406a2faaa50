// Mesh: triangles, their neighbours, and the part of the input from which each vertex, edge and triangle comes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "array.hpp"
#include "field.hpp"
#include "pslg.hpp"

namespace pardel {

/// v: the corners, counter-clockwise. n: the neighbours. n[i] is the triangle on the other side of the edge opposite
/// v[i], which joins v[(i+1)%3] and v[(i+2)%3], or no_index if there is no triangle.
struct Triangle {
  std::array<Index, 3> v{no_index, no_index, no_index};
  std::array<Index, 3> n{no_index, no_index, no_index};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// An edge of the mesh that may not be flipped: a piece of an input segment or, if the domain is the convex hull, an
/// edge of the hull, which has segment == no_index. The marker follows Triangle's rule: it is the segment's own marker
/// if that is not zero; otherwise it is 1 on the boundary of the domain and 0 elsewhere.
struct ConstrainedEdge {
  Index a = 0;
  Index b = 0;
  Index segment = no_index;
  int marker = 0;
  friend bool operator==(const ConstrainedEdge&, const ConstrainedEdge&) = default;
};

/// Values of Mesh::origin. input_vertex: an input point. interior_vertex: a point inserted inside a face. hull_vertex:
/// a point inserted on an edge of the convex hull that is not a segment. origin_on_segment(): a point inserted on a
/// segment. Nearly all points of a large mesh are in the interior. Their value is 0, because zeroes that nobody has
/// written take no memory (Array::zeroes).
inline constexpr Index interior_vertex = 0;
inline constexpr Index input_vertex = no_index;
inline constexpr Index hull_vertex = no_index - 1;
[[nodiscard]] constexpr Index origin_on_segment(Index segment) { return segment + 1; }
/// The segment of such an origin. Of the other origins: a number that is no segment, greater than all segments.
[[nodiscard]] constexpr Index segment_of_origin(Index origin) { return origin - 1; }

/// The numbers of the points in the file of a mesh, if they are not those that FirstId gives: the tags of a .msh. The
/// same for triangles: the numbers in a .2dm. Only messages use them. No result depends on them, so all values compare
/// equal.
struct NumbersInFile {
  std::vector<std::uint64_t> of_points;
  std::vector<std::uint64_t> of_triangles{};
  friend bool operator==(const NumbersInFile&, const NumbersInFile&) { return true; }
};

struct Mesh {
  Array<Point> points;  ///< input points first, in their order, then Steiner points
  Array<Triangle> triangles;
  Array<Index> origin;  ///< one per point; empty if unknown, as in a mesh read from a file
  Array<Index> region;  ///< one per triangle: an index into region_attributes, or no_index; or empty
  std::vector<double> region_attributes;
  std::vector<ConstrainedEdge> constrained_edges;
  std::size_t attributes_per_point = 0;
  Array<double> point_attributes;  ///< point by point: points.size() * attributes_per_point numbers
  Array<int> point_markers;        ///< empty, or one per point
  FirstId first_id{};              ///< the number of the first point in the file of the mesh
  NumbersInFile numbers{};         ///< empty, or one per point; empty, or one per triangle
  std::vector<Field> fields;       ///< their values are one per point or triangle and component
  std::vector<GroupName> names;    ///< at most one per marker and per region
  LeftOut left_out{};              ///< of the file of the mesh

  friend bool operator==(const Mesh&, const Mesh&) = default;
};

/// The number of a point in the file of a mesh.
[[nodiscard]] inline std::uint64_t number_in_file(const NumbersInFile& numbers, FirstId first_id, Index point) {
  const bool has_own = point < numbers.of_points.size();
  return has_own ? numbers.of_points[point] : std::uint64_t{point} + static_cast<unsigned>(first_id.value);
}
[[nodiscard]] inline std::uint64_t number_in_file(const Mesh& mesh, Index point) {
  return number_in_file(mesh.numbers, mesh.first_id, point);
}
/// The number of a triangle there.
[[nodiscard]] inline std::uint64_t number_of_triangle_in_file(const Mesh& mesh, Index triangle) {
  const std::vector<std::uint64_t>& own = mesh.numbers.of_triangles;
  return triangle < own.size() ? own[triangle] : std::uint64_t{triangle} + static_cast<unsigned>(mesh.first_id.value);
}

}  // namespace pardel
