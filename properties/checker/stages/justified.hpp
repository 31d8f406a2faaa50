// Decides, from coordinates and chains only, whether a small input angle justifies an angle below the bound.
//
// The smallest angle of a mesh is at most the smallest angle of its input. Near a small input angle, refinement by
// shells has to leave some triangles with angles below the bound (Miller, Pav, Walkington, "When and why Ruppert's
// algorithm works", 2003). A triangle is justified if it is
// - nestled: its smallest angle lies at an input vertex, between pieces of two segments that meet there; or
// - seditious: its shortest edge joins vertices of two segments that share an end point, the apex, at less than
//   60 degrees, and both vertices have the same distance from the apex ("lie on one shell").
// Rounded vertices count as equally distant within a tolerance, see tolerances.hpp.
#pragma once

#include <optional>

#include "stages.hpp"

namespace pardel::checker {

/// The apex and the input angle that justify triangle t, or nothing.
[[nodiscard]] std::optional<Justified> justification(Index t, const Subject& subject, const Domain& domain,
                                                     const Adjacency& adjacency, const Chains& chains,
                                                     const InputVertices& inputs);

}  // namespace pardel::checker
