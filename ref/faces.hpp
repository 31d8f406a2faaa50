// Faces of a domain: what can be reached without crossing a constrained edge.
#pragma once

#include <map>
#include <vector>

#include "../core/mesh.hpp"
#include "definitions.hpp"

namespace pardel::ref {

/// The triangles that can be reached from the triangles that contain p (their borders included) without
/// crossing a constrained edge; ascending. Empty where p lies outside the mesh.
[[nodiscard]] std::vector<Index> face_of(const PlainMesh& mesh, const ExactPoint& p);

/// Triangle's model of a domain: takes away what the exterior (from `outside`, a point of it) and the holes
/// can reach.
void carve(PlainMesh& mesh, const ExactPoint& outside, const std::vector<Point>& holes);

/// The mesh as the rest of the project knows it: neighbours found, regions spread from their seeds, markers
/// given by Triangle's rule. `segment_of_edge` tells each constrained edge's input segment, `origin` every
/// vertex's; points are rounded to doubles (exactly so where they came from doubles).
struct Provenance {
  std::map<Edge, Index> segment_of_edge;
  std::vector<Index> origin;
};
[[nodiscard]] Mesh to_mesh(const PlainMesh& plain, const Provenance& provenance, const Pslg& pslg);

}  // namespace pardel::ref
