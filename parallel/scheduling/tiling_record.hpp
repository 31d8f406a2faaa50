// Records how the plane was cut into tiles, for the report.
#pragma once

#include "../decomposition/tiles.hpp"
#include "../report.hpp"
#include "../triangulation/radii.hpp"

namespace pardel::engine {

class TilingRecord {
 public:
  /// Records the finest tiles, which cover `bounds`. `largest`: the values measured on the present mesh.
  /// `vertices_before`: the number of vertices inserted on coarser tiles. `finest` has to outlive the record.
  void set_finest(const Tiles& finest, const Box& bounds, const Radii& largest, std::uint64_t vertices_before);

  /// Records the thread that ran the task of a cell. Does nothing if the tiles are not the finest ones, or if the cell
  /// has a thread already.
  void add_task(const Tiles& tiles, Index cell, int thread);
  void add_sweep(const Sweep& sweep) { tiling_.sweeps.push_back(sweep); }

  [[nodiscard]] Tiling take() && { return std::move(tiling_); }

 private:
  void add_leaves(const Quadtree& tree);

  Tiling tiling_;
  const Tiles* finest_ = nullptr;
};

}  // namespace pardel::engine
