// The Delaunay triangulation of points, with ghost triangles around the hull.
#pragma once

#include <span>
#include <vector>

#include "../../core/result.hpp"
#include "triangulation.hpp"

namespace pardel::engine {

/// Vertices are renumbered along a Hilbert curve, which keeps what is near in the plane near in memory.
struct Delaunay {
  Triangulation triangulation;   ///< ghosts included; origin and region are empty
  Array<Index> input_of_vertex;  ///< vertex -> index of the input point
};

/// About as many as fit a core's second-level cache with their triangles.
inline constexpr std::size_t points_per_tile = 8'000;

/// Randomized incremental insertion in biased order (Amenta, Choi and Rote, "Incremental constructions con
/// BRIO", 2003): expected O(n log n) for any input, the randomness being a hash of the place along the curve, so
/// the result does not depend on the order of the input. The many points of a round go in tile by tile, as in the
/// refinement (tiles.hpp): the tiles of one colour at once, on up to `threads` threads, what leaves its tile's box
/// afterwards. Where that makes fewer than 36 tiles they are smaller, down to an eighth of `per_tile`. The number of
/// threads does not change the result; that of points per tile may, where points are cocircular. Precondition: distinct
/// points, coordinates in range; a duplicate, or points that are all collinear, give invalid_input.
[[nodiscard]] Result<Delaunay> delaunay(std::span<const Point> points, int threads = 1,
                                        std::size_t per_tile = points_per_tile);

}  // namespace pardel::engine
