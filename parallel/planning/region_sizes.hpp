// The edge lengths that regions of a domain ask for.
#pragma once

#include <span>

#include "../sizes.hpp"
#include "../threads/threads.hpp"

namespace pardel::engine {

/// As region_sizes() (sizes.hpp). `mesh`: a mesh of the domain with its regions, in which places are searched. Without
/// thin triangles, which many places are near to, a search takes O(log n). Preconditions: the Pslg is valid; there is
/// one length > 0 per region.
[[nodiscard]] Result<RegionSizes> sizes_of_faces(const Pslg& pslg, bool convex_hull, std::span<const double> lengths,
                                                 const Mesh& mesh, const Threads& threads);

}  // namespace pardel::engine
