// Delaunay refinement over tiles, in sweeps. It repeatedly takes a triangle that breaks the criteria. It splits the
// triangle, or an edge on which the triangle or its split point encroaches. It ends when no triangle is left that may
// be split (Ruppert 1995; Chew 1993; with the exemptions of small_angles.hpp).
//
// The terms of this folder:
//   lattice   a grid of cells (tiles) over the domain (decomposition/lattice.hpp); the refinement goes through several
//             levels, from coarse to fine and back
//   quadtree  a division into leaves (tiles) with about the same work, for graded meshes (decomposition/quadtree.hpp);
//             what follows holds for cells and leaves
//   box       a cell with a margin of half a cell, or a leaf with a margin of a quarter of its side; the task of the
//             cell changes triangles only there
//   task      the refinement of one box, starting with some bad triangles, its seeds (refinement/task.hpp)
//   colour    a number of each cell, one of four in a lattice; the boxes of the cells of one colour are disjoint
//   phase     the tasks of all cells of one colour, run at the same time (phase.hpp)
//   sweep     one phase per colour
//   pass      sweeps on one level, repeated until no triangle waits that the pass does not defer; the finest level has
//             two passes, for the shorter half of the triangles and for the longer half
//   handed on a triangle that a task passes to a later task, mostly because its split point lies in another cell
//   deferred  a triangle that is left to a later pass, because it is too short (refinement/deferral.hpp)
//   T1        the theorem that the cavity of a point in a cell fits the cell's box if circumradii are small enough
//             (THEORY.md; Lattice::radius_that_fits); with Decomposition::paper, a cavity that does not fit is an error
#pragma once

#include <cstdint>
#include <functional>

#include "../../core/result.hpp"
#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../report.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"
#include "phase.hpp"
#include "progress_monitor.hpp"

namespace pardel::engine {

struct RefineCounts {
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  std::uint64_t discarded = 0;  ///< vertices that were inserted into gathered submeshes that were too small
  bool budget_reached = false;
  bool left_alone = false;  ///< false: no triangle of the result is exempt from the goal
  Tiling tiling;

  /// Adds the counts of a refinement that was a part of this one.
  void add(const RefineCounts& part) {
    inserted += part.inserted;
    segment_splits += part.segment_splits;
    refused += part.refused;
    discarded += part.discarded;
    left_alone = left_alone || part.left_alone;
  }
};

/// Called with a copy of the triangulation after each sweep. An Error ends the refinement.
using Watcher = std::function<Status(Triangulation&& copy, const Sweep&)>;

class Communicator;

/// Refines the triangulation in place. Precondition: it is a constrained Delaunay triangulation without ghosts, and all
/// its boundary edges are constrained. Boundary edges on the border of a patch stay
/// (Triangulation::on_border_of_patch). The result depends neither on options.threads nor on the schedule. Fails with
/// `cancelled`, `resources` or `internal`, or with the error that the watcher returned; the triangulation is then not
/// usable.
///
/// The ranks of a run refine the triangulation together (communicator.hpp). If there are several, all pass equal
/// arguments, options.max_vertices == 0, and no watcher. Afterwards t has gaps: unused indices, and slots of triangles
/// that this rank does not hold. The counts are those of all ranks, but the tasks of the Tiling are those of this rank.
[[nodiscard]] Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments,
                                                    const Criteria& criteria, const Options& options,
                                                    ProgressMonitor& progress, const Schedule& schedule,
                                                    const Watcher& watcher, Communicator& communicator);
/// The same in one process.
[[nodiscard]] Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments,
                                                    const Criteria& criteria, const Options& options,
                                                    ProgressMonitor& progress, const Schedule& schedule = {},
                                                    const Watcher& watcher = {});

}  // namespace pardel::engine
