// Recovers the segments of a domain from the constrained edges of a mesh (subsegments). A new refinement then continues
// like the one that made the mesh, because shells around an apex and exemptions belong to segments, not to subsegments.
#pragma once

#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../concurrency/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

struct JoinedSegments {
  std::vector<Constraint> segments;
  std::vector<Index> input_segment;  ///< for each segment, ConstrainedEdge::segment of its subsegments
  std::vector<int> segment_marker;
  /// Per vertex of the mesh: origin_on_segment() of the segment in whose interior it lies, else interior_vertex or
  /// input_vertex.
  Array<Index> origin;
};

/// Two subsegments are joined at a vertex if the mesher inserted the vertex on their common segment (or hull edge) and
/// no other subsegment ends there. In a mesh without origins every subsegment is a segment. O(vertices + subsegments).
[[nodiscard]] JoinedSegments join_subsegments(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments,
                                              const Threads& threads = {});

}  // namespace pardel::engine
