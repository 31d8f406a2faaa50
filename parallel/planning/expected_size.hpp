// How many triangles a mesh is going to have, before it is made.
#pragma once

#include "../quality/criteria.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// The number of triangles that the bounds on size, of any kind, and the shapes of the triangles of the domain let
/// expect. Measured: within a factor of two for bounds on size. Narrow parts that a bound on angles has to fill are not
/// counted (find_least_size.hpp). `min_edge`: as Options::min_edge; shorter edges are not expected. The number of
/// threads does not change the result. Precondition: nothing has been refined yet. O(n): thousands of evaluations of a
/// size, or at most 17 n.
[[nodiscard]] double expected_triangles(const Triangulation& t, const Criteria& criteria, double min_edge,
                                        const Threads& threads);

}  // namespace pardel::engine
