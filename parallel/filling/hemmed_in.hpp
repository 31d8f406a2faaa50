// The triangles that cannot be split because of a patch.
#pragma once

#include <vector>

#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Lists, in ascending order, the triangles of a refined domain that should be split at a point that encroaches on the
/// border of a patch. Precondition: the refinement did not end early. The triangulation is not changed. Runs on one
/// thread. O(n).
[[nodiscard]] std::vector<TriangleId> hemmed_in(Triangulation& t, const DomainSegments& segments,
                                                const Criteria& criteria, const Options& options,
                                                const Threads& threads = {});

}  // namespace pardel::engine
