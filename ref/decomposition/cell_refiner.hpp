// The parallel refiner that [CC] describes, without threads. The plane is divided into cells of several colours. A
// sweep has one phase per colour. In a phase, each cell of the colour runs Ruppert's loop on the bad triangles whose
// circumcentres it contains, until none is left. The cells of a colour decide anew in each step, from the mesh as it is
// then, and in any order (turns.hpp).
//
// Details that the paper leaves open:
// - A point is inserted by the cell that contains it, wherever the bad triangle lies. If a circumcentre encroaches upon
//   subsegments, these are handed on: the cells that contain their midpoints insert the midpoints.
// - Of the points that it may insert, a cell takes a midpoint first, and of several the one whose coordinates come
//   first in lexicographic order. So its choice does not depend on the numbering of vertices and triangles, which
//   depends on the order of the cells.
// - A bad triangle waits while a subsegment that meets its circumdisk waits for its split in another cell. So no vertex
//   lies in the circumdisk of a triangle that is split, and refinement ends as Ruppert's does (THEORY.md, Lattice).
// - Sweeps are repeated until a sweep inserts nothing. Lattice (d) bounds their number if triangles are bad by shape
//   only.
// - Splitting a subsegment at a corner of less than 90 degrees may raise circumradii. So they are measured after each
//   phase, and cells that have become too small for them are replaced.
#pragma once

#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "../../core/mesh.hpp"
#include "../radius_bound.hpp"
#include "../refinement.hpp"
#include "lattice.hpp"
#include "quadtree.hpp"
#include "turns.hpp"

namespace pardel::ref {

/// The vertices and triangles that insertions use.
struct Touched {
  std::set<ExactPoint> vertices;  ///< the vertices of the closures of the cavities
  std::set<Corners> triangles;    ///< read or written: the cavities and the triangles across their boundaries
};

/// Adds to `touched` what inserting p into the mesh uses. Returns the cavity of p. Preconditions: p lies in the mesh
/// and is not a vertex.
std::vector<Index> record_touched(Touched& touched, const PlainMesh& mesh, const ExactPoint& p);

struct Insertion {
  Cell cell;
  ExactPoint point;
};

/// A subsegment that must be split, found by the cell `from`. The split point lies in another cell, `to`.
struct HandedOn {
  Cell from;
  Cell to;
  ExactPoint point;
  friend bool operator==(const HandedOn&, const HandedOn&) = default;
  friend bool operator<(const HandedOn& a, const HandedOn& b) {
    return std::tie(a.from, a.to, a.point) < std::tie(b.from, b.to, b.point);
  }
};

struct Phase {
  int colour = 0;
  std::set<Edge> waiting_before;      ///< the subsegments that wait for their split when the phase begins
  std::vector<Insertion> insertions;  ///< in the order of the steps
  std::set<HandedOn> handed_on;
  /// For each cell: what it used, over all points that it inserted and all circumcentres that it rejected because they
  /// encroached upon a subsegment.
  std::map<Cell, Touched> touched;
  PlainMesh after;
};

template <class Cells>
struct Sweep {
  Cells cells;
  std::vector<Phase> phases;  ///< one per colour, or fewer if new cells were needed
};

template <class Cells>
struct CellRefinement {
  Mesh mesh;
  PlainMesh preprocessed;
  std::vector<Sweep<Cells>> sweeps;  ///< the last one inserts nothing
};
using LatticeRefinement = CellRefinement<Lattice>;
using QuadtreeRefinement = CellRefinement<Quadtree>;

/// Makes a mesh that meets the goal, and a record of all sweeps. Preconditions and errors are those of ruppert(). The
/// preprocessing runs Ruppert's algorithm with the goal `coarse`, for which the same preconditions hold. A finer
/// preprocessed mesh has more cells.
[[nodiscard]] Result<LatticeRefinement> refine_on_lattice(const Pslg& pslg, const Goal& goal, const Goal& coarse,
                                                          const Turns& turns = in_rounds);

/// The same on one lattice that is computed before a mesh exists, as in [CC]: r0 is squared_radius_bound() for the goal
/// `coarse`. Further errors: those of squared_radius_bound(), and `internal` if a circumradius exceeds r0 after some
/// phase, which would contradict THEORY.md, Lattice (f).
[[nodiscard]] Result<LatticeRefinement> refine_on_lattice_sized_by(RadiusTheorem theorem, const Pslg& pslg,
                                                                   const Goal& goal, const Goal& coarse,
                                                                   const Turns& turns = in_rounds);

/// The same on the leaves of quadtrees. Each sweep has a new tree.
[[nodiscard]] Result<QuadtreeRefinement> refine_on_quadtree(const Pslg& pslg, const Goal& goal, const Goal& coarse,
                                                            const Turns& turns = in_rounds);

}  // namespace pardel::ref
