// The lattice's successor for graded meshes: cells are the leaves of a quadtree, and each has a buffer zone, in which
// nothing else happens while it is refined. The condition on circumradii is local.
//
// Sources: A. N. Chernikov, N. P. Chrisochoides, "Generalized Delaunay mesh refinement: from scalar to parallel", 2006,
// as we recall it: leaves, buffer zones of neighbours and their orthogonal neighbours, circumradii below a quarter of a
// side. The balance of the tree is our addition (properties/THEORY.md, Quadtree).
//
// Where an implementer goes wrong: the buffer zone lacks the leaves at corners; the condition is tested for the
// triangles with a corner in the leaf, but circumdisks of others reach it; the tree is not balanced; the condition is
// tested once for a tree, though splits at small angles enlarge circumradii.
//
// Work, waste, set-backs, messages: as in lattice.hpp. The tree is made anew when the mesh has grown. What is left
// open: QuadtreeOptions.
#pragma once

#include "cells/sweeps.hpp"

namespace pardel::schemes {

struct QuadtreeOptions {
  int cells_per_worker = 4;  ///< a leaf with fewer than its share of the expected triangles is not divided
  int cells = 0;             ///< instead, if not 0, the number of shares for all workers
  double fraction = 0.25;    ///< circumradii are below this fraction of the sides of the leaves that they meet
  cells::Assignment assignment = cells::Assignment::blocks;
  cells::Turns turns = cells::Turns::one_after_the_other;
  cells::Watch watch{};  ///< is told each phase
};

/// Errors: those of start_of(); `resources` if the mesh needs too many points. The mesh depends on the number of cells,
/// but neither on the number of workers nor on the order of the cells of a phase.
[[nodiscard]] Result<Outcome> quadtree(const Problem& problem, const QuadtreeOptions& options = {});

}  // namespace pardel::schemes
