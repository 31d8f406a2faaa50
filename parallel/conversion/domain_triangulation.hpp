// The triangulation of a domain, ready for refinement.
#pragma once

#include <array>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The constrained Delaunay triangulation of a domain, with the correspondence between its numbers and the input's.
struct DomainTriangulation {
  Triangulation triangulation;
  DomainSegments segments;
  Array<Index> input_of_vertex;      ///< the input point of each vertex that is one; the others keep their number
  std::vector<Index> input_segment;  ///< the input segment of each domain segment; no_index for an edge of the hull
  std::vector<int> segment_marker;   ///< the marker of each domain segment
};

/// Triangulates the domain of a Pslg. The domain is the convex hull of the points if `convex_hull` is true or there are
/// no segments. The number of threads does not change the result. Precondition: the Pslg is valid (validate.hpp). For
/// an invalid one the result can be the error invalid_input.
[[nodiscard]] Result<DomainTriangulation> triangulate_domain(const Pslg& pslg, bool convex_hull, int threads = 1);

/// The corners of each triangle, in the numbers of the input.
[[nodiscard]] std::vector<std::array<Index, 3>> input_corners(const DomainTriangulation& domain);

}  // namespace pardel::engine
