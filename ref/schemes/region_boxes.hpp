// Tasks that own boxes: a task inserts a point only if the box of its cell contains it and all vertices of its cavity,
// and hands on the others. No bound on circumradii and no preprocessing is needed. Lattices of all levels are used,
// from one cell to many, each for the triangles that fit it; what leaves its box goes to a coarser level.
//
// Source: properties/THEORY.md, T-region (tasks own disjoint boxes); the colours are those of [CC] (lattice.hpp).
//
// Where an implementer goes wrong: boxes of one colour overlap; the new point is tested but not the vertices of its
// cavity; a triangle that leaves its box comes back to the same level and waits for ever; what a split side makes on
// the other side of the wall is not looked at.
//
// Work: triangles that are read, also for insertions that are handed on. Waste and set-backs: none because of another
// worker. Messages: as in lattice.hpp, within a level; between levels, what is handed on is not counted, because a cell
// and the coarser cell around it are mostly the same worker's. Rounds are phases. What is left open:
// RegionBoxesOptions.
#pragma once

#include "cells/sweeps.hpp"

namespace pardel::schemes {

struct RegionBoxesOptions {
  int cells_per_worker = 4;  ///< of the finest level, on average over the extent
  int cells = 0;             ///< instead, if not 0, their number for all workers
  /// A triangle is due on the finest level whose cells have this side in units of its circumradius. With 4, cavities
  /// leave boxes only because of larger triangles beside them.
  double radii_per_side = 4;
  cells::Assignment assignment = cells::Assignment::blocks;
  cells::Turns turns = cells::Turns::one_after_the_other;
  cells::Watch watch{};  ///< is told each phase
};

/// Errors: those of start_of(); `resources` if the mesh needs too many points. The mesh depends on the number of cells,
/// but neither on the number of workers nor on the order of the cells of a phase.
[[nodiscard]] Result<Outcome> region_boxes(const Problem& problem, const RegionBoxesOptions& options = {});

}  // namespace pardel::schemes
