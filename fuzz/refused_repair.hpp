// When the repair of a domain may fail.
#pragma once

#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/repair.hpp"

namespace pardel::fuzz {

/// Fails if repair(pslg, options) must not have ended with this error. The reasons for which it may:
///   a coordinate or a cap that cannot be used;
///   no segments around an area (or, for a convex hull, all points on one line);
///   a hole in every face of the domain that is repaired without its holes and without snapping;
///   rounded crossings that make ever more crossings, if the caller set the distance zero. The repair that chooses its
///   distances itself must then succeed, which is more than repair.hpp promises.
/// Nothing is required if the caller set a distance greater than zero, which may be greater than the whole domain.
/// Precondition: no area is so small that rounded crossings can flatten it.
void check_refusal(const Pslg& pslg, const RepairOptions& options, const Error& error);

}  // namespace pardel::fuzz
