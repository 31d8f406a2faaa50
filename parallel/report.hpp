// Report: how the mesher made a mesh, and which triangles do not satisfy the goal, each with the reason.
#pragma once

#include <cstdint>
#include <vector>

#include "../core/pslg.hpp"
#include "gaps.hpp"
#include "sweep.hpp"

namespace pardel {

/// Why a triangle that does not satisfy the goal was not split.
enum class ExemptReason : std::uint8_t {
  nestled,       ///< its smallest angle lies between two input segments
  seditious,     ///< its shortest edge joins two segments at equal distances from their common end; angle below 60°
  budget,        ///< Options::max_vertices was reached
  min_edge,      ///< a split would make an edge shorter than the floor there (Options::min_edge)
  precision,     ///< no point that double precision can represent splits it validly
  kept_segment,  ///< only the split of a segment that may not be split would help
};
inline constexpr int exempt_reasons = 6;  ///< number of enumerators
/// The enumerator as text: "nestled".
[[nodiscard]] const char* name(ExemptReason reason);
/// True for the reasons that result from a small input angle and are unavoidable: nestled and seditious.
[[nodiscard]] constexpr bool justified(ExemptReason reason) {
  return reason == ExemptReason::nestled || reason == ExemptReason::seditious;
}

struct Exemption {
  Index triangle = no_index;
  ExemptReason reason = ExemptReason::precision;
  Index apex = no_index;  ///< the input vertex with the small angle, for a justified reason; otherwise no_index
  double angle_deg = 0;   ///< the input angle at the apex
  friend bool operator==(const Exemption&, const Exemption&) = default;
};

/// A leaf of a quadtree of tiles: the square (column, row) among the 2^level x 2^level squares of its level. The square
/// of level 0 has the lower left corner of the domain's bounding box, and the longer of its sides.
struct TileLeaf {
  std::uint32_t level = 0, column = 0, row = 0;
  unsigned colour = 0;
};

/// The tiles, cells of a lattice or leaves of a quadtree, with the bounds on circumradii that the theory gives.
struct Tiling {
  Index columns = 1, rows = 1;             ///< of the finest lattice; for a quadtree the number of leaves, and 1
  double cell_width = 0, cell_height = 0;  ///< for a quadtree the side of the least leaf
  Point low, high;               ///< corners of the rectangle that the lattice divides, and of the bounding box
  std::vector<TileLeaf> leaves;  ///< of the finest quadtree, along a Z-curve; empty for a lattice
  /// For each cell of the finest lattice the first thread, from 0, that worked on it; -1: no thread. The lowest row
  /// comes first. Only this list and the times may differ from run to run.
  std::vector<std::int16_t> thread_of_cell;
  std::uint64_t vertices_before = 0;  ///< number of vertices inserted on coarser lattices
  double largest_radius = 0;          ///< r̄, the largest circumradius when work on the finest lattice began
  double radius_by_t3 = 0;        ///< the bound on r̄ by T3 (THEORY.md), from the largest ratio and area at that time
  double radius_by_t3_sharp = 0;  ///< the bound by T3-sharp
  std::vector<Sweep> sweeps;      ///< in order, including the sweeps on coarser lattices

  /// The cell of the finest lattice that contains the point, or the nearest cell. Cells are numbered row by row from
  /// the lowest.
  [[nodiscard]] Index cell_of(Point p) const;
  /// The colour of a cell: 0 to 3 in a lattice, less than 9 in a quadtree. Cells of one colour are refined in parallel.
  [[nodiscard]] unsigned colour_of(Index cell) const;
};

struct Report {
  /// Number of equilateral triangles of Interior::fill; 0 if none fits, if the filling was given up, or if refinement
  /// alone makes fewer triangles.
  std::uint64_t laid = 0;
  /// How often the filling stood in the way of the refinement, which then started again with a smaller filling or with
  /// none.
  std::uint32_t restarts = 0;
  std::uint64_t inserted = 0;        ///< number of vertices added inside faces
  std::uint64_t segment_splits = 0;  ///< number of vertices added on segments
  /// How often a split point was not inserted, because it would have made an edge too short, or a triangle without
  /// positive area. A point may be tried more than once.
  std::uint64_t refused = 0;
  /// The triangles for which Goal::user_test still says that they must be refined. `exempt` has the reasons.
  std::uint64_t fail_user_test = 0;
  std::vector<Exemption> exempt;  ///< the triangles that do not satisfy the goal, in ascending order
  std::vector<Gap> gaps;          ///< the gaps of the domain, as find_gaps() finds them; only after mesh()
  Tiling tiling;
  double validate_seconds = 0;     ///< 0 if the input was a ValidPslg
  double triangulate_seconds = 0;  ///< for the constrained Delaunay triangulation of the input
  double refine_seconds = 0;       ///< for the refinement and the conversion to a Mesh

  /// The number of exemptions with this reason.
  [[nodiscard]] std::uint64_t count(ExemptReason reason) const;
  /// True if every exemption is justified().
  [[nodiscard]] bool goal_met() const;
};

}  // namespace pardel
