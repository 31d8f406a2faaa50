// Problems of the domain as a whole: outline, holes and regions.
#pragma once

#include <vector>

#include "../../core/pslg.hpp"
#include "../segments/plane_sweep.hpp"
#include "../threads/threads.hpp"
#include "findings.hpp"

namespace pardel::engine {

/// The holes, then the seeds of the regions.
[[nodiscard]] std::vector<Point> seeds_of(const Pslg& pslg);

/// Adds unclosed_outline, no_domain, and the problems of holes and regions. `swept` is the sweep of the segments with
/// seeds_of(pslg) as queries. Precondition: points and segments have no problem. O(n log n).
void check_faces(const Pslg& pslg, bool convex_hull, const Swept& swept, const Threads& threads, Findings& found);

}  // namespace pardel::engine
