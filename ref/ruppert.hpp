// Delaunay refinement, sequential, as its inventor wrote it: one point after the other, encroached subsegments first.
//
// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995.
#pragma once

#include "../core/mesh.hpp"
#include "refinement.hpp"

namespace pardel::ref {

/// A mesh of the Pslg that is Delaunay and meets the goal with no exemption. Preconditions (else an Error of
/// kind `usage`): those of `refused`. The Pslg must be valid.
/// `invalid_input` where a segment's midpoint is no double, since this refiner moves no segment.
/// Time: cubic in the size of the mesh at worst; meant for a few thousand triangles.
[[nodiscard]] Result<Mesh> ruppert(const Pslg& pslg, const Goal& goal = {});

/// The same from a mesh without encroached subsegments on, until every triangle is good or `failure` is set.
void refine_sequentially(Refinement& state, Criteria& criteria);

}  // namespace pardel::ref
