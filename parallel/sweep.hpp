// What one sweep of the refinement did.
#pragma once

#include <cstdint>

#include "../core/pslg.hpp"

namespace pardel {

/// A sweep goes once through the colours of the cells of a lattice, or of the leaves of a quadtree. The cells of one
/// colour are refined in parallel, one task per cell.
struct Sweep {
  Index columns = 1, rows = 1;     ///< size of the lattice; for a quadtree the number of leaves, and 1
  std::uint64_t inserted = 0;      ///< number of vertices inserted
  std::uint64_t largest_task = 0;  ///< the number that one task inserted, at most
  /// The numbers of bad triangles that were handed on, by reason. A task hands a triangle on if it leaves the triangle
  /// to a later task.
  std::uint64_t to_other_cells = 0;  ///< the split point lies in another cell
  std::uint64_t beyond_box = 0;      ///< the cavity of the split point leaves the box of its cell
  std::uint64_t out_of_numbers = 0;  ///< the task had no indices left for new vertices or triangles
  /// With Decomposition::paper: the number of triangles of beyond_box that contradict theorem T1 (THEORY.md). Always 0,
  /// because one such triangle ends the refinement with ErrorKind::internal.
  std::uint64_t against_promise = 0;
  double seconds = 0;

  [[nodiscard]] std::uint64_t handed_on() const { return to_other_cells + beyond_box + out_of_numbers; }
};

}  // namespace pardel
