// Finds the narrow places of a domain in its constrained Delaunay triangulation.
#pragma once

#include <vector>

#include "../conversion/domain_triangulation.hpp"
#include "../gaps.hpp"

namespace pardel::engine {

/// As pardel::find_gaps(). Precondition: nothing has been refined yet. O(n) if few triangles are narrow.
[[nodiscard]] std::vector<Gap> find_gaps(const DomainTriangulation& domain, const Threads& threads);

}  // namespace pardel::engine
