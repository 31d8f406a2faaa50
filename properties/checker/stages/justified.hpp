// Does a small input angle justify a triangle below the angle bound? Recomputed from coordinates and chains.
//
// No mesh can have angles larger than those of its input, and around a small input angle refinement by
// shells has to leave some triangles alone (Miller, Pav, Walkington, "When and why Ruppert's algorithm
// works", 2003). A triangle is
// - nestled, when its smallest angle lies at an input vertex between pieces of two segments that meet there;
// - seditious, when its shortest edge joins two vertices on two segments that share an end point, the apex,
//   at less than 60 degrees, at equal distances from it ("on one shell").
#pragma once

#include <optional>

#include "stages.hpp"

namespace pardel::checker {

/// Distances from an apex are equal when they differ by at most this fraction of the larger one and
/// shell_ulps units in the last place of the largest coordinate (vertices on segments are rounded).
inline constexpr double shell_tolerance = 1e-9;
inline constexpr double shell_ulps = 8;

/// The apex and the angle that justify triangle t, if any. angle_deg is the smallest angle of t.
[[nodiscard]] std::optional<Justified> justification(Index t, const Subject& subject, const Domain& domain,
                                                     const Adjacency& adjacency, const Chains& chains,
                                                     const InputVertices& inputs);

}  // namespace pardel::checker
