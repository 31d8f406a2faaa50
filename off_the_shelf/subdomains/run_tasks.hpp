// Runs the tasks of a phase: takes parts out of the mesh, has them refined, verifies the answers, and glues them in.
#pragma once

#include <vector>

#include "../../core/goal.hpp"
#include "../../core/ranks.hpp"
#include "../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../mesh_with_mesher.hpp"
#include "attempt.hpp"
#include "part.hpp"

namespace pardel::engine {

/// A run with a mesher: the mesh, what it has to satisfy, and what has happened so far.
struct MesherRun {
  MeshInWork& mesh;
  const Goal& goal;  ///< its sizes are one function, without sources and gradation
  const Criteria& criteria;
  const Options& options;
  const MesherOptions& how;
  const std::vector<double>& region_caps;  ///< empty: regions have no caps
  MesherCaller& mesher;
  Ranks* ranks;  ///< they share the tasks, and all of them have this mesh; null: this process does all tasks
  Threads threads;
  MesherReport& report;
  const Watcher& watcher;
  double seconds_in_tasks = 0;  ///< of this thread, in run_tasks()
};

/// The portions of a phase.
struct Portions {
  std::vector<Portion> all;
  std::vector<Index> portion_of;  ///< for each triangle of the mesh, its portion; no_index: it belongs to none
};

/// Shows the mesh to the watcher of the run, if there is one. The mesh is constrained Delaunay. `made`: the number of
/// new vertices since the last call. Throws Stopped if the watcher returns an error.
void show(const MesherRun& run, std::uint64_t made);

/// Refines each portion, all at the same time. An answer that breaks the contract is not used: its portion stays as it
/// was. A mesher that does not know small input angles does not get the triangles that they exempt from the goal: it
/// would split them for ever. The smallest of several portions is refined twice: two answers that differ are a breach.
/// Returns the number of new vertices. Collective if ranks share the tasks: they exchange their answers once. Throws
/// Stopped if the mesh becomes too large.
std::uint64_t run_tasks(MesherRun& run, Portions portions);

}  // namespace pardel::engine
