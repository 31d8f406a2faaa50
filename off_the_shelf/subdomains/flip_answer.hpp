// Makes an answer constrained Delaunay.
#pragma once

#include "verify.hpp"

namespace pardel::engine {

/// Flips the edges of the answer that are not locally Delaunay, until it is the constrained Delaunay triangulation of
/// its points. Edges of the subdomain stay. Preconditions: all triangles are counter-clockwise, and `across` and
/// `on_edge` belong to them. O(n) for n triangles, and the flips.
void flip_to_delaunay(VerifiedSubdomain& answer);

}  // namespace pardel::engine
