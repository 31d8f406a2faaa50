// Delaunay refinement, sequential, as its inventor wrote it.
//
// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995;
// the angle condition after J. R. Shewchuk, "Delaunay refinement algorithms for triangular mesh
// generation", 2002.
#pragma once

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/result.hpp"

namespace pardel::ref {

/// A mesh of the Pslg that is Delaunay and meets the goal with no exemption. Preconditions (else an Error of
/// kind `usage`): there are segments; no two of them meet at less than 60 degrees; the angle bound is at
/// most arcsin(1 / (2 sqrt 2)) = 20.7 degrees; points carry no attributes. The Pslg must be valid.
/// `invalid_input` where a segment's midpoint is no double, since this refiner moves no segment.
/// Time: cubic in the size of the mesh at worst; meant for a few thousand triangles.
[[nodiscard]] Result<Mesh> ruppert(const Pslg& pslg, const Goal& goal = {});

}  // namespace pardel::ref
