// Predicts how unevenly a lattice would divide the work.
#pragma once

#include "../concurrency/lattice.hpp"
#include "../concurrency/threads.hpp"
#include "../refinement/assessor.hpp"

namespace pardel::engine {

/// The expected number of triangles in the cell of the lattice in which an average triangle of the final mesh will lie,
/// divided by the average over all cells: 1 if the work is even. Precondition: all indices of triangles are in use.
/// O(n + cells).
[[nodiscard]] double overload(const Triangulation& t, const Criteria& criteria, const Assessor& assessor,
                              const Lattice& lattice, const Threads& threads);

}  // namespace pardel::engine
