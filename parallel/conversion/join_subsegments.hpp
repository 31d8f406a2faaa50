// Recovers the segments of a domain from the constrained edges of a mesh (subsegments). A new refinement then continues
// like the one that made the mesh, because shells around an apex and exemptions belong to segments, not to subsegments.
#pragma once

#include <span>
#include <vector>

#include "../../core/mesh.hpp"
#include "../segments/segment_pieces.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

struct JoinedSegments {
  std::vector<Constraint> segments;
  std::vector<Index> subsegment;  ///< for each segment, its first subsegment
  SegmentPieces pieces;           ///< the subsegments of each segment
  /// Per vertex of the mesh: origin_on_segment() of the segment in whose interior it lies; else interior_vertex if this
  /// is its origin in the mesh; else input_vertex.
  Array<Index> origin;
};

/// Two subsegments are joined at a vertex where they continue each other on a straight line and no other subsegment
/// ends (core/support/straight_points.hpp): a vertex may be as far from the line as rounding can explain, twice the
/// distance from one double to the next in each coordinate. Only the coordinates count, because no file contains the
/// origins of vertices. So input points between two collinear segments are joined, too. O(vertices + n log n) for n
/// subsegments on typical input.
[[nodiscard]] JoinedSegments join_subsegments(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments,
                                              const Threads& threads = {});

}  // namespace pardel::engine
