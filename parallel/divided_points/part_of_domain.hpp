// The part of a rank in the domain of given points, ready for refinement.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/array.hpp"
#include "../../core/ranks.hpp"
#include "../concurrency/threads.hpp"
#include "../conversion/domain_triangulation.hpp"
#include "../distribution/names.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"

namespace pardel::engine {

/// The domain is the convex hull of the points of all ranks. The part of a rank has the triangles with a corner that
/// the rank owns. The vertices of the hull are known to all ranks, because the segments of the domain join them: they
/// come first, and have the same indices on all ranks. Then follow the rank's other points, then other corners of its
/// triangles.
struct PartOfDomain {
  DomainTriangulation domain;  ///< input_of_vertex has only the vertices of the hull
  Index hull = 0;              ///< the number of vertices of the hull
  /// Of the vertices of the hull, and then of the rank's others: their numbers and markers in the input.
  Array<std::uint64_t> number;
  Array<int> marker;         ///< empty if points have no markers
  std::uint64_t points = 0;  ///< of all ranks
  // What other ranks have named:
  std::vector<std::pair<VertexId, Name>> named_vertices;
  std::vector<std::pair<TriangleId, Name>> named_triangles;
  std::vector<EdgeRef> cut;  ///< sides of triangles whose neighbours are not in the part; they refer to none
};

/// Collective. Uses up the triangulation. Precondition: all triangles with an own corner are those of the triangulation
/// of all points (ask_others()).
[[nodiscard]] PartOfDomain part_of_domain(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks,
                                          const Threads& threads);

}  // namespace pardel::engine
