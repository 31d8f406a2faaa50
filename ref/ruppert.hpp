// Ruppert's sequential algorithm for Delaunay refinement: insert one point after the other, and split encroached
// subsegments first.
//
// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995.
#pragma once

#include "../core/mesh.hpp"
#include "refinement.hpp"

namespace pardel::ref {

/// A Delaunay mesh of the Pslg in which every triangle meets the goal. Precondition: the Pslg is valid. Errors: those
/// of unsupported(), of kind `usage`: for all other inputs the algorithm ends, because no two vertices come closer than
/// a length that the input determines (THEORY.md, Refinement: corners of 60° and more); and `invalid_input` if the
/// midpoint of a subsegment is not representable in doubles, because this refiner does not round points on segments.
/// Time: at worst cubic in the size of the mesh; intended for a few thousand triangles.
[[nodiscard]] Result<Mesh> ruppert(const Pslg& pslg, const Goal& goal = {});

/// Continues from a mesh without encroached subsegments until no triangle is bad or `failure` is set.
void refine_sequentially(Refinement& state, Criteria& criteria);

}  // namespace pardel::ref
