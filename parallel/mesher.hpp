// The mesher: Pslg and Goal in, Mesh and Report out. Deterministic: the result depends on nothing but the
// arguments. Never prints, exits or aborts.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"

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

/// One pass over the four colours of a lattice.
struct Sweep {
  Index columns = 1, rows = 1;
  std::uint64_t inserted = 0;  ///< vertices
  /// Triangles handed on, by reason.
  std::uint64_t to_other_cells = 0;  ///< the point that they ask for lies in another cell
  std::uint64_t beyond_box = 0;      ///< the cavity leaves the box of the point's own cell: a larger box is needed
  std::uint64_t out_of_numbers = 0;  ///< the task had no numbers left for new vertices or triangles
  /// Of beyond_box, with Decomposition::paper: points inside faces whose cavities fit by T1. There are none: one would
  /// end the refinement with ErrorKind::internal.
  std::uint64_t against_promise = 0;
  double seconds = 0;

  [[nodiscard]] std::uint64_t handed_on() const { return to_other_cells + beyond_box + out_of_numbers; }
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

/// Why a triangle that breaks the goal was left alone.
enum class ExemptReason : std::uint8_t {
  nestled,       ///< its smallest angle lies between two input segments
  seditious,     ///< its shortest edge joins two points of one shell about an apex with an angle below 60°
  budget,        ///< max_vertices reached
  min_edge,      ///< splitting it would go below the edge floor
  precision,     ///< no point representable in double precision splits it validly
  kept_segment,  ///< only splitting a segment that may not be split would help
};
inline constexpr int exempt_reasons = 6;
[[nodiscard]] const char* name(ExemptReason reason);
/// True for the reasons that a small input angle justifies.
[[nodiscard]] constexpr bool justified(ExemptReason reason) {
  return reason == ExemptReason::nestled || reason == ExemptReason::seditious;
}

struct Exemption {
  Index triangle = no_index;
  ExemptReason reason = ExemptReason::precision;
  Index apex = no_index;  ///< the input vertex with the small angle, where there is one
  double angle_deg = 0;   ///< the small input angle there
};

/// How the plane was cut, beside what the theory says of it.
struct Tiling {
  Index columns = 1, rows = 1;  ///< of the finest lattice
  double cell_width = 0, cell_height = 0;
  Point low, high;  ///< corners of the rectangle that it divides
  /// The first thread, from 0, that worked on each cell of the finest lattice, row by row from the lowest; -1: none.
  /// The one thing in a report, beside times, that may differ from run to run.
  std::vector<std::int16_t> thread_of_cell;
  std::uint64_t vertices_before = 0;  ///< inserted on coarser lattices before the finest was laid
  double largest_radius = 0;          ///< r̄ as measured when the finest lattice was laid
  double radius_by_t3 = 0;            ///< bound from the largest ratio and area then (THEORY, T3)
  double radius_by_t3_sharp = 0;      ///< the same by T3-sharp
  std::vector<Sweep> sweeps;          ///< in order, coarse lattices included
};

struct Report {
  std::uint64_t inserted = 0;        ///< vertices added inside faces
  std::uint64_t segment_splits = 0;  ///< vertices added on segments
  std::uint64_t refused = 0;         ///< insertions that exact orientation or the floor refused
  std::vector<Exemption> exempt;     ///< triangles of the result that break the goal, ascending
  Tiling tiling;
  double validate_seconds = 0, triangulate_seconds = 0, refine_seconds = 0;

  [[nodiscard]] std::uint64_t count(ExemptReason reason) const;
  /// True when every exemption is justified.
  [[nodiscard]] bool goal_met() const;
};

struct Meshed {
  Mesh mesh;
  Report report;
};

/// The constrained Delaunay triangulation of the domain, nothing inserted (conforming and sizes ignored).
[[nodiscard]] Result<Meshed> triangulate(const Pslg& pslg, bool convex_hull = false, const Options& options = {});

/// The quality mesh. An invalid Pslg gives invalid_input with every problem in the message; a goal
/// out of range (an angle over 33°, a negative cap, NaN) gives usage. A hypothesis of the engine that does not hold
/// gives internal.
[[nodiscard]] Result<Meshed> mesh(const Pslg& pslg, const Goal& goal = {}, const Options& options = {});

/// Refines an existing mesh (Triangle's -r): its constrained edges (or, where it has none, its boundary
/// edges) stay constraints, its vertices stay, each triangle of it obeys its cap in `max_areas` (empty: none).
/// The mesh must be manifold and positively oriented; it is made constrained Delaunay first.
[[nodiscard]] Result<Meshed> refine(const Mesh& coarse, std::span<const double> max_areas, const Goal& goal = {},
                                    const Options& options = {});

/// The sizing function that interpolates one size per input vertex linearly over the constrained Delaunay
/// triangulation of the input. Owns what it needs; pure; callable from several threads.
[[nodiscard]] Result<std::function<double(Point)>> interpolated_size(const Pslg& pslg, std::span<const double> sizes,
                                                                     bool convex_hull = false);

}  // namespace pardel
