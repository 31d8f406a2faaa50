// Fills the interior of a domain with equilateral triangles.
//
// Where a bound on size is constant, equilateral triangles just below the bound are the fewest that satisfy it. They
// are Delaunay, so they need not be inserted point by point: their corners, and who is whose neighbour, are known in
// advance. A patch of them is cut out of the domain before the refinement, and laid into the mesh after it. In between,
// its border is a boundary that is never split. A patch keeps a distance of 0.7 edges from everything in the domain:
// then its border consists of edges of the domain's triangulation, and nothing lies in its circumdisks. The refinement
// inserts no point into them either (Criteria::encroaches_on_patch), so the patch fits when it is laid (THEORY.md,
// Fill).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../construction/domain_triangulation.hpp"
#include "../options.hpp"
#include "../patches/find_patches.hpp"

namespace pardel::engine {

/// The length of the edges in a patch whose triangles keep a bound on their area and one on their edges.
[[nodiscard]] double edge_of_patch(double max_area, double max_edge);

/// The error if the border of a patch is missing in the mesh around it. This does not happen.
[[nodiscard]] Error border_missing();

/// The patches of a domain, and the rest of the domain.
class Filling {
 public:
  /// Returns nothing if no triangle of a patch fits into the domain, or if the patches have too many points for
  /// Options::max_vertices. Errors: resources if they are too large for Options::max_memory or for the engine.
  /// `pieces`: in how many pieces the patches are laid; these limits hold for one piece.
  ///
  /// `coarse`: the triangulation of the Pslg. `edges`: the lengths of the edges in each region, and last in triangles
  /// without a region; infinity, or so short that edges beside the patch could be shorter than Options::min_edge: no
  /// patch. `clearings`: disks that the patches leave free. No patch is made if double precision cannot resolve its
  /// edges. The number of threads does not change the result. O(n log n) for the input and the borders of the patches,
  /// plus the rows of the lattice that each coarse triangle crosses.
  [[nodiscard]] static Result<std::optional<Filling>> make(const Pslg& pslg, bool convex_hull,
                                                           const DomainTriangulation& coarse,
                                                           std::span<const double> edges,
                                                           std::span<const Clearing> clearings, const Options& options,
                                                           const Threads& threads, std::uint64_t pieces = 1);

  /// The triangulation of the domain without the patches; only once.
  [[nodiscard]] DomainTriangulation take_domain() { return std::move(domain_); }
  /// The points of the Pslg, then the points on the borders of the patches: what the domain calls its input.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// The first of these points that lies on a border.
  [[nodiscard]] Index first_border() const { return first_border_; }
  [[nodiscard]] std::span<const RegionPatch> patches() const { return patches_; }
  /// The numbers of triangles and of points that lay() adds.
  [[nodiscard]] std::uint64_t triangles() const { return triangles_; }
  [[nodiscard]] std::uint64_t inner_points() const { return inner_points_; }

  /// Lays the patches into the mesh of the refined domain (lay_patches.hpp). Fails if it gets too many triangles.
  [[nodiscard]] Status lay(Mesh& mesh, const Threads& threads) const;

 private:
  Filling() = default;

  std::vector<RegionPatch> patches_;
  DomainTriangulation domain_;
  std::vector<Point> points_;
  Index first_border_ = 0;
  std::uint64_t triangles_ = 0, inner_points_ = 0;
};

}  // namespace pardel::engine
