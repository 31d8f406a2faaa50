#include "tiling_record.hpp"

namespace pardel::engine {

void TilingRecord::set_finest(const Lattice& finest, const Box& bounds, const Radii& largest,
                              std::uint64_t vertices_before) {
  finest_ = &finest;
  tiling_.columns = finest.columns();
  tiling_.rows = finest.rows();
  tiling_.cell_width = finest.width();
  tiling_.cell_height = finest.height();
  tiling_.low = {bounds.min_x, bounds.min_y};
  tiling_.high = {bounds.max_x, bounds.max_y};
  tiling_.thread_of_cell.assign(finest.cells(), -1);
  tiling_.vertices_before = vertices_before;
  tiling_.largest_radius = largest.radius;
  tiling_.radius_by_t3 = radius_bound(largest.ratio, largest.area);
  tiling_.radius_by_t3_sharp = sharp_radius_bound(largest.ratio, largest.area);
}

void TilingRecord::add_task(const Lattice& lattice, Index cell, int thread) {
  if (&lattice != finest_) return;
  std::int16_t& first = tiling_.thread_of_cell[cell];
  if (first < 0) first = static_cast<std::int16_t>(thread);
}

}  // namespace pardel::engine
