// A mesh that several ranks make of a domain that each of them has as a whole.
#pragma once

#include <functional>

#include "../../parallel/scheduling/progress_monitor.hpp"
#include "../distributed.hpp"

namespace pardel::engine {

using VisitPiece = std::function<Status(MeshPiece&& piece, int number)>;

/// As mesh_in_pieces() (distributed.hpp) for a valid Pslg. Collective. Throws Stopped if the run has to end.
[[nodiscard]] Status mesh_in_ranks(const Pslg& pslg, bool convex_hull, const Goal& goal, const Options& options,
                                   ProgressMonitor& progress, Ranks& ranks, int pieces, const VisitPiece& visit);

}  // namespace pardel::engine
