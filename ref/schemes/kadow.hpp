// The extension of divide and conquer (given_points.hpp) to refinement by Kadow and Walkington: no worker ever holds an
// initial mesh of all. The points of the outline are divided by paths, missing segments are split, and each worker
// refines its part by Ruppert's rules. Path edges are interfaces, no constraints: an insertion whose cavity crosses one
// destroys it. All such insertions, and those that would have to read a triangle of another worker, are potential
// conflicts; a dedicated processor does them one after the other. A worker without a part gets half of a part that has
// grown, divided by a path of its points.
//
// Sources: C. Kadow, "Parallel Delaunay Refinement Mesh Generation", thesis, Carnegie Mellon University 2004; C. Kadow,
// N. Walkington, "Design of a projection-based parallel Delaunay mesh generation and refinement algorithm", 2003, and
// "Adaptive dynamic projection-based partitioning for parallel Delaunay mesh generation algorithms", 2004.
//
// Where an implementer goes wrong: the cavity of a rejected circumcentre has been read, too; a cavity that ends at an
// interface has read the triangle behind it; triangles that wait must move with their part; an entry
// of a queue may be out of date and name a triangle of another worker.
//
// Work: triangles read for insertions, points of hulls. Wasted: what a worker read before it set an insertion back.
// Sequential: what the dedicated processor reads. Messages: requests to it, one for each owner of a cavity in return,
// and parts that move. Rounds: workers work, then the dedicated processor.
//
// The mesh with which the refinement starts does not depend on the number of workers. The refined mesh does: insertions
// at interfaces wait for the dedicated processor, so the order changes.
//
// Left open: how many insertions a worker does per round; when a part may be divided; the cuts.
#pragma once

#include "kadow/start.hpp"

namespace pardel::schemes {

struct KadowOptions {
  GivenPointsOptions division;
  std::size_t per_round = 64;        ///< insertions of a worker per round, at least 1
  std::size_t least_to_divide = 64;  ///< inner points of a part that may be divided, at least 1
};

/// The outcome, and what else there is to say about it.
struct KadowRun {
  Outcome outcome;
  std::vector<int> owner;           ///< of each triangle
  std::uint64_t by_dedicated = 0;   ///< insertions of the dedicated processor
  std::uint64_t by_workers = 0;     ///< insertions of workers
  std::uint64_t destroyed = 0;      ///< interface edges inside cavities
  std::uint64_t parts_divided = 0;  ///< during refinement
  std::uint64_t held_at_start = 0;  ///< triangles that a worker held at most before refinement
};

/// Simulates the workers of a round in an order that the seed draws. Neither the mesh nor the account depends on it.
/// Errors: those of parted_start(), and `resources` above most_points.
[[nodiscard]] Result<KadowRun> kadow_in_detail(const Problem& problem, const KadowOptions& options = {});
[[nodiscard]] Result<Outcome> kadow(const Problem& problem, const KadowOptions& options = {});

}  // namespace pardel::schemes
