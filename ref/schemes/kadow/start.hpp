// The start of kadow(): a Delaunay triangulation that conforms to the domain, made in parts.
//
// Source: C. Kadow, "Parallel Delaunay Refinement Mesh Generation", thesis, Carnegie Mellon University 2004. Segments
// become edges by splitting those that are missing (Ruppert 1995, Section 2; "stitching").
#pragma once

#include "../given_points.hpp"

namespace pardel::schemes {

/// The triangulation, and who owns which triangle.
struct PartedStart {
  LinkedMesh mesh;  ///< Delaunay; all segments are unions of its edges; without the outside and the holes
  std::vector<int> owner;
  std::vector<int> levels;  ///< of each worker: number of cuts of its part
  Bounds bounds;
  Account account;
};
/// Divides the points, triangulates the parts, and splits the subsegments that are not edges, until there are none. The
/// mesh does not depend on the number of workers. Errors: those of unsupported() and triangulation_of(); `resources`
/// above most_points or if a subsegment is too short to be split.
[[nodiscard]] Result<PartedStart> parted_start(const Problem& problem, const GivenPointsOptions& options);

}  // namespace pardel::schemes
