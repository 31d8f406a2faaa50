// Options: how the mesher works, where Goal says what the mesh has to satisfy.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "report.hpp"

namespace pardel {

/// Where a new point goes when a triangle has to be split.
enum class Placement : std::uint8_t {
  circumcentre,
  off_centre,  ///< nearer to the shortest edge: just far enough for angles, or for sizes; smaller meshes
};

/// How the plane is cut into tasks.
enum class Decomposition : std::uint8_t {
  automatic,  ///< tiles sized by work: the triangles of one fit a core's cache
  paper,      ///< cells of at least 4 r̄ and points in a task's own cell only (THEORY, Lattice)
  none,       ///< one tile over everything
};

struct Progress {
  std::uint64_t triangles = 0;  ///< so far, roughly: each insertion counts for two; never fewer than before
  double estimate = 0;          ///< of the final number; 0 while unknown
};

struct Options {
  Placement placement = Placement::off_centre;
  int threads = 1;  ///< does not change the result
  Decomposition decomposition = Decomposition::automatic;
  /// What automatic decomposition aims at, positive. A task works on a box as large as four tiles; by default that many
  /// triangles, with their vertices, fill a second-level cache of 1 MiB. Another number gives another mesh.
  std::uint32_t triangles_per_tile = 8'000;
  /// Columns and rows of the finest lattice; 0: chosen by work. With Decomposition::paper there may be fewer, since r̄
  /// bounds how many there can be.
  std::array<Index, 2> cells{0, 0};
  std::uint64_t max_vertices = 0;  ///< stop inserting at this many vertices; 0: no budget
  /// In bytes; where the mesh that sizes and areas ask for cannot fit, mesh() says so at once (`resources`), and where
  /// it outgrows this, with 80 bytes for a vertex and its two triangles, as soon as it does. 0: no limit.
  std::uint64_t max_memory = 0;
  /// No point is inserted where it would make an edge shorter than this, nor than what double precision can
  /// hold, 2^-42 times the largest coordinate.
  double min_edge = 0;
  bool no_boundary_splits = false;  ///< Triangle's -Y: do not split edges of the domain's boundary
  bool no_segment_splits = false;   ///< Triangle's -YY: do not split any segment
  /// Called now and then from the calling thread; return false to stop with ErrorKind::cancelled.
  std::function<bool(const Progress&)> progress{};
  /// Shown, from the calling thread, the mesh as each sweep leaves it: right in all but the bounds of the goal and its
  /// wish for a conforming mesh. An Error ends the refinement and is what mesh() then returns. Each call costs a copy
  /// of the mesh.
  std::function<Status(const Mesh&, const Sweep&)> after_sweep{};
};

}  // namespace pardel
