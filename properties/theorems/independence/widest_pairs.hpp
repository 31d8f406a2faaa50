// Searches for pairs of points that are as far apart as possible although their cavities meet in a certain way. Each
// search uses a family of scenes in which all circumradii are nearly equal, so that r̄ is as small as possible.
// A larger `scale` (at least 2) means a finer lattice. The search tests lattice positions near the two positions that
// are best in the limit of a large scale.
#pragma once

#include "../framework/scenes.hpp"

namespace pardel::properties {

/// Independent insertion gives a non-conformal mesh, as in [CC], Figure 1a. The separation tends to 2 r̄.
[[nodiscard]] MeshedScene widest_non_conformal(int scale);
/// Independent insertion gives a conformal mesh that is not Delaunay, as in [CC], Figure 1b. The separation tends
/// to 2 r̄.
[[nodiscard]] MeshedScene widest_not_delaunay(int scale);
/// The cavities share an edge and no triangle. The separation tends to 4 r̄.
[[nodiscard]] MeshedScene widest_shared_edge(int scale);
/// The cavities share a vertex and no edge. The separation tends to 4 r̄.
[[nodiscard]] MeshedScene widest_shared_vertex(int scale);

}  // namespace pardel::properties
