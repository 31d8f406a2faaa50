#include "lattice_levels.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::engine {
namespace {

/// From one level to the next finer one, the sides of the cells shrink by this factor.
constexpr Index levels_apart = 4;

/// The number of cells for each vertex that Options::max_vertices allows.
constexpr double most_cells_per_vertex = 2;

}  // namespace

Lattice finest_lattice(const Box& bounds, double triangles, const Options& options) {
  if (options.decomposition == Decomposition::none) return {bounds, 1, 1};
  if (options.cells[0] > 0 && options.cells[1] > 0) return {bounds, options.cells[0], options.cells[1]};
  const double width = bounds.max_x - bounds.min_x, height = bounds.max_y - bounds.min_y;
  double tiles = std::max(1.0, triangles / options.triangles_per_tile);
  // A limit on vertices can end the refinement long before. Cells without work take time and memory, too.
  if (options.max_vertices > 0)
    tiles = std::min(tiles, most_cells_per_vertex * static_cast<double>(options.max_vertices));
  const double longer = std::max(width, height), shorter = std::max(std::min(width, height), longer * 1e-3);
  constexpr double most_along = 4096;
  return Lattice::over(bounds, static_cast<Index>(std::clamp(std::sqrt(tiles * longer / shorter), 1.0, most_along)));
}

Lattice with_cells_at_least(double side, const Box& bounds, const Lattice& wanted) {
  const auto at_most = [&](Index count, double extent) {
    const double fitting = std::floor(extent / side);
    return fitting < count ? std::max(Index{1}, static_cast<Index>(fitting)) : count;
  };
  return {bounds, at_most(wanted.columns(), bounds.max_x - bounds.min_x),
          at_most(wanted.rows(), bounds.max_y - bounds.min_y)};
}

std::vector<Lattice> lattice_levels(const Box& bounds, const Lattice& finest) {
  std::vector<Lattice> levels{finest};
  while (levels.back().cells() > 1) {
    const auto coarser = [](Index count) { return (count + levels_apart - 1) / levels_apart; };
    levels.emplace_back(bounds, coarser(levels.back().columns()), coarser(levels.back().rows()));
  }
  std::reverse(levels.begin(), levels.end());
  return levels;
}

}  // namespace pardel::engine
