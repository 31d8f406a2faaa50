// The parallel refiner that [CC] describes, without threads: a lattice, four colours, one phase per colour. Rounds
// stand for the work of concurrent tasks: in each round every cell of the colour inserts one point. All cavities of a
// round are found in the same mesh, and the points are inserted independently (independent.hpp).
//
// Details that the paper leaves open:
// - A point is inserted by the cell that contains it, wherever the bad triangle lies. If a circumcentre encroaches upon
//   subsegments, these are handed on: the cells that contain their midpoints insert the midpoints.
// - Four phases, one for each colour, form a sweep. Sweeps are repeated until a sweep inserts nothing. The number of
//   sweeps is measured.
// - Splitting a subsegment at a corner of less than 90 degrees may raise r̄. Then a new lattice is computed.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "../core/mesh.hpp"
#include "lattice.hpp"
#include "refinement.hpp"

namespace pardel::ref {

/// The vertices and triangles that one cell used, over all points that it inserted and all circumcentres that it
/// rejected because they encroached upon a subsegment.
struct Touched {
  std::set<Index> vertices;     ///< the vertices of the closures of the cavities
  std::set<Corners> triangles;  ///< read or written: the cavities and the triangles across their boundaries
};

struct Insertion {
  Cell cell;
  ExactPoint point;
};

/// A subsegment that must be split, found by the cell `from`. The split point lies in another cell, `to`.
struct HandedOn {
  Cell from;
  Cell to;
  ExactPoint point;
};

struct Phase {
  Colour colour;
  std::vector<Insertion> insertions;  ///< in the order of the rounds
  std::vector<HandedOn> handed_on;
  std::map<Cell, Touched> touched;
  PlainMesh after;
};

struct Sweep {
  Lattice lattice;
  std::vector<Phase> phases;  ///< four, or fewer if a new lattice was needed
};

struct LatticeRefinement {
  Mesh mesh;
  PlainMesh preprocessed;
  std::vector<Sweep> sweeps;  ///< the last one inserts nothing
};

/// Makes a mesh that meets the goal, and a record of all sweeps. Preconditions and errors are those of ruppert(). The
/// preprocessing runs Ruppert's algorithm with the goal `coarse`, for which the same preconditions hold. A finer
/// preprocessed mesh has more cells.
[[nodiscard]] Result<LatticeRefinement> refine_on_lattice(const Pslg& pslg, const Goal& goal, const Goal& coarse);

}  // namespace pardel::ref
