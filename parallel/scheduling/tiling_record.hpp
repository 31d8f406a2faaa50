// Records how the plane was cut into tiles, for the report.
#pragma once

#include "../concurrency/lattice.hpp"
#include "../report.hpp"
#include "../triangulation/radii.hpp"

namespace pardel::engine {

class TilingRecord {
 public:
  /// Records the finest lattice, which covers `bounds`. `largest`: the values measured on the present mesh.
  /// `vertices_before`: the number of vertices inserted on coarser lattices. `finest` has to outlive the record.
  void set_finest(const Lattice& finest, const Box& bounds, const Radii& largest, std::uint64_t vertices_before);

  /// Records the thread that ran the task of a cell. Does nothing if the lattice is not the finest one, or if the cell
  /// has a thread already.
  void add_task(const Lattice& lattice, Index cell, int thread);
  void add_sweep(const Sweep& sweep) { tiling_.sweeps.push_back(sweep); }

  [[nodiscard]] Tiling take() && { return std::move(tiling_); }

 private:
  Tiling tiling_;
  const Lattice* finest_ = nullptr;
};

}  // namespace pardel::engine
