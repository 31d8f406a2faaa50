// Report: what the mesher did, and which triangles do not satisfy the goal, with the reason for each.
#pragma once

#include <cstdint>
#include <vector>

#include "../core/pslg.hpp"

namespace pardel {

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

  /// The cell of the finest lattice that a point lies in, or the nearest one; cells count row by row from the lowest.
  [[nodiscard]] Index cell_of(Point p) const;
  /// Cells of one colour, 0 to 3, are refined at the same time.
  [[nodiscard]] unsigned colour_of(Index cell) const;
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

}  // namespace pardel
