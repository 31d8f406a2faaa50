// Faces of a domain. A face is a maximal set of triangles that are connected across unconstrained edges.
#pragma once

#include <map>
#include <vector>

#include "../core/mesh.hpp"
#include "definitions.hpp"

namespace pardel::ref {

/// The triangles of all faces that contain p; p may lie in the interior or on the border of a triangle. Returns
/// ascending indices; empty if p lies outside the mesh.
[[nodiscard]] std::vector<Index> face_of(const PlainMesh& mesh, const ExactPoint& p);

/// Removes the face of `outside` (a point of the exterior) and the face of every hole point. The program Triangle
/// defines domains in the same way.
void carve(PlainMesh& mesh, const ExactPoint& outside, const std::vector<Point>& holes);

/// The parts of the input from which the vertices and edges of a mesh come.
struct Provenance {
  std::map<Edge, Index> segment_of_edge;  ///< the input segment of each constrained edge
  std::vector<Index> origin;              ///< the origin of each vertex; see Mesh::origin
};

/// Converts a mesh to the data structure of core/. Finds neighbours, spreads regions from their seeds, and sets markers
/// by the rule of the program Triangle. Points are rounded to doubles; points that are doubles stay exact.
[[nodiscard]] Mesh to_mesh(const PlainMesh& plain, const Provenance& provenance, const Pslg& pslg);

/// The points, triangles and constrained edges of a mesh of core/, with exact coordinates.
[[nodiscard]] PlainMesh to_plain_mesh(const Mesh& mesh);

}  // namespace pardel::ref
