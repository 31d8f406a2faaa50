// What the pieces of a mesh say about their vertices: numbers in the whole mesh, markers, and which pieces share them.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "../conversion/domain_triangulation.hpp"
#include "distribution.hpp"
#include "members.hpp"

namespace pardel::engine {

/// The data of the vertices of a piece. The owner of a vertex (Distribution::owner_of) holds all triangles around it,
/// so it knows everything about it. Each rank asks the owners about its other vertices.
struct VertexData {
  /// Per vertex of the triangulation, its number in the whole mesh: input points first, in the order of the input, then
  /// the others, cell by cell along the curve of the ownership, and by coordinates in each cell. The numbers do not
  /// depend on the number of ranks. Undefined for vertices that are not in the piece.
  Array<std::uint64_t> number;
  Array<int> marker;  ///< per vertex, as Mesh::point_markers
  /// For vertices at the border: the ranks whose pieces contain the vertex, ascending.
  std::unordered_map<VertexId, std::vector<int>> pieces;
  std::uint64_t first = 0;  ///< the first number of a vertex that this rank owns, except for input points
  std::uint64_t count = 0;  ///< the number of points of the whole mesh
};

/// Collective. Takes the cells of `members`. `input_markers`: per input point, or empty.
[[nodiscard]] VertexData vertex_data(const DomainTriangulation& domain, const Distribution& distribution,
                                     Members& members, std::span<const int> input_markers, const Threads& threads);

}  // namespace pardel::engine
