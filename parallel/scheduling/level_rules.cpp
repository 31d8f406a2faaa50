#include "level_rules.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace pardel::engine {
namespace {

/// A level splits triangles whose longest side exceeds this fraction of the side of a cell of the next finer level. The
/// cavities of shorter triangles fit the boxes of the finer level.
constexpr double long_in_finer_cells = 0.25;

/// A leaf of a quadtree is divided if more triangles are expected in it than a share of all, so that there are enough
/// leaves for many threads, and at least and at most these multiples of Options::triangles_per_tile. (A task works on a
/// box of 2.25 leaves, and of four cells in a lattice.) Larger leaves hand fewer triangles on.
constexpr double share_of_leaf = 1.0 / 128, least_per_leaf = 2.5, most_per_leaf = 11;

/// If Options::max_vertices will end the refinement early, leaves that get fewer triangles than this part of a tile
/// gain nothing.
constexpr double least_part_of_tile = 0.25;

std::vector<double> per_leaf(const Array<WorkAt>& work, const Quadtree& tree) {
  std::vector<double> sum(tree.cells(), 0);
  for (const WorkAt& each : work) sum[tree.cell_of(each.place)] += each.triangles;
  return sum;
}

/// The number of triangles that may be expected in a leaf.
double allowed(const Array<WorkAt>& work, const Options& options, std::uint64_t available) {
  double all = 0;
  for (const WorkAt& each : work) all += each.triangles;
  const double tile = options.triangles_per_tile;
  const double expected_for_each_made = all / (2 * static_cast<double>(available));
  return std::max(std::clamp(share_of_leaf * all, least_per_leaf * tile, most_per_leaf * tile),
                  least_part_of_tile * tile * expected_for_each_made);
}

}  // namespace

Deferral short_enough_for(const Lattice& finer, Decomposition decomposition) {
  if (decomposition == Decomposition::paper) {
    const double largest = finer.side() / Lattice::radii_per_side;
    return {.squared_radius = largest * largest};
  }
  const double longest = long_in_finer_cells * finer.side();
  return {.longest_squared = longest * longest};
}

Deferrals short_enough_for(const Quadtree& tree, const Quadtree& finer, Decomposition decomposition) {
  const bool by_radius = is_of_the_paper(decomposition);
  std::vector<double> bounds(tree.cells(), INFINITY);
  for (Index cell = 0; cell < finer.cells(); ++cell) {
    const double most = by_radius ? finer.radius_that_fits(cell) : long_in_finer_cells * finer.side_of(cell);
    double& bound = bounds[tree.cell_of(finer.centre_of(cell))];
    bound = std::min(bound, most * most);
  }
  std::vector<Deferral> rules;
  for (Index cell = 0; cell < tree.cells(); ++cell) {
    if (!by_radius) {
      rules.push_back({.longest_squared = bounds[cell]});
      continue;
    }
    double around = bounds[cell];
    for (const Index other : tree.touching(cell)) around = std::min(around, bounds[other]);
    rules.push_back({.squared_radius = around});
  }
  return Deferrals(std::move(rules));
}

Quadtree divided_by_work(const Quadtree& tree, const Array<WorkAt>& work, const Options& options,
                         std::uint64_t available) {
  const double most = allowed(work, options, available);
  Quadtree finer = tree;
  for (int halvings = 0; halvings < 2; ++halvings) finer = finer.divided(per_leaf(work, finer), most);
  return finer;
}

}  // namespace pardel::engine
