// Fills the interior of a domain with equilateral triangles, before the refinement.
//
// Where a bound on size is constant, equilateral triangles just below the bound are the fewest that satisfy it. They
// are Delaunay, so they need not be inserted point by point: their corners, and who is whose neighbour, are known in
// advance. A patch of them keeps a distance of 0.7 edges from everything in the domain: then nothing lies in a
// circumdisk of the patch, and the triangulation of the domain together with the points on the patch's border contains
// the border (THEORY.md, Fill). What this triangulation has inside the border is replaced by the patch. What it has
// outside is refined afterwards.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "../conversion/domain_triangulation.hpp"
#include "../options.hpp"

namespace pardel::engine {

struct Filling {
  DomainTriangulation domain;
  /// The points of the Pslg, then the points on the borders of the patches: what Filling::domain calls its input.
  std::vector<Point> points;
  std::size_t triangles = 0;  ///< in the patches
};

/// The length of the edges in a patch whose triangles keep a bound on their area and one on their edges.
[[nodiscard]] double edge_of_patch(double max_area, double max_edge);

/// Returns nothing if no triangle of a patch fits into the domain, or if the patches have too many points for
/// Options::max_vertices. Errors: resources if they are too large for Options::max_memory or for the engine.
///
/// `coarse`: the triangulation of the Pslg. `edges`: the lengths of the edges in each region, and last in triangles
/// without a region; infinity: no patch. No patch is made if double precision cannot resolve its edges. The number of
/// threads does not change the result. O(n log n) for the input, plus the rows of the lattice that each coarse triangle
/// crosses, plus O(1) for each triangle of a patch.
[[nodiscard]] Result<std::optional<Filling>> fill_domain(const Pslg& pslg, bool convex_hull,
                                                         const DomainTriangulation& coarse,
                                                         std::span<const double> edges, const Options& options,
                                                         const Threads& threads);

}  // namespace pardel::engine
