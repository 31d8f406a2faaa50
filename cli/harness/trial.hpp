// One trial: a mesher run on a domain, and its verdict.
#pragma once

#include <filesystem>
#include <functional>

#include "../../core/goal.hpp"
#include "../../core/pslg.hpp"
#include "../../core/result.hpp"
#include "case.hpp"
#include "child_process.hpp"
#include "mesher.hpp"
#include "outcome.hpp"

namespace pardel::harness {

/// What stays the same from trial to trial.
struct Trials {
  Mesher mesher;
  double min_angle_deg = 20;
  double max_area_fraction = 0;  ///< area bound as a fraction of the bounding box's area; 0: none
  bool delaunay = true;          ///< see judge()
  Limits limits;
  std::function<bool()> stop;  ///< asked now and then; callable from several threads
};

[[nodiscard]] Goal goal_for(const Trials& trials, const Pslg& pslg);

/// Names of files in a trial's folder.
[[nodiscard]] std::filesystem::path input_in(const std::filesystem::path& folder);
/// DOMAIN.1.SUFFIX beside DOMAIN.poly: where Triangle writes without being told.
[[nodiscard]] std::filesystem::path output_in(const std::filesystem::path& folder, const Mesher& mesher);

/// Works in `folder`, which is made anew. An error is the harness's own (io, resources, cancelled); whatever the
/// mesher does is an outcome.
[[nodiscard]] Result<Outcome> try_mesher(const Trials& trials, const LatticeDomain& domain,
                                         const std::filesystem::path& folder);

}  // namespace pardel::harness
