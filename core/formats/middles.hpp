// The middles of edges, which elements of second order have as further nodes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "../support/mesh_edges.hpp"

namespace pardel::files {

/// The middles that a file has after the vertices of a mesh, each once.
struct Middles {
  Array<MarkedEdge> edges;     ///< the edge of each middle
  Array<Index> of_side;        ///< the middle of side 3t + i, which is opposite corner i of triangle t
  std::vector<Index> of_line;  ///< the middle of each constrained edge

  [[nodiscard]] Point point(const Mesh& mesh, std::size_t middle) const {
    const Point &a = mesh.points[edges[middle].a], &b = mesh.points[edges[middle].b];
    return {std::midpoint(a.x, b.x), std::midpoint(a.y, b.y)};
  }
  /// The mean of two of the numbers that the vertices have, so many each: number i of all middles.
  [[nodiscard]] double mean(const Array<double>& values, std::size_t components, std::size_t i) const {
    const std::size_t k = i % components;
    const MarkedEdge& edge = edges[i / components];
    return std::midpoint(values[edge.a * components + k], values[edge.b * components + k]);
  }
  /// The middles of triangle t in the order of Gmsh and of VTK: of its edges from corner 0 to 1, 1 to 2, 2 to 0.
  [[nodiscard]] std::array<Index, 3> of_triangle(std::size_t t) const {
    return {of_side[3 * t + 2], of_side[3 * t], of_side[3 * t + 1]};
  }
};

/// Those of all edges of triangles and of all constrained edges. Time O(n log c) for n edges, c of them constrained.
/// Precondition: Triangle::n is correct.
[[nodiscard]] Middles middles_of(const Mesh& mesh);

/// The fields of a mesh with values at the middles, after those at the vertices: the means of those at the ends.
[[nodiscard]] std::vector<Field> with_middles(std::vector<Field> fields, const Middles& middles);

/// A node of an element.
struct NumberedNode {
  std::uint64_t number = 0;  ///< in the file
  Point at;
};
/// Why a triangle or a line of second order is curved: its middle node is not in the middle of the edge from `a` to
/// `b`. Empty if it is, up to 1e-9 of the edge across it, 1e-3 along it, and 8 units in the last place of the
/// coordinates. That covers numbers rounded to 16 digits, and Gmsh, which finds middles of straight lines iteratively.
/// `unit`: one such unit at 1, that of float if the file has floats.
[[nodiscard]] std::string why_curved(NumberedNode middle, NumberedNode a, NumberedNode b,
                                     double unit = std::numeric_limits<double>::epsilon());

/// Removes the points that are only middles: is_middle[v] is not zero, and v is no corner of a triangle and no end of a
/// constrained edge. Their values go, too. The mesh keeps the numbers of the others, and what it lacks is listed in
/// Mesh::left_out. Returns the new index of each point, no_index for those that are removed.
std::vector<Index> remove_middles(Mesh& mesh, std::vector<char> is_middle);

}  // namespace pardel::files
