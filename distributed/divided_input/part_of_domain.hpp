// The part of a rank in the domain of given points, ready for refinement.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../../parallel/construction/domain_triangulation.hpp"
#include "../../parallel/threads/threads.hpp"
#include "../delaunay/triangulated_points.hpp"
#include "../subdomain/names.hpp"

namespace pardel::engine {

/// The part of a rank has the triangles of the domain with a corner that the rank owns. Common vertices and segments
/// (CommonVertices, DividedSegments) come first, and have the same indices on all ranks. Then follow the rank's other
/// points, then other corners of its triangles, and ends of segments there. Of segments, those follow that the rank has
/// named, and then others that end at corners of its triangles.
struct PartOfDomain {
  DomainTriangulation domain;  ///< input_of_vertex has only the common vertices
  Index common = 0;            ///< the number of common vertices
  Index common_segments = 0;   ///< the same of segments
  /// Of the common vertices, and then of the rank's others: their numbers and markers in the input.
  Array<std::uint64_t> number;
  Array<int> marker;         ///< empty if points have no markers
  std::uint64_t points = 0;  ///< of all ranks
  /// Triangles without an own corner, across constrained sides of the others. Whether such a side is encroached on can
  /// depend on them. They have no names.
  std::vector<TriangleId> halo;
  /// The rank's points that are in no triangle and not common.
  std::vector<VertexId> loose;
  // What other ranks have named:
  std::vector<std::pair<VertexId, Name>> named_vertices;
  std::vector<std::pair<TriangleId, Name>> named_triangles;
  std::vector<std::pair<Index, Name>> named_segments;
  /// Sides of triangles whose neighbours are not in the part. They refer to none; the bit tells whether they are
  /// constrained.
  std::vector<EdgeRef> cut;
};

/// What a rank has read of the domain, apart from its points.
struct ReadDomain {
  const PartOfSegments& segments;
  const Pslg& rest;  ///< holes and regions
};

/// Collective. Uses up the triangulation. The domain is the convex hull of the points of all ranks if `convex_hull` is
/// true or there are no segments. Precondition: all triangles with an own corner are those of the triangulation of all
/// points (resolve_halo()). Error: `invalid_input`, with all problems, on all ranks alike.
[[nodiscard]] Result<PartOfDomain> part_of_domain(TriangulatedPoints& points, const ReadDomain& read, bool convex_hull,
                                                  Ranks& ranks, const Threads& threads);

}  // namespace pardel::engine
