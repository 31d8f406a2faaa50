// The paper's own scheme: a uniform lattice of cells of four colours. One worker refines the mesh until the cells are
// small enough; then all cells of one colour are refined at the same time, colour after colour, until nothing is left.
//
// Source: [CC] A. N. Chernikov, N. P. Chrisochoides, "Parallel guaranteed quality planar Delaunay mesh generation by
// concurrent point insertion", 2004: Theorem 1 (points 4 r apart are independent), cells of side 4 r and their four
// colours, sequential preprocessing, exchange with touching cells. Proofs: properties/THEORY.md, Lattice.
//
// Where an implementer goes wrong: a cell is asked by the bad triangle's place, not by that of its split point; a
// circumcentre is rejected because of a side whose split point lies in another cell, and split there; circumradii are
// measured once, though splits at small angles enlarge them; the largest circumradius is taken of the bad triangles
// only; one sweep of four phases is taken for the end.
//
// Work: triangles that are read for insertions and for circumcentres that are rejected. Waste and set-backs: none, by
// Theorem 1. Messages: after a phase, new triangles and what is handed on, at most one between two workers. Rounds are
// phases. What the paper leaves open: LatticeOptions.
#pragma once

#include "cells/sweeps.hpp"

namespace pardel::schemes {

/// The side of a cell in units of the largest circumradius.
enum class CellSide {
  four_radii,  ///< Theorem 1: tasks of one phase touch no common triangle
  two_radii,   ///< T1-sharp: the mesh is the same, but two tasks may write links of the same two triangles. If a
               ///< circumradius grows within a phase (at small angles), this is not proved.
};

struct LatticeOptions {
  CellSide side = CellSide::four_radii;
  int cells_per_worker = 4;  ///< the preprocessing ends when cells are so many, on average over the extent
  int cells = 0;             ///< instead, if not 0, their number for all workers
  cells::Assignment assignment = cells::Assignment::blocks;
  cells::Turns turns = cells::Turns::one_after_the_other;
  cells::Watch watch{};  ///< is told each phase
};

/// Errors: those of start_of(); `resources` if the mesh needs too many points. The mesh depends on the number of cells,
/// but neither on the number of workers nor on the order of the cells of a phase.
[[nodiscard]] Result<Outcome> lattice(const Problem& problem, const LatticeOptions& options = {});

/// The lattice over a mesh whose largest circumradius is `radius` (cells/uniform_cells.hpp). It allows circumdisks that
/// are not too large for its cells.
[[nodiscard]] cells::Division lattice_over(const LinkedMesh& mesh, double radius, double radii_per_side,
                                           cells::Assignment assignment, const Territory& territory);

}  // namespace pardel::schemes
