// What the pieces of a mesh say about their vertices: numbers in the whole mesh, markers, and which pieces share them.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "../../parallel/construction/domain_triangulation.hpp"
#include "distribution.hpp"
#include "members.hpp"
#include "numbering.hpp"

namespace pardel::engine {

/// The data of the vertices of a piece. The owner of a vertex (Distribution::owner_of) holds all triangles around it,
/// so it knows its marker and its pieces. The rank that has inserted it knows its number. Each rank asks the others
/// about the vertices that it does not own, or has not inserted.
struct VertexData {
  /// For all vertices of the piece except input points, which have the numbers of the input. Then follow the vertices
  /// of the coarse levels, then, cell by cell along the curve of the ownership, those that the tasks of the cell have
  /// inserted, in the order of the insertions; last those of Communicator::refine_rest(), in the order of
  /// coordinates. The numbers do not depend on the number of ranks.
  VertexNumbers numbers;
  /// The vertices with a marker other than 0, as in Mesh::point_markers; some are not in the piece.
  struct Marker {
    VertexId v;
    int marker;
  };
  std::vector<Marker> markers;
  /// For vertices at the border: the ranks whose pieces contain the vertex, ascending.
  std::unordered_map<VertexId, std::vector<int>> pieces;
  std::uint64_t first = 0;  ///< as PieceOfMesh::first_point
  std::uint64_t count = 0;  ///< the number of points of the whole mesh
};

/// Collective.
[[nodiscard]] VertexData vertex_data(const DomainTriangulation& domain, const Distribution& distribution,
                                     const Members& members);

}  // namespace pardel::engine
