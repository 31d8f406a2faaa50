// One trial: runs a mesher on a domain and checks the result.
#pragma once

#include <filesystem>
#include <functional>

#include "../../core/goal.hpp"
#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "../../core/support/child_process.hpp"
#include "case.hpp"
#include "mesher.hpp"
#include "outcome.hpp"

namespace pardel::harness {

/// The parameters that all trials share.
struct Trials {
  Mesher mesher;
  double min_angle_deg = 20;
  double max_area_fraction = 0;  ///< area bound as a fraction of the bounding box's area; 0: none
  bool delaunay = true;          ///< see judge()
  ChildLimits limits;
  std::function<bool()> stop;  ///< called often, from several threads; true: stop all trials
};

[[nodiscard]] Goal goal_for(const Trials& trials, const Pslg& pslg);

/// The input file in a trial's folder.
[[nodiscard]] std::filesystem::path input_in(const std::filesystem::path& folder);
/// The output file: domain.1.SUFFIX in the folder of domain.poly. Triangle always chooses this name.
[[nodiscard]] std::filesystem::path output_in(const std::filesystem::path& folder, const Mesher& mesher);

/// Runs the mesher in `folder`, which is emptied first. An error (io, resources, cancelled) comes from the harness
/// itself; all failures of the mesher are outcomes.
[[nodiscard]] Result<Outcome> try_mesher(const Trials& trials, const LatticeDomain& domain,
                                         const std::filesystem::path& folder);

}  // namespace pardel::harness
