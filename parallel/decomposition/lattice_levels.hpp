// The sequence of lattices that a refinement uses: from one cell over the whole domain to the finest lattice.
#pragma once

#include <vector>

#include "../options.hpp"
#include "lattice.hpp"

namespace pardel::engine {

/// The finest lattice: as options.cells demands, or else such that a tile has about options.triangles_per_tile
/// triangles if the whole mesh has `triangles` triangles, but at most about two cells per vertex of
/// options.max_vertices.
[[nodiscard]] Lattice finest_lattice(const Box& bounds, double triangles, const Options& options);

/// A lattice as fine as `wanted`, except that the sides of its cells are at least `side`. The side of a single column
/// or row is ignored (Lattice::side).
[[nodiscard]] Lattice with_cells_at_least(double side, const Box& bounds, const Lattice& wanted);

/// The levels in ascending order of fineness: first one cell, last `finest`.
[[nodiscard]] std::vector<Lattice> lattice_levels(const Box& bounds, const Lattice& finest);

}  // namespace pardel::engine
