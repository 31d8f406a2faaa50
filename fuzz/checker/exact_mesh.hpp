// A mesh with exact coordinates, and with the maps that the definitions need.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "../../core/mesh.hpp"
#include "../../ref/definitions.hpp"

namespace pardel::fuzz {

/// Triangles by their index.
using Triangles = std::set<Index>;
using Edges = std::set<ref::Edge>;

/// Precondition: all corners are points that are finite, and no triangle has two equal corners.
struct ExactMesh {
  explicit ExactMesh(const Mesh& mesh);

  /// Is a triangle on the left of the edge from a to b?
  [[nodiscard]] bool has_triangle_left_of(Index a, Index b) const;

  const Mesh& given;
  ref::PlainMesh plain;
  std::map<ref::Edge, std::vector<Index>> triangles_at;
  std::vector<bool> has_triangle;  ///< per point
};

/// True if the triangle is on the left of the edge from a to b, which is one of its edges.
[[nodiscard]] bool is_left_of(const ref::Corners& triangle, Index a, Index b);

/// The triangles for which fits(index, corners) holds.
template <class Fits>
Triangles triangles_that(const ExactMesh& mesh, const Fits& fits) {
  Triangles found;
  for (Index t = 0; t < mesh.plain.triangles.size(); ++t)
    if (fits(t, mesh.plain.triangles[t])) found.insert(t);
  return found;
}

}  // namespace pardel::fuzz
