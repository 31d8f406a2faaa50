// Segments become edges of a triangulation by flips.
//
// Sources: S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations", 1993 (forcing an edge);
// C. L. Lawson, "Software for C1 surface interpolation", 1977 (flips end in the Delaunay triangulation).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "linked_mesh.hpp"

namespace pardel::schemes {

/// A triangle at each vertex, kept while sides are flipped.
class TriangleAt {
 public:
  explicit TriangleAt(const LinkedMesh& mesh) : at_(mesh.points.size(), no_index) {
    for (Index t = 0; t < mesh.faces.size(); ++t) note(mesh, t);
  }
  void note(const LinkedMesh& mesh, Index t) {
    for (const Index v : mesh.faces[t].v) at_[v] = t;
  }
  [[nodiscard]] Index operator[](Index v) const { return at_[v]; }

 private:
  std::vector<Index> at_;
};

/// Flips the sides that the segment ab crosses until ab is a side, constrains it as a piece of this segment, and flips
/// what was changed to the constrained Delaunay triangulation. Returns the number of triangles that were changed, each
/// as often as it was. Preconditions: a and b are inside the mesh, and ab contains no other vertex and crosses no
/// constrained side.
std::uint64_t force(LinkedMesh& mesh, TriangleAt& at, Index a, Index b, Index segment);

/// Flips unconstrained sides until is_wrong(side, the same side as the neighbour sees it) holds for none of these, and
/// for none of those around a flip. Returns the triangles that were changed, two for each flip.
std::vector<Index> flip_where(LinkedMesh& mesh, std::vector<Side> sides,
                              const std::function<bool(Side, Side)>& is_wrong);

/// Flips unconstrained sides until each of these, and each that a flip has changed, is locally Delaunay. Returns the
/// triangles that were changed.
std::vector<Index> flip_to_delaunay(LinkedMesh& mesh, std::vector<Side> sides);

}  // namespace pardel::schemes
