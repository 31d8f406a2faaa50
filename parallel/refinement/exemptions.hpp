// The triangles of a refined mesh that break the goal.
#pragma once

#include <functional>
#include <vector>

#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../report.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Lists the triangles that break the criteria, in ascending order, with the reason why each was not split.
/// `budget_reached`: the refinement ended at options.max_vertices. The triangulation is not changed. Runs on
/// one thread. O(n). `counts`: if given, only triangles for which it is true are listed.
///
/// If a rank does not hold all that the reason depends on, the reason is `precision`. For a conforming goal, it also
/// depends on the triangle beyond a segment whether a triangle breaks the criteria. If the rank does not hold the
/// former, and nothing else decides, the side is added to `undecided`, and the triangle is not listed. Precondition: a
/// rank passes `undecided`.
[[nodiscard]] std::vector<Exemption> exemptions(Triangulation& t, const DomainSegments& segments,
                                                const Criteria& criteria, const Options& options, bool budget_reached,
                                                const Threads& threads = {},
                                                const std::function<bool(TriangleId)>& counts = {},
                                                std::vector<EdgeRef>* undecided = nullptr);

/// The reason why a subsegment that is not Delaunay was not split; `precision` if a rank does not hold all that this
/// depends on.
[[nodiscard]] ExemptReason why_not_split(Triangulation& t, const DomainSegments& segments, const Criteria& criteria,
                                         const Options& options, EdgeRef side);

}  // namespace pardel::engine
