// How many triangles a mesh is going to have, before it is made.
#pragma once

#include "../concurrency/threads.hpp"
#include "../criteria/criteria.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The number of triangles that the bounds on size, of any kind, and the shapes of the triangles of the domain let
/// expect. Measured: within a factor of two for bounds on size. Narrow parts that a bound on angles has to fill are not
/// counted (find_least_size.hpp). The number of threads does not change the result. Precondition: nothing has been
/// refined yet. O(n), with at least 4096 and at most 16 n evaluations of a size.
[[nodiscard]] double expected_triangles(const Triangulation& t, const Criteria& criteria, const Threads& threads);

}  // namespace pardel::engine
