// The assessment of all triangles before the refinement begins.
#pragma once

#include <functional>

#include "../../core/array.hpp"
#include "../decomposition/lattice.hpp"
#include "../refinement/deferral.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// Estimates of the number of triangles of the final mesh.
struct TriangleEstimates {
  double without_angle_bound = 0;  ///< ignores the bound on angles; determines the size of the tiles
  double with_angle_bound = 0;     ///< the best estimate
  double lower_bound = 0;          ///< no mesh with fewer triangles keeps the bounds on area
};

struct InitialAssessment {
  TriangleEstimates estimates;
  Array<Deferred> bad;      ///< the triangles that have to be split or have an encroached edge, ascending
  bool left_alone = false;  ///< a triangle breaks the goal, but it may not or cannot be split
};

/// Assesses the triangles for which is_counted(id) is true, or all if it is empty. Precondition: the indices of these
/// are in use. O(n).
[[nodiscard]] InitialAssessment assess_all(const Triangulation& t, const Criteria& criteria, const Assessor& assessor,
                                           const Threads& threads,
                                           const std::function<bool(TriangleId)>& is_counted = {});

/// The expected number of triangles in the cell of the lattice in which an average triangle of the final mesh will lie,
/// divided by the average over all cells: 1 if the work is even. Precondition: all indices of triangles are in use.
/// O(n + cells).
[[nodiscard]] double overload(const Triangulation& t, const Criteria& criteria, const Assessor& assessor,
                              const Lattice& lattice, const Threads& threads);

}  // namespace pardel::engine
