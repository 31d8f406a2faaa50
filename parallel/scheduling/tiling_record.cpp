#include "tiling_record.hpp"

#include <algorithm>
#include <cmath>

namespace pardel::engine {

void TilingRecord::set_finest(const Tiles& finest, const Box& bounds, const Radii& largest,
                              std::uint64_t vertices_before) {
  finest_ = &finest;
  tiling_.columns = finest.columns();
  tiling_.rows = finest.rows();
  if (const Lattice* lattice = finest.lattice()) {
    tiling_.cell_width = lattice->width();
    tiling_.cell_height = lattice->height();
  }
  if (const Quadtree* tree = finest.quadtree()) add_leaves(*tree);
  tiling_.low = {bounds.min_x, bounds.min_y};
  tiling_.high = {bounds.max_x, bounds.max_y};
  tiling_.thread_of_cell.assign(finest.cells(), -1);
  tiling_.vertices_before = vertices_before;
  tiling_.largest_radius = largest.radius;
  tiling_.radius_by_t3 = radius_bound(largest.ratio, largest.area);
  tiling_.radius_by_t3_sharp = sharp_radius_bound(largest.ratio, largest.area);
}

void TilingRecord::add_leaves(const Quadtree& tree) {
  tiling_.cell_width = INFINITY;
  for (Index cell = 0; cell < tree.cells(); ++cell) {
    const Quadtree::Leaf& leaf = tree.leaves()[cell];
    tiling_.leaves.push_back({leaf.level, leaf.column, leaf.row, tree.colour_of(cell)});
    tiling_.cell_width = std::min(tiling_.cell_width, tree.side_of(cell));
  }
  tiling_.cell_height = tiling_.cell_width;
}

void TilingRecord::add_task(const Tiles& tiles, Index cell, int thread) {
  if (&tiles != finest_) return;
  std::int16_t& first = tiling_.thread_of_cell[cell];
  if (first < 0) first = static_cast<std::int16_t>(thread);
}

}  // namespace pardel::engine
