// The sequence of lattices that a refinement uses: from one cell over the whole domain to the finest lattice.
#pragma once

#include <vector>

#include "../options.hpp"
#include "lattice.hpp"

namespace pardel::engine {

/// The finest lattice: the one that options.cells demands, or else one whose tiles have about
/// options.triangles_per_tile triangles each, where the mesh has `triangles` triangles.
[[nodiscard]] Lattice finest_lattice(const Box& bounds, double triangles, const Options& options);

/// A lattice as fine as `wanted`, except that the sides of its cells are at least `side`. A side does not count where
/// there is only one column or row (Lattice::side).
[[nodiscard]] Lattice with_cells_at_least(double side, const Box& bounds, const Lattice& wanted);

/// The levels in ascending order of fineness: first one cell, last `finest`.
[[nodiscard]] std::vector<Lattice> lattice_levels(const Box& bounds, const Lattice& finest);

}  // namespace pardel::engine
