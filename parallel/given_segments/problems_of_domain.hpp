// The problems of a domain whose points and segments are divided among ranks.
#pragma once

#include "../../core/part_of_points.hpp"
#include "../../core/ranks.hpp"
#include "../../core/result.hpp"
#include "../concurrency/threads.hpp"
#include "../given_points/local_delaunay.hpp"
#include "../given_points/own_points.hpp"

namespace pardel::engine {

/// Collective. For a domain that seems to have a problem: the first rank gathers all of it, and looks for all problems,
/// as find_problems() in one process. Done if there are none. `segments`: those that this rank has read; `rest`: holes
/// and regions.
[[nodiscard]] Status status_of_whole(const LocalDelaunay& delaunay, const OwnPoints& own,
                                     const PartOfSegments& segments, const Pslg& rest, bool convex_hull, Ranks& ranks,
                                     const Threads& threads);

}  // namespace pardel::engine
