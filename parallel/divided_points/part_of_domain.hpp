// The part of a rank in the domain of given points, ready for refinement.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../concurrency/threads.hpp"
#include "../conversion/domain_triangulation.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"
#include "../parts/names.hpp"

namespace pardel::engine {

/// The part of a rank has the triangles of the domain with a corner that the rank owns. All ranks have all segments.
/// The ends of segments and the vertices of the convex hull (CommonVertices) come first, and have the same indices on
/// all ranks. Then follow the rank's other points, then other corners of its triangles.
struct PartOfDomain {
  DomainTriangulation domain;  ///< input_of_vertex has only the common vertices
  Index common = 0;            ///< the number of common vertices
  /// Of the common vertices, and then of the rank's others: their numbers and markers in the input.
  Array<std::uint64_t> number;
  Array<int> marker;         ///< empty if points have no markers
  std::uint64_t points = 0;  ///< of all ranks
  /// Triangles without an own corner, across constrained sides of the others. Whether such a side is encroached on can
  /// depend on them. They have no names.
  std::vector<TriangleId> borrowed;
  /// The rank's points that are in no triangle and not common.
  std::vector<VertexId> loose;
  // What other ranks have named:
  std::vector<std::pair<VertexId, Name>> named_vertices;
  std::vector<std::pair<TriangleId, Name>> named_triangles;
  /// Sides of triangles whose neighbours are not in the part. They refer to none; the bit tells whether they are
  /// constrained.
  std::vector<EdgeRef> cut;
};

/// Collective. Uses up the triangulation. `rest`: segments, holes and regions. The domain is the convex hull of the
/// points of all ranks if `convex_hull` is true or there are no segments. Precondition: all triangles with an own
/// corner are those of the triangulation of all points (ask_others()). Error: `invalid_input`, with problems of the
/// segments, holes and regions, on all ranks alike.
[[nodiscard]] Result<PartOfDomain> part_of_domain(LocalDelaunay& delaunay, const OwnPoints& own, const Pslg& rest,
                                                  bool convex_hull, Ranks& ranks, const Threads& threads);

}  // namespace pardel::engine
