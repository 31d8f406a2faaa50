// Options: how the mesher works. What the mesh must satisfy is in Goal (core/goal.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "least_size.hpp"
#include "sweep.hpp"

namespace pardel {

/// The position of the point that splits a bad triangle.
enum class Placement : std::uint8_t {
  circumcentre,
  /// On the line from the shortest edge to the circumcentre, no further from the edge than the bounds on angles or
  /// sizes require (Üngör 2004). Gives smaller meshes.
  off_centre,
  /// The off-centre if all triangles that it makes keep the bound on angles and Goal::max_area. Otherwise, of the
  /// off-centre and 48 points around the circumcentre, the point that makes the fewest triangles that break them (after
  /// Erten and Üngör, "Quality triangulations with locally optimal Steiner points", 2009). Without bounds on size it
  /// makes a tenth fewer triangles than off_centre at 30 degrees, and a sixth fewer at 33 degrees; with bounds on
  /// lengths up to a tenth more at 30 degrees. It takes 5 to 10 times as long. It does not run through parts of a mesh
  /// whose triangles are nearly equilateral, as the other two do at 30 degrees and more.
  search,
  /// In refine(): `search` for angles of 30 degrees and more. In mesh(): `search` for angles above 30 degrees, if there
  /// are no bounds on lengths (Goal::max_edge, size, sources, grading, feature_edges). Else `off_centre`.
  automatic,
};

/// How the plane is cut into tiles, which are refined in parallel.
enum class Decomposition : std::uint8_t {
  /// `quadtree` if the bounds on size depend on the place and the work per cell of a lattice would be very uneven, else
  /// `lattice`.
  automatic,
  /// Cells at least 4 r̄ wide, with r̄ the largest circumradius. A task inserts points only in its own cell
  /// (THEORY.md, Lattice).
  paper,
  none,     ///< one tile
  lattice,  ///< the cells of a lattice, of about equal work if triangles are about equally large
  /// The leaves of a quadtree, of about equal work although triangles differ much in size.
  quadtree,
  /// `paper` for graded meshes: the leaves of a quadtree, with sides of at least 8 circumradii of the triangles around
  /// them. A task inserts points only in its own leaf (THEORY.md, Quadtree).
  paper_quadtree,
};

/// True for the decompositions in which a task inserts points only in its own cell, and the sizes of cells follow from
/// circumradii.
[[nodiscard]] constexpr bool is_of_the_paper(Decomposition decomposition) {
  return decomposition == Decomposition::paper || decomposition == Decomposition::paper_quadtree;
}

/// What fills the parts of the domain that are far from all segments, where the bound on size is constant.
enum class Interior : std::uint8_t {
  refine,  ///< triangles of the refinement, as everywhere
  /// Equilateral triangles just below the bound: the fewest that keep it. Only in mesh(), and where the bounds do not
  /// depend on the place; with Goal::user_test, as `refine`. If the other triangles cannot keep the bounds beside them,
  /// the interior is refined (Report::restarts); this is rare for angles up to 30 degrees, and with bounds on areas and
  /// Placement::search.
  fill,
  /// `fill`, if segments may be split and the decomposition is not of the paper, for angles up to 30 degrees; for
  /// larger ones up to 33 degrees only with Placement::search and without bounds on lengths. Else `refine`.
  automatic,
};

struct Progress {
  /// The current number, approximately: an insertion counts as two; it never decreases. 0 until the refinement starts.
  std::uint64_t triangles = 0;
  double estimate = 0;  ///< estimated final number of triangles; 0 while unknown
};

struct Options {
  Placement placement = Placement::off_centre;
  Interior interior = Interior::refine;
  /// The number of threads; 0: as many as OpenMP offers, one per core by default, and one for a small mesh. The result
  /// does not depend on it.
  int threads = 0;
  Decomposition decomposition = Decomposition::automatic;
  /// The number of triangles per tile that Decomposition::lattice and quadtree aim at, > 0. A task works on a box as
  /// large as four cells or 2.25 leaves. By default the triangles of a box, with their vertices, fill a second-level
  /// cache of 1 MiB. Another number gives another mesh.
  std::uint32_t triangles_per_tile = 8'000;
  /// Columns and rows of the finest lattice of tiles; 0: the expected work determines them. Not used for a quadtree.
  /// With Decomposition::paper there may be fewer, because r̄ limits their number. Another number gives another mesh.
  std::array<Index, 2> cells{0, 0};
  /// As soon as the mesh has this number of vertices, no vertex is inserted any more; 0: no limit.
  std::uint64_t max_vertices = 0;
  /// A limit on memory in bytes; 0: no limit. A vertex with its two triangles counts as 80 bytes, so the result does
  /// not depend on the state of the machine. The mesher returns ErrorKind::resources at the start if the mesh that the
  /// area and size bounds require cannot fit, and later as soon as the mesh exceeds the limit. A limit on the memory of
  /// the whole process can be kept with `progress`.
  std::uint64_t max_memory = 0;
  /// No point is inserted that would make an edge shorter than the floor at this point: the largest of this length, of
  /// 2^-42 times the larger coordinate of the point, and of 2^-129. Double precision resolves no shorter edges there. A
  /// length >= 0.
  double min_edge = 0;
  bool no_boundary_splits = false;  ///< do not split segments on the boundary of the domain (Triangle's switch -Y)
  bool no_segment_splits = false;   ///< do not split any segment (Triangle's switch -YY)
  /// Do not split a segment whose edges have one of these markers in the mesh (ConstrainedEdge::marker).
  std::vector<int> kept_markers{};
  // If one of the functions throws, the mesher returns a `usage` error with the text of the exception.
  /// Called in the calling thread during the whole run, about every 4 ms. Return false to stop with
  /// ErrorKind::cancelled: no further task starts, and the mesher returns as soon as each thread has done a few
  /// insertions more.
  std::function<bool(const Progress&)> progress{};
  /// Called in the calling thread by mesh(), before the refinement, with a lower bound on the size of the mesh, and the
  /// size to expect. An Error ends the run, and mesh() returns it. The bound is 0 if segments may not be split.
  std::function<Status(const LeastSize&)> before_refinement{};
  /// Called in the calling thread after each sweep, with a copy of the mesh. That mesh is constrained Delaunay and
  /// conforms to the domain; it need not satisfy the goal yet. An Error stops the refinement, and mesh() returns it.
  std::function<Status(const Mesh&, const Sweep&)> after_sweep{};
};

/// True if all segments may be split.
[[nodiscard]] inline bool may_split_all_segments(const Options& options) {
  return !options.no_boundary_splits && !options.no_segment_splits && options.kept_markers.empty();
}

}  // namespace pardel
