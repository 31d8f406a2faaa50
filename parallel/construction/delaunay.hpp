// The Delaunay triangulation of points, with a ghost triangle at each edge of the convex hull.
#pragma once

#include <span>
#include <vector>

#include "../../core/result.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"
#include "insertion_order.hpp"

namespace pardel::engine {

/// The vertices are numbered along a Hilbert curve, so points that are close in the plane are close in memory.
struct Delaunay {
  Triangulation triangulation;   ///< with ghost triangles; origin and region are empty
  Array<Index> input_of_vertex;  ///< the index of the input point of each vertex
};

/// Approximately the number of points that fit, with their triangles, into the second-level cache of a core.
inline constexpr std::size_t points_per_tile = 8'000;

/// Triangulates points by incremental insertion in biased randomized order (insertion_order.hpp), in expected
/// O(n log n) time for every input.
///
/// The points of a round are inserted tile by tile, where a tile is a cell of a lattice (decomposition/lattice.hpp)
/// with about `per_tile` points. The tiles of one colour are processed concurrently, on up to `threads` threads. A
/// point whose insertion would leave the box of its tile is inserted after all tiles are done. If the lattice would
/// have fewer than 36 tiles, the tiles are made smaller, down to `per_tile` / 8 points.
///
/// The triangles depend on the points alone: where points are cocircular, the order of insertion decides, as if they
/// were inserted one by one. Precondition: the coordinates are in the range of the predicates. Errors: invalid_input
/// for two equal points and for points that are all collinear; resources for more points than the engine can number.
[[nodiscard]] Result<Delaunay> delaunay(std::span<const Point> points, const Threads& threads = {},
                                        std::size_t per_tile = points_per_tile);

/// The same for t.points, whose vertices keep their numbers. `order` tells when each counts as inserted. Time and
/// errors are as above if most vertices that are close in the plane have close numbers.
[[nodiscard]] Status triangulate_points(Triangulation& t, const InsertionOrder& order, const Threads& threads,
                                        std::size_t per_tile = points_per_tile);

}  // namespace pardel::engine
