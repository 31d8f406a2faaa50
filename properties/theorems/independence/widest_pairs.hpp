// Searches for pairs of points that are as far apart as they can be and still meet in a certain way. Each looks
// through a family of scenes in which circumradii are all but equal, so that r̄ is not wasted, on a lattice that grows
// finer with `scale` (at least 2), around the two positions that are best in the limit.
#pragma once

#include "../framework/scenes.hpp"

namespace pardel::properties {

/// Independent insertion leaves the mesh non-conformal, as in [CC], Figure 1a; the separation tends to 2 r̄.
[[nodiscard]] MeshedScene widest_non_conformal(int scale);
/// It leaves the mesh conformal but not Delaunay, as in [CC], Figure 1b; the separation tends to 2 r̄.
[[nodiscard]] MeshedScene widest_not_delaunay(int scale);
/// The cavities share an edge and no triangle; the separation tends to 4 r̄.
[[nodiscard]] MeshedScene widest_shared_edge(int scale);
/// The cavities share a vertex and no edge; the separation tends to 4 r̄.
[[nodiscard]] MeshedScene widest_shared_vertex(int scale);

}  // namespace pardel::properties
