// The three ways to divide the work (Scheme). Each leaves a constrained Delaunay mesh in which some triangles may still
// break the goal.
#pragma once

#include "../subdomains/run_tasks.hpp"

namespace pardel::engine {

/// Parts side by side, in sweeps with shifted parts.
void sweep_with_frozen_borders(MesherRun& run);

/// One sweep of parts whose borders are split to their final length before.
void refine_decoupled(MesherRun& run);

/// The cells of the paper, in phases of one colour.
void sweep_over_cells(MesherRun& run);

}  // namespace pardel::engine
