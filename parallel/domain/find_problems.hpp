// The search for all problems of a domain, as a part of a run.
#pragma once

#include <vector>

#include "../threads/threads.hpp"
#include "../validate.hpp"

namespace pardel::engine {

/// pardel::find_problems() as a part of a run. The threads replace options.threads and options.go_on. Throws Stopped if
/// the run has to end.
[[nodiscard]] std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options,
                                                 const Threads& threads);

/// The problems of a point set except duplicate points, of which the Delaunay triangulation finds the first one anyway.
/// The search for all of them takes a twentieth of the time of the triangulation. Precondition: is_point_set(pslg).
[[nodiscard]] std::vector<Problem> find_problems_but_duplicates(const Pslg& pslg, const Threads& threads);

/// Done, or the error that lists the problems. `convex_hull`: as ValidateOptions::convex_hull.
[[nodiscard]] Status check_valid(const Pslg& pslg, bool convex_hull, const Threads& threads);

}  // namespace pardel::engine
