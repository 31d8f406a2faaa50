// Which lattices a refinement goes through: from one cell over everything to the finest, coarse to fine.
#pragma once

#include <vector>

#include "../concurrency/lattice.hpp"
#include "../options.hpp"

namespace pardel::engine {

/// The finest lattice by the caller's wish or by work: a tile of it has `triangles_per_tile` of the `estimate`.
[[nodiscard]] Lattice finest_lattice(const Box& bounds, double estimate, const Options& options);

/// As fine as `wanted`, but with cells whose sides are at least `side` (where there is a cell beside them).
[[nodiscard]] Lattice with_sides_of(const Box& bounds, const Lattice& wanted, double side);

/// One cell first, then ever finer ones, `finest` last.
[[nodiscard]] std::vector<Lattice> levels_down_to(const Box& bounds, const Lattice& finest);

}  // namespace pardel::engine
