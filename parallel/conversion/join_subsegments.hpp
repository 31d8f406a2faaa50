// The constrained edges of a mesh become the segments again that they are pieces of, so that its refinement goes
// on as if it had never stopped: shells about an apex and their exemptions belong to whole segments.
#pragma once

#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../triangulation/insert_constraints.hpp"

namespace pardel::engine {

struct Joined {
  std::vector<Constraint> lines;
  std::vector<Index> segment_of_line;  ///< as the pieces say
  std::vector<int> marker_of_line;
  /// Per vertex of the mesh: the line in whose interior it lies, else interior_vertex or input_vertex.
  Array<Index> origin;
};

/// Two pieces are joined at a vertex that was put on their segment (or on their hull edge), where no other piece
/// ends. A mesh without provenance keeps its pieces: each is a line. O(vertices + pieces).
[[nodiscard]] Joined join_pieces(const Mesh& mesh, std::span<const ConstrainedEdge> pieces);

}  // namespace pardel::engine
