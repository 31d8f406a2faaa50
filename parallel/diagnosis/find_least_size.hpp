// Finds a lower bound on the size of the mesh of a domain in its constrained Delaunay triangulation.
#pragma once

#include "../construction/domain_triangulation.hpp"
#include "../least_size.hpp"

namespace pardel::engine {

/// As pardel::least_size(). Precondition: nothing has been refined yet. O(n).
[[nodiscard]] LeastSize find_least_size(const DomainTriangulation& domain, double min_angle_deg, double min_edge,
                                        const Threads& threads);

}  // namespace pardel::engine
