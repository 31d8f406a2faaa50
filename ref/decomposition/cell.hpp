// A cell: one of the squares into which a decomposition divides the plane.
#pragma once

#include <compare>
#include <cstdint>

namespace pardel::ref {

/// The square (i, j) of a lattice, or of a level of a quadtree. Cells of a lattice have the level 0.
struct Cell {
  std::int64_t i = 0;
  std::int64_t j = 0;
  int level = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 reports each <=> that a compiler makes
  friend auto operator<=>(const Cell&, const Cell&) = default;
};

}  // namespace pardel::ref
