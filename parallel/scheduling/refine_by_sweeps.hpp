// Delaunay refinement over tiles, in sweeps: every triangle that breaks the criteria is split, or an edge on which it
// or its split point encroaches, until no triangle is left that may be split (Ruppert 1995; Chew 1993; with the
// exemptions of small_angles.hpp).
//
// The words of this folder:
//   lattice   a grid of cells (tiles) over the domain (concurrency/lattice.hpp); the refinement goes through several
//             levels, from coarse to fine and back
//   box       a cell and half a cell around it: the only place where the task of the cell changes triangles
//   task      the refinement of one box, starting with some bad triangles, its seeds (refinement/task.hpp)
//   colour    one of four; the boxes of the cells of one colour are disjoint
//   phase     the tasks of all cells of one colour, run at the same time (phase.hpp)
//   sweep     four phases, one per colour
//   handed on a triangle that a task passes to the task of another cell, because its point lies there
//   deferred  a triangle that is left to a later pass, because it is too short (refinement/deferral.hpp)
//   T1        the theorem that the cavity of a point in a cell fits the cell's box where circumradii are small enough
//             (THEORY; Lattice::radius_that_fits); with Decomposition::paper, a cavity that does not is an error
#pragma once

#include <cstdint>
#include <functional>

#include "../../core/result.hpp"
#include "../options.hpp"
#include "../refinement/criteria.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"
#include "schedule.hpp"

namespace pardel::engine {

struct RefineCounts {
  std::uint64_t inserted = 0, segment_splits = 0, refused = 0;
  bool budget_reached = false;
  bool left_alone = false;  ///< false: no triangle of the result is exempt from the goal
  Tiling tiling;
};

/// Called with a copy of the triangulation after each sweep. An Error ends the refinement.
using Watcher = std::function<Status(Triangulation&& copy, const Sweep&)>;

/// Refines the triangulation in place. Precondition: it is a constrained Delaunay triangulation without ghosts, and all
/// its boundary edges are constrained. The result depends neither on options.threads nor on the schedule. Fails with
/// `cancelled`, `resources` or `internal`, or with the watcher's error.
[[nodiscard]] Result<RefineCounts> refine_by_sweeps(Triangulation& t, const DomainSegments& segments,
                                                    const Criteria& criteria, const Options& options,
                                                    const Schedule& schedule = {}, const Watcher& watcher = {});

}  // namespace pardel::engine
