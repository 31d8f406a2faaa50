// Decides whether a small input angle justifies a triangle below the angle bound, from coordinates and chains alone.
//
// No mesh can have angles larger than those of its input, and around a small input angle refinement by shells has to
// leave some triangles below the bound (Miller, Pav, Walkington, "When and why Ruppert's algorithm works", 2003). Such
// a triangle is
// - nestled: its smallest angle lies at an input vertex, between pieces of two segments that meet there; or
// - seditious: its shortest edge joins vertices of two segments that share an end point, the apex, at less than
//   60 degrees, and both vertices have the same distance from the apex ("lie on one shell").
// Equal distances are compared in floating point, see tolerances.hpp.
#pragma once

#include <optional>

#include "stages.hpp"

namespace pardel::checker {

/// The apex and the input angle that justify triangle t, or nothing.
[[nodiscard]] std::optional<Justified> justification(Index t, const Subject& subject, const Domain& domain,
                                                     const Adjacency& adjacency, const Chains& chains,
                                                     const InputVertices& inputs);

}  // namespace pardel::checker
