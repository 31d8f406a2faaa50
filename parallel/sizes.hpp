// Bounds on edge lengths that depend on the place: functions for Goal::size, and Goal::sources. Every function here is
// deterministic, and neither prints, exits nor throws.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "options.hpp"
#include "validate.hpp"

namespace pardel {

/// Makes a function for Goal::size. The function interpolates one edge length per point linearly over the constrained
/// Delaunay triangulation of the domain. It owns its data, and several threads may call it. A call takes O(log n).
///
/// sizes: one length per point, finite and > 0; anything else gives `invalid_input`. Further errors: those of
/// triangulate().
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const ValidPslg& domain,
                                                                     std::span<const double> sizes,
                                                                     const Options& options = {});
/// Makes a function for Goal::size from one edge length per point of any mesh, for example the result of an earlier
/// computation. Beside the mesh, the length at the nearest point counts. Farther away than the length of the longest
/// side of the nearest triangle, the function throws an Error (`invalid_input`), which the mesher returns.
///
/// Errors: `invalid_input` if a size is not finite and > 0, if there is no triangle, or if an index of a triangle is
/// out of range or a triangle is flat. Orientations may differ. Where triangles overlap, one of them counts.
/// `name` names the mesh in the Error of a point that it does not cover.
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const Mesh& background,
                                                                     std::span<const double> sizes,
                                                                     const Options& options = {},
                                                                     std::string name = "the mesh of the sizes");
/// The same for a domain, after validation as in mesh().
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                                     bool convex_hull = false,
                                                                     const Options& options = {});

/// Makes the Goal::sources of the same sizes, for a limit on gradation. With these sources, no field grows faster, and
/// at no place is the wanted length less than the limit requires: it is the greatest function below the interpolated
/// lengths that grows by at most `grading` per unit of distance. Where they already do, they need no sources.
///
/// Errors: as from interpolated_size(); `usage` if the limit is not a finite number greater than 0.
[[nodiscard]] Result<std::vector<SizeSource>> size_sources(const ValidPslg& domain, std::span<const double> sizes,
                                                           double grading, const Options& options = {});
[[nodiscard]] Result<std::vector<SizeSource>> size_sources(const Mesh& background, std::span<const double> sizes,
                                                           double grading);

/// Edge lengths in the regions of a domain.
struct RegionSizes {
  std::function<double(Point)> size;  ///< for Goal::size: the length in the region around a point; infinity: none
  std::vector<SizeSource> borders;    ///< for Goal::sources: the segments around these regions, with these lengths
};
/// lengths: one per region of the domain, > 0; infinity: none. Where a segment lies between two regions, both are
/// sources. The function owns its data, and several threads may call it. A call takes O(log n) on typical input.
/// Errors: those of triangulate(); `invalid_input` if a length is not positive, or if their number is not that of the
/// regions.
[[nodiscard]] Result<RegionSizes> region_sizes(const ValidPslg& domain, std::span<const double> lengths,
                                               const Options& options = {});

/// The longest edge that Goal::size, Goal::grading and Goal::feature_edges allow at a point: mesh() uses this function.
/// With one of the two latter bounds, it owns its data and finds a length in O(log n) on typical input. Otherwise it is
/// Goal::size. Errors: those of check_goal(); `resources`.
[[nodiscard]] Result<std::function<double(Point)>> allowed_size(const ValidPslg& domain, const Goal& goal,
                                                                const Options& options = {});

}  // namespace pardel
