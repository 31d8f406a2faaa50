// The triangles of a refined mesh that break the goal.
#pragma once

#include <functional>
#include <vector>

#include "../concurrency/threads.hpp"
#include "../criteria/criteria.hpp"
#include "../options.hpp"
#include "../report.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Lists the triangles that break the criteria, in ascending order, with the reason why each was not split.
/// `budget_reached`: the refinement ended at options.max_vertices. The triangulation is not changed. Runs on
/// one thread. O(n). `counts`: if given, only triangles for which it is true are listed.
///
/// If a rank does not hold all that the reason depends on, the reason is `precision`. If it does not hold the triangle
/// beyond a segment that decides whether a triangle breaks the criteria (Goal::conforming), the triangle is added to
/// `undecided`, if given, and is not listed.
[[nodiscard]] std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments,
                                                const Criteria& criteria, const Options& options, bool budget_reached,
                                                const Threads& threads = {},
                                                const std::function<bool(TriangleId)>& counts = {},
                                                std::vector<TriangleId>* undecided = nullptr);

}  // namespace pardel::engine
