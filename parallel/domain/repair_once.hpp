// Repair with given snapping distances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "../../core/support/stop_signal.hpp"
#include "../repair.hpp"
#include "../segments/snapping.hpp"

namespace pardel::engine {

/// The problems that repair() cannot remove. Both functions ask `stop`.
[[nodiscard]] std::vector<Problem> find_unusable_values(const Pslg& pslg, StopSignal& stop);

/// Where the holes and regions come from, and those that were dropped.
struct SeedRecord {
  std::vector<Index> hole_source, region_source;  ///< new hole or region -> old one
  std::vector<std::string> dropped;               ///< a sentence per old hole or region that was dropped
};

/// A repaired Pslg, which can be repaired further.
struct RepairStage {
  Repaired repaired;
  SeedRecord seeds;
};

/// As repair() with the snapping distances `snapping`. Nothing if splitting the segments where they meet makes ever
/// more crossings. `from`: an earlier stage of the same Pslg, which is repaired further; null: the Pslg itself. The
/// maps, the log and the distances are those from the Pslg to the result. Precondition: there are no unusable values.
[[nodiscard]] std::optional<Result<RepairStage>> repair_once(const Pslg& pslg, const Snapping& snapping,
                                                             bool convex_hull, StopSignal& stop,
                                                             const RepairStage* from = nullptr);

}  // namespace pardel::engine
