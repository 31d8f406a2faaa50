// The triangulation of a domain, ready for refinement.
#pragma once

#include <array>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The constrained Delaunay triangulation of a domain, with maps from its indices to the indices of the input.
struct DomainTriangulation {
  Triangulation triangulation;
  DomainSegments segments;
  Array<Index> input_of_vertex;      ///< for each vertex that is an input point; all others keep their index
  std::vector<Index> input_segment;  ///< the input segment of each domain segment; no_index for an edge of the hull
  /// Of a mesh that is refined: its subsegments, which the pieces of `segments` name. Their data count, not those of
  /// whole segments. Of another domain: empty.
  std::vector<ConstrainedEdge> subsegments{};
  /// The origins of its vertices, which stay as they are.
  std::vector<Index> given_origin{};

  /// The input segment at p, a point of the domain segment.
  [[nodiscard]] Index input_segment_at(Index segment, Point p) const {
    return subsegments.empty() ? input_segment[segment]
                               : subsegments[segments.pieces().at(triangulation.points, segment, p).number].segment;
  }
};

/// Triangulates the domain of a Pslg. The domain is the convex hull of the points if `convex_hull` is true or there are
/// no segments. The number of threads does not change the result. Precondition: the Pslg is valid (validate.hpp). For
/// an invalid Pslg the result can be the error invalid_input.
[[nodiscard]] Result<DomainTriangulation> triangulate_domain(const Pslg& pslg, bool convex_hull,
                                                             const Threads& threads = {});

/// The corners of each triangle, as indices of input points.
[[nodiscard]] std::vector<std::array<Index, 3>> input_corners(const DomainTriangulation& domain,
                                                              const Threads& threads = {});

}  // namespace pardel::engine
