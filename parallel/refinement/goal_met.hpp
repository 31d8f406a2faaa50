// Tells if a mesh meets a goal before anything is refined.
#pragma once

#include <optional>
#include <vector>

#include "../options.hpp"
#include "../quality/criteria.hpp"
#include "../quality/exact_goal.hpp"
#include "../report.hpp"
#include "../threads/threads.hpp"
#include "../triangulation/domain_segments.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// If every triangle meets the goal or is exempt because of a small angle of the input: the exempt triangles in
/// ascending order. Otherwise nothing. `criteria` are those of `goal`. They are stricter, and the goal itself decides
/// about the triangles that break them: no refinement is needed for what the goal allows. Runs on one thread. O(n), and
/// less if a triangle breaks the goal.
[[nodiscard]] std::optional<std::vector<Exemption>> exemptions_if_met(const Triangulation& t,
                                                                      const DomainSegments& segments,
                                                                      const Criteria& criteria, const ExactGoal& goal,
                                                                      const Options& options,
                                                                      const Threads& threads = {});

}  // namespace pardel::engine
