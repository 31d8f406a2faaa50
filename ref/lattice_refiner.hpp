// The parallel refiner of [CC] as its paper describes it, without threads: a lattice, four colours, one phase per
// colour. What tasks would do at the same time is done in rounds: one point for each cell of the colour, all of them
// found in the same mesh, and inserted as by tasks that know nothing of each other.
//
// Where we say more than the paper:
// - A point belongs to the cell in which the point that is inserted lies, wherever the triangle is that asked for it.
//   A circumcentre that encroaches hands the subsegments on to the cells of their midpoints.
// - Four phases are a sweep; sweeps follow until one leaves nothing to do. How many that takes is measured.
// - Splitting a subsegment at a corner of less than 90 degrees may raise r̄. The lattice is laid anew then.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "../core/mesh.hpp"
#include "lattice.hpp"
#include "refinement.hpp"

namespace pardel::ref {

/// What the work of one cell had to do with: by every point that it inserted, and by every circumcentre that it tried
/// and that encroached.
struct Touched {
  std::set<Index> vertices;     ///< of the triangles that it deleted or made, or would have: the closures of cavities
  std::set<Corners> triangles;  ///< that it read or wrote: the cavities, and the triangles around them
};

struct Insertion {
  Cell cell;
  ExactPoint point;
};

/// A subsegment that has to be split because of what a cell did, at a point that lies in another cell.
struct HandedOn {
  Cell from;
  Cell to;
  ExactPoint point;
};

struct Phase {
  Colour colour;
  std::vector<Insertion> insertions;  ///< round by round
  std::vector<HandedOn> handed_on;
  std::map<Cell, Touched> touched;
  PlainMesh after;
};

struct Sweep {
  Lattice lattice;
  std::vector<Phase> phases;  ///< four, or fewer where the lattice had to be laid anew
};

struct LatticeRefinement {
  Mesh mesh;
  PlainMesh preprocessed;
  std::vector<Sweep> sweeps;  ///< the last one did nothing
};

/// A mesh as ruppert() makes it, with the same preconditions and errors, and the story of how it was made. The
/// preprocessing is Ruppert's algorithm with the goal `coarse`, which must meet those preconditions as well; the
/// finer it is, the more cells there are.
[[nodiscard]] Result<LatticeRefinement> refine_on_lattice(const Pslg& pslg, const Goal& goal, const Goal& coarse);

}  // namespace pardel::ref
