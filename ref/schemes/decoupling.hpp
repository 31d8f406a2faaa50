// Delaunay decoupling: separators divide the domain into parts, and are divided beforehand into pieces so short that
// no part has to split one. So the parts are refined without any exchange.
//
// Sources: L. Linardakis, N. Chrisochoides, "Delaunay decoupling method for parallel guaranteed quality planar mesh
// refinement", SIAM J. Sci. Comput. 27, 2006, and its conference version of 2003. They take separators from the medial
// axis; here they are lines (Separators). Condition on pieces, derived here: a point that Ruppert's algorithm inserts
// is farther from all vertices than the circumradius R of a bad triangle, and R >= min(sqrt 2 h, R_A), where h is the
// least distance of vertices and R_A the least circumradius of a triangle that is too large. In the diametral circle of
// a piece of length l it would be nearer than l / sqrt 2 to an end. So no point encroaches if l < min(2 h, sqrt 2 R_A).
//
// Where an implementer goes wrong: pieces follow no size; a separator meets a segment at a small angle; a part splits a
// piece that its neighbour keeps; a part looks across a gap; what is left after gluing is forgotten.
//
// Work: triangles read for insertions. Waste and set-backs: insertions that a part gives up, because they would split a
// separator or reach another part through a gap; what needs them is refined by one worker after the parts are put
// together (`sequential`). Messages: the parts, once, before they are refined. Left open: DecouplingOptions.
#pragma once

#include <functional>

#include "workers/problem.hpp"

namespace pardel::schemes {

enum class Separators { lattice, bisection };

/// What a part does with a circumcentre that encroaches upon a separator.
enum class Encroaching {
  handed_back,  ///< its triangle waits until the parts are put together: separators stay Delaunay edges
  inserted,     ///< it is inserted: separators may have to be flipped
};

/// What happened, for tests.
struct DecouplingRecord {
  const LinkedMesh& laid;        ///< the mesh with separators, before parts are refined
  const std::vector<int>& part;  ///< of each of its triangles
  Index first_separator = 0;     ///< segments from this one on are separators
  std::size_t pieces = 0, gaps = 0;
};
struct DecouplingEnd {
  std::uint64_t separator_splits = 0;  ///< splits of separators that parts would have needed
  std::uint64_t flips = 0;             ///< after gluing
  std::uint64_t late = 0;              ///< insertions after gluing
};

struct DecouplingOptions {
  Separators separators = Separators::lattice;
  Encroaching encroaching = Encroaching::handed_back;
  double piece = 1;  ///< the length of pieces, in units of the longest that are safe beside vertices far enough away
  std::function<void(const DecouplingRecord&)> on_laid{};
  std::function<void(const DecouplingEnd&)> on_end{};
};

/// Errors: those of start_of(); `resources` if the mesh needs too many points. The mesh depends on the number of
/// workers.
[[nodiscard]] Result<Outcome> decoupling(const Problem& problem, const DecouplingOptions& options = {});

}  // namespace pardel::schemes
