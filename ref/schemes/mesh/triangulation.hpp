// Triangulations of points and of domains: the mesh with which a refinement begins.
//
// Sources: A. Bowyer, "Computing Dirichlet tessellations", 1981, and D. F. Watson, 1981 (insertion of points);
// forced_segments.hpp (segments).
#pragma once

#include <cstdint>
#include <vector>

#include "../../../core/result.hpp"
#include "linked_mesh.hpp"

namespace pardel::schemes {

struct Triangulated {
  LinkedMesh mesh;
  std::uint64_t work = 0;  ///< triangles that were read or written
};

/// The constrained Delaunay triangulation of a domain, as the program Triangle defines domains: the faces of the Pslg
/// that neither the outside nor a hole point reaches, or, without segments, the convex hull of the points, whose edges
/// are then constrained. Triangles know their regions. Precondition: the Pslg is valid, and no coordinate exceeds
/// 2^400. Errors: `invalid_input` if the domain has no triangle. O(n log n) time on typical input.
[[nodiscard]] Result<Triangulated> triangulation_of(const Pslg& pslg);

/// The edges of the convex hull, counter-clockwise, with all points that lie on it (Andrew's monotone chains).
/// Precondition: there are three points. O(n log n) time.
[[nodiscard]] std::vector<std::array<Index, 2>> hull_of(const std::vector<Point>& points);

/// A triangle in use that contains p in its interior or on its border; no_index if there is none. Linear time.
[[nodiscard]] Index triangle_around(const LinkedMesh& mesh, Point p);

/// Stands for "outside" among the values of keep_faces().
inline constexpr Index removed_face = 0;
/// Removes the triangles with the value removed_face, and gives each of the others the region of its value minus one,
/// if the value is not no_index. Puts the triangles that stay at the front. `values`: one per face.
void keep_faces(LinkedMesh& mesh, const std::vector<Index>& values);

/// The triangle in use that contains p in its interior or on its border, found by a walk from the triangle `from`;
/// no_index if the walk leaves the mesh. Adds the length of the walk to `work`. Precondition: the mesh is Delaunay and
/// covers its convex hull.
[[nodiscard]] Index locate(const LinkedMesh& mesh, Point p, Index from, std::uint64_t& work);

}  // namespace pardel::schemes
